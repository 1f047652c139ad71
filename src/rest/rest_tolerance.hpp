#pragma once

#include "math/tolerance.hpp"


/// The pure numbers of the resting integrator, each with its unit and its reason.

namespace flying::rest_tolerance {


/// [speeds of a group, or those that its impulses bring] What rounding leaves of the content of a point: a velocity is
/// a sum of a handful of impulses over a mass.
inline constexpr double k_content = 16.0 * tolerance::k_epsilon;

/// [k_content] A solve that no longer gets better is at rounding if it is no further than this: sums are longer where
/// bodies have many contacts.
inline constexpr double k_stagnant = 16.0;

/// [1/k] Stiffness of a bearing point against the inertia it moves. A compliance of this size in a stack of 10^4 bodies
/// is below a hundredth of the stack's own; corrections take what it leaves to rounding.
inline constexpr double k_stiffness = 0x1p32;

/// [speeds that the field gives in a step] Slower is still: what the solve leaves of a group that nothing moves, with
/// room; and a hundredth of what a slope gives that is 1e-9 too steep.
inline constexpr double k_still = 0x1p-36;

/// [speeds that the field gives in a step] Slip below this has ended.
inline constexpr double k_slip = 0x1p-34;

/// [pairs per body] A stack on a floor has one, a pyramid nearly two. Up to here one body in sixteen leans on a second one,
/// and eliminating along the stack fills in few blocks.
inline constexpr double k_tall = 17.0 / 16.0;

/// [speeds that the field gives in a step] A slower approach is left to the load, of which it is a thousandth.
inline constexpr double k_blow = 0x1p-10;

/// [steps] What closes so soon closes now.
inline constexpr double k_at_once = 0x1p-20;

/// [sine] Normals of static contacts this near to each other lead the same way.
inline constexpr double k_same_normal = 0x1p-10;

/// [sizes] Gaps below this, of either sign, are contact.
inline constexpr double k_touch = 0x1p-40;

/// [sizes] A gap this small at the moment that was foreseen for its closing is closed.
inline constexpr double k_closed = 0x1p-16;

/// [sizes] Points of two looks this near to each other are one, whatever the names of their features.
inline constexpr double k_same_place = 0x1p-5;

/// [sizes] Reach beyond what motion explains, within which points are watched.
inline constexpr double k_watch = 0x1p-6;

/// [sizes] Overlap at the end of a step that is taken off; where it is more, the step is made in halves, and where these
/// don't help, ways are cut short. A fifth of the hundredth that a user is promised.
inline constexpr double k_fair_overlap = 0x1p-9;

/// [energies] Rise that rounding explains.
inline constexpr double k_rounding = 0x1p-46;


} // namespace flying::rest_tolerance
