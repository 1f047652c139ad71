#pragma once

#include "math/tolerance.hpp"

/// The pure numbers of the resting integrator, each with its unit and its reason.
namespace flying::rest_tolerance {

/// [speeds of an island, or those that its impulses bring] What rounding leaves of the residual of a point: a velocity
/// is a sum of a handful of impulses over a mass.
inline constexpr double k_residual = 16.0 * tolerance::k_epsilon;

/// [k_residual] A solve that no longer gets better is at rounding if it is no further than this: sums are longer where
/// bodies have many contacts.
inline constexpr double k_stagnant = 16.0;

/// [1/k] Stiffness of a bearing point against the inertia it moves. A compliance of this size in a stack of 10^4 bodies
/// is below a hundredth of the stack's own; corrections take what it leaves to rounding.
inline constexpr double k_stiffness = 0x1p32;

/// [speeds that the field gives in a step] Slower is still: what the solve leaves of an island that nothing moves, with
/// room; and a third of what a slope of 1 : 2 gives that is 1e-10 too steep. Slip below this has ended.
inline constexpr double k_still = 0x1p-36;

/// [speeds that the field gives in a step] A slower approach that brings no rebound is left to the load, of which it is
/// a thousandth; a faster slip is a slide. [greatest speeds] Rounding brings nothing faster to rest. [energies of fall]
/// Sweeps whose changes are worth less are enough. [steps] A cut so near to another would show nothing new.
inline constexpr double k_blow = 0x1p-10;

/// [steps] What closes so soon closes now: less than it takes to pass a gap of 1e-9 m, so that each ball of a row is
/// struck in its turn. What closes so late is left to the next step.
inline constexpr double k_at_once = 0x1p-32;

/// [sine] Normals of static contacts this near to each other lead the same way.
inline constexpr double k_same_normal = 0x1p-10;

/// [sizes] Gaps below this, of either sign, are contact.
inline constexpr double k_touch = 0x1p-40;

/// [sizes] A gap this small at the moment that was foreseen for its closing is closed, and beside a blow to the same
/// two bodies. The kink between two facets of a bowl opens less than a hundred times that over the length of a facet,
/// where there are some thousands of them.
inline constexpr double k_closed = 0x1p-20;

/// [sizes] What is this near, and won't be thrown back, has landed: otherwise each blow to a heap would be followed by
/// dozens at gaps that a microscope doesn't show. A block that rocks strikes so much too early, and with sixteen
/// times as much its spin is off by 6e-7.
inline constexpr double k_landed = 0x1p-28;

/// [sizes] Reach beyond what motion explains, within which points are watched. Points of two looks this near to each
/// other are one, whatever the names of their features.
inline constexpr double k_watch = 0x1p-6;

/// [breadths] Overlap that matters: where a step ends with more, it is made in halves; a pair that begins with more is
/// put right first, without a look ahead; parts that had no point are looked at where two come nearer by more; and
/// sweeps may add half as much in one step of a heap that stands. A fifth of the hundredth that a user is promised.
inline constexpr double k_fair_overlap = 0x1p-9;

/// [breadths] Overlap that the step of a heap may leave, and a meeting that nothing foresaw; where it is more, or
/// pushes leave half of it, the step is made in halves, or again. Sweeps may add as much where a heap moves, and pushes
/// that take off more need not be paid for. Three quarters of what a user is promised.
inline constexpr double k_most_overlap = 0x1p-7;

/// [energies, distances, speeds] Rise that rounding explains; and by how much separations, or approaches, that are
/// compared may be off.
inline constexpr double k_rounding = 0x1p-46;

/// Rounds of what ends by itself after a few, or never: impacts at one moment, and corrections of what rounding leaves.
/// Elastic bodies packed between walls would go on for ever.
inline constexpr int k_patience = 64;

/// Rounds of what is right after one or two, or after many: Newton's steps; looks at a pair that closes, each at the
/// moment that the last one foresaw; lines along curved ways; ends of slips in one step, and halvings of it until all
/// slips last; halvings of pushes until they help; parts into which the step of a heap may fall; steps that are made
/// again since bodies met; and rounds by turns in which all points do what they did, before a search begins again from
/// where they lead.
inline constexpr int k_quick_rounds = 8;

/// Rounds of what is near after two or three: pushes that take off overlap, each of which leaves about the square of
/// what it found; what Newton's method may take beyond k_quick_rounds; for each point, pieces of a path that begins with
/// nothing; and for each body of the largest island that is solved whole, points of the largest one in which such a path
/// is followed.
inline constexpr int k_few_rounds = 4;

/// Bodies of the largest island that is followed in detail: the end of each slip, the moment of each impact. In larger
/// ones all that a step brings comes at its start, unless each body leans on hardly more than one other. So many points
/// that move are followed along curved ways, in an island of any size.
inline constexpr int k_most_in_detail = 12;

// ---- Points of outlines (outline_points)
/// [cosine] Normals that differ by more are those of different faces.
inline constexpr double k_one_face = 0.75;

// ---- Pairs (pair_list)
/// [reaches] Room that the box of a body gets: more room, fewer searches and more pairs. A step that leads further may
/// be made in halves.
inline constexpr double k_room_reaches = 3.0;

// ---- Curved ways (curved_ways)
/// [1, or sizes] A line of push that changes by less within a step is straight. Without it rounding would say which
/// lines bend, and a run that is resumed would take other ways.
inline constexpr double k_straight = 0x1p-36;

// ---- Contact forces (contact_forces)
// [rest.solve.limits]
/// Bodies of the largest island that is solved whole however it moves, and whatever it takes, and whose step may be
/// made in parts; more are a heap.
inline constexpr int k_most_whole = 64;

/// [speeds that the field gives in a step] A large island that moves no faster stands, or begins to fall; its overlap
/// is left as it is, since pushes would shake it.
inline constexpr double k_standing = 4.0;
// [rest.solve.limits]

// ---- Parts of steps (rest_step)
/// Parts of the step of a small island, each up to its next impact; and equal ones, where halves are needed. A ball
/// that rolls through a bowl of facets takes three for every kink, of which there are dozens in a step. A row in which
/// nothing is lost gets as many for each body: a blow to 250 unequal balls makes 20 000 impacts in a step.
inline constexpr int k_most_parts = 256;

/// Looks, in such parts, at pairs that both move, of an island that loses energy: as many as a dozen bodies of one
/// piece each can need. Of a dozen with many teeth each two are several pairs; what impacts come after that have no
/// moments of their own, as in a heap. (A heap that is followed like this has k_few_sweeps * k_most_whole looks.)
inline constexpr int k_most_looks = 66 * k_most_parts;

// ---- Heaps (heap_sweeps)
/// [speeds that the field gives in a step] An island that was slower and stays so is at rest: what it was about to do
/// is the price of its sleep. From rest, what accelerates by no more than this share of the field doesn't start.
inline constexpr double k_rest_speed = 0x1p-8;

/// [masses] Of the heaviest body of a heap to the lightest: where it is more, sweeps hardly get on. Alternating
/// directions settle such a heap before sweeps do, and its step is made in halves rather than pushed out of an overlap.
/// What is lighter than this part of the heaviest body gets stiffer springs than its own inertia asks for.
inline constexpr double k_unequal_masses = 0x1p10;

/// Stiffness of the springs of alternating directions, against the inertia that a point moves, and against that which
/// points move on average: against the geometric mean of both. The stiffer, the further a load gets in a round; with
/// 512, friction no longer follows it.
inline constexpr double k_soft_stiffness = 128.0;

/// Over-relaxation of alternating directions: of the way to where a round leads, that much is gone. From 1.5 to 1.8 is
/// usual (Boyd et al. 2011, 3.4.3).
inline constexpr double k_over_relaxation = 1.6;

/// Sweeps that go on where more is left, as many pairs as these would sweep; rounds of alternating directions; and
/// pieces of a path that begins near its end.
inline constexpr int k_more_sweeps = 128;

/// Rounds of impacts in a heap, for each pair; sweeps that end what is left of them, and that take off its overlap;
/// those that go on in large heaps, and the rounds of alternating directions where they don't end.
/// What stood gets as many times the rounds of what moves: 2048 are enough for bricks of which some weigh a thousand
/// times as much as others; like ones take some fifty.
inline constexpr int k_few_sweeps = 16;

} // namespace flying::rest_tolerance
