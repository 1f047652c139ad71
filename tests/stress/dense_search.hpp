#pragma once

#include <vector>

#include "toi/prediction.hpp"

/// A search for the first overlap of two flying bodies that shares nothing with the engine's: distances of every vertex
/// to every edge, sampled so densely that the surfaces can't meet between two samples.
namespace flying::stress {

/// A shape as this search knows it: a disc, a wall, or rings of vertices.
struct Outline
{
    struct Segment
    {
        Vec2 start = Vec2::Zero();
        Vec2 way = Vec2::Zero();
        double inv_length2 = 0.0;
    };

    enum class Kind { disc, wall, rings };
    Kind kind = Kind::disc;
    double radius = 0.0;             ///< of the disc, or of a circle that holds the rings [m]
    Vec2 normal = Vec2::Zero();      ///< of the wall
    double offset = 0.0;             ///< of the wall [m]
    std::vector<Vec2> vertices;      ///< of all rings
    std::vector<Segment> segments;
};

[[nodiscard]] Outline disc_outline(double radius);
[[nodiscard]] Outline wall_outline(const Vec2& normal, double offset);
[[nodiscard]] Outline rings_outline(const std::vector<std::vector<Vec2>>& rings);

/// Two bodies in flight. A wall comes second.
struct FlyingPair
{
    Outline a;
    Outline b;
    Flyer flyer_a;
    Flyer flyer_b;
};

/// Distance of the surfaces at a moment, or minus the depth of the deepest vertex (of the disc's centre, less the radius)
/// where they overlap.  [m]
[[nodiscard]] double gap_at(const FlyingPair& pair, double time);

/// The outlines' edges cross, or one lies within the other: slow, and sure.
[[nodiscard]] bool overlap_at(const FlyingPair& pair, double time);

/// What rounding leaves undecided about the pair at a moment, beside 1e-12 of the smaller body.  [m]
[[nodiscard]] double rounding_at(const FlyingPair& pair, double time);

struct DenseOptions
{
    double floor = 1e-6;  ///< [sizes of the smaller] no step is shorter than lets the surfaces come nearer by this much
    double depth = 1e-12; ///< [sizes of the smaller] of an overlap, beside rounding
};

struct DenseAnswer
{
    bool overlaps = false;
    double time = 0.0;  ///< of an overlap [s]
    double least = 0.0; ///< gap met [m]
    double least_time = 0.0;
    long samples = 0;
    bool gave_up = false; ///< too many samples
};

/// First overlap in [from, until): no overlap deeper than the floor can hide, and one shallower only between two samples
/// between which the gap has no single least value.
///
/// From a gap g, surfaces that approach at most at L can't meet within g / L: that is the step. Where g is below the
/// floor, the step is that of the floor, and every least of three samples is refined.
[[nodiscard]] DenseAnswer search_densely(const FlyingPair& pair, double from, double until, const DenseOptions& options = {});

/// Least gap of a pair that doesn't overlap in [from, until], and when it is least: the least sample, refined.  [m]
/// NaN where the bodies overlap, or where the search gave up.
[[nodiscard]] double least_gap(const FlyingPair& pair, double from, double until, double& when);

} // namespace flying::stress
