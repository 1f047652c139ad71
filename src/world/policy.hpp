#pragma once

namespace flying {

/// Which integrator may have bodies. Automatic: the event-driven one; bodies whose impacts crowd together without end, and
/// those about them, are the resting one's for as long as they lean on something.
enum class EngineChoice { automatic, events, rest };

/// What moves a body at a moment.
enum class BodyMover
{
    none,   ///< it is static
    events, ///< it flies: from impact to impact
    rest,   ///< it leans on something, and is moved by steps
    asleep  ///< it leans on something, and a step has left it as it was
};

} // namespace flying
