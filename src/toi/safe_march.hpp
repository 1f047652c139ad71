#pragma once

#include <algorithm>
#include <cmath>

#include "math/safe_step.hpp"
#include "toi/gap_tolerance.hpp"

namespace flying {

/// A vertex against an edge at one moment.
struct EdgeReading
{
    double gap = 0.0;        ///< height of the vertex over the edge's line [m]
    double gap_rate = 0.0;   ///< [m/s]
    double along = 0.0;      ///< from the edge's start to the foot of the vertex [m]
    double along_rate = 0.0; ///< [m/s]
};

/// What bounds one search.
struct MarchBounds
{
    double bend = 0.0;   ///< on the second derivative of gap [m/s^2]
    double length = 0.0; ///< of the edge; infinite for a wall [m]
    double depth = 0.0;  ///< how far below the surface still counts as touching it; infinite
                         ///< where nothing is behind it [m]
    GapTolerance tolerance;
    double ends = 0.0;       ///< rounding of `along` [m]
    double along_bend = 0.0; ///< on the second derivative of along, which matters where there are ends [m/s^2]
};

/// The vertex is between the edge's ends, or past one by no more than the slack.  [m]
[[nodiscard]] inline bool is_over(const EdgeReading& now, const MarchBounds& bounds, double slack)
{
    return now.along >= -slack && now.along <= bounds.length + slack;
}

/// Depth to which the vertex counts as touching. Past an end, what lies deeper than the
/// tolerance has gone past the corner, outside or over the next edge.
[[nodiscard]] inline double lowest_touch(const EdgeReading& now, const MarchBounds& bounds)
{
    return is_over(now, bounds, bounds.ends) ? bounds.depth : bounds.tolerance.touch;
}

/// The vertex touches the edge.
[[nodiscard]] inline bool touches(const EdgeReading& now, const MarchBounds& bounds)
{
    const double slack = bounds.tolerance.touch;
    if (now.gap > slack || !is_over(now, bounds, slack)) return false;
    return now.gap >= -slack || now.gap >= -lowest_touch(now, bounds);
}

/// The vertex touches the edge and approaches: faster than rounding, or at all where it
/// lies so deep that to wait would let it sink.
[[nodiscard]] inline bool strikes(const EdgeReading& now, const MarchBounds& bounds)
{
    const bool is_deep = now.gap < -0.5 * bounds.tolerance.touch;
    const double slowest = is_deep ? 0.0 : -bounds.tolerance.approach;
    return touches(now, bounds) && now.gap_rate < slowest;
}

/// A step over which turning and falling change the gap by no more than a quarter of the tolerance.  [s]
[[nodiscard]] inline double graze_step(const MarchBounds& bounds)
{
    return bounds.bend > 0.0 ? std::sqrt(0.5 * bounds.tolerance.touch / bounds.bend) : k_never;
}

/// A step over which turning and falling change the approach by no more than its tolerance: the gap by far less than
/// its own.  [s]
[[nodiscard]] inline double approach_step(const MarchBounds& bounds)
{
    return bounds.bend > 0.0 ? bounds.tolerance.approach / bounds.bend : 0.0;
}

/// A step over which the vertex can't come to touch the edge. Each thing that keeps them apart
/// (height, or standing past one of the ends) holds for a while of its own, and the longest
/// counts. At least a small step is made where they touch without approach: one over which the
/// gap changes by less than the tolerance.
[[nodiscard]] inline double certain_step(const EdgeReading& now, const MarchBounds& bounds)
{
    const double slack = bounds.tolerance.touch;
    double step = 0.0;

    if (now.gap > 0.0) {
        step = safe_step(now.gap, now.gap_rate, bounds.bend);
    } else {
        const double below = -lowest_touch(now, bounds) - now.gap;
        if (below > 0.0) step = safe_step(below, -now.gap_rate, bounds.bend);
        else if (now.gap_rate > 0.0) step = safe_step(0.0, now.gap_rate, bounds.bend);
    }

    // [toi.certain-step.ends]
    const double before = -slack - now.along;
    const double beyond = now.along - bounds.length;
    if (before > 0.0) step = std::max(step, safe_step(before, -now.along_rate, bounds.along_bend));
    if (beyond > slack) step = std::max(step, safe_step(beyond - slack, now.along_rate, bounds.along_bend));
    // [toi.certain-step.ends]

    // [toi.certain-step.graze]
    const bool is_on_line = now.gap <= slack && now.gap >= -0.5 * slack;
    if (is_on_line && now.gap_rate >= -bounds.tolerance.approach) step = std::max(step, graze_step(bounds));
    // [toi.certain-step.graze]
    return step;
}

/// One of the things that keep vertex and edge apart does so for so long before and after, by more than the tolerance:
/// no march within that time would find a strike. No root is asked for.
[[nodiscard]] inline bool is_clear_within(const EdgeReading& now, const MarchBounds& bounds, double half)
{
    const double slack = bounds.tolerance.touch;
    const auto lasts = [&](double f, double f_rate, double bend) {
        return f - half * std::abs(f_rate) > 0.5 * bend * half * half + slack;
    };
    return lasts(now.gap, now.gap_rate, bounds.bend) || lasts(-bounds.depth - now.gap, now.gap_rate, bounds.bend) ||
           lasts(-slack - now.along, now.along_rate, bounds.along_bend) ||
           lasts(now.along - bounds.length - slack, now.along_rate, bounds.along_bend);
}

/// The vertex was above the edge and now lies too deep to touch it. A certain step doesn't lead
/// there, so only rounding can, where it is coarser than the tolerance: near a centre that a
/// body has passed closely.
[[nodiscard]] inline bool fell_through(const EdgeReading& before, const EdgeReading& now, const MarchBounds& bounds)
{
    if (now.gap >= -bounds.depth || before.gap <= 0.0 || now.gap_rate >= 0.0) return false;
    const double slack = bounds.tolerance.touch;
    return is_over(before, bounds, slack) && is_over(now, bounds, slack);
}

/// Where a march ended.
struct MarchEnd
{
    enum class Kind
    {
        none,
        strike,
        tired
    };
    Kind kind = Kind::none;
    double time = k_never; ///< of the strike, or up to which a tired march has seen nothing [s]
};

/// First strike of a vertex on an edge in [from, until), if it comes before `stop`. Steps don't depend on where it
/// stops.
///
/// first       the reading at `from`, taken already
/// read(time)  the reading at a moment of the world's clock
/// counts(time)  false where a strike is none: a neighbour hides what would be struck
/// The time found is at or before the root by no more than the rounding of the gap or of
/// the time.
template <typename Read, typename Counts>
[[nodiscard]] MarchEnd march(const EdgeReading& first, const Read& read, const MarchBounds& bounds, double from,
                             double until, double stop, const Counts& counts)
{
    constexpr int k_most_steps = 2000;
    EdgeReading now = first;
    double time = from;
    for (int k = 0; k < k_most_steps; ++k) {
        // [toi.march.step]
        if (!(time < std::min(until, stop))) return {};
        if (k > 0) {
            const EdgeReading before = now;
            now = read(time);
            if (fell_through(before, now, bounds)) return {MarchEnd::Kind::strike, time};
        }
        const double step = certain_step(now, bounds);
        double next = time + step;

        // [toi.march.deep]
        // What lies deeper and hardly rises is passed like a graze, but only where that doesn't sink it further. Where
        // it would, it's about to turn round: wait until it may approach by more than rounding
        if (now.gap < 0.0 && now.gap_rate >= 0.0 && touches(now, bounds)) {
            const double graze = std::min(time + graze_step(bounds), until);
            if (next < graze) next = read(graze).gap >= now.gap ? graze : std::max(next, time + approach_step(bounds));
        }
        // [toi.march.deep]

        // [toi.march.root]
        // Stop at a root: the gap, or the time, is at its last digit
        const bool at_root = now.gap <= bounds.tolerance.noise || next <= next_after(time);
        if (at_root && strikes(now, bounds)) {
            if (counts(time)) return {MarchEnd::Kind::strike, time};
            next = std::max(next, time - bounds.tolerance.touch / now.gap_rate);
        }

        time = std::max(next, next_after(time));
        // [toi.march.root]
        // [toi.march.step]
    }
    return {MarchEnd::Kind::tired, time};
}

/// The same where every strike counts.
template <typename Read>
[[nodiscard]] MarchEnd march(const EdgeReading& first, const Read& read, const MarchBounds& bounds, double from,
                             double until, double stop = k_never)
{
    return march(first, read, bounds, from, until, stop, [](double) { return true; });
}

} // namespace flying
