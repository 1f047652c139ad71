#pragma once

#include <span>
#include <vector>

#include "rest/body_set.hpp"
#include "rest/rest_data.hpp"

namespace flying {

/// A body as a step has found it.
struct BodyBefore
{
    BodyState state;
    Vec2 pull = Vec2::Zero();
    double expected_angular_acceleration = 0.0;
    double reach = 0.0; ///< how far it was thought to get; 0 once a part took it further than was thought of that [m]
    double looked_for = 0.0; ///< how far it was thought to get when all was last looked at [m]
    double thrown_at = 0.0;  ///< since when it may get further than that; infinite for never [s]
    int island = 0;          ///< its lowest body
    char in_large_island = 0;
    bool is_parted = false; ///< it has made the step in parts
};

/// How far a step has taken any point of a body.  [m]
[[nodiscard]] double way_since(const RestData& data, const BodyBefore& before, int body);

/// Meetings that a step didn't foresee: bodies that were thrown further than they were thought to get, or made their
/// step in parts, now overlap what they were not thought to meet.
struct Meetings
{
    std::vector<double> moments; ///< after the start of the step, ascending [s]
    std::vector<int> islands;    ///< the lowest bodies of the islands that met, ascending, some more than once
    std::vector<int> sleepers;   ///< bodies that were met in their sleep
};
/// Adds those that there are now, and the first of their moments. True where there are any.
/// pairs   that may have met
/// before  of each body that the step has moved
[[nodiscard]] bool find_meetings(const RestData& data, std::span<const RestPair> pairs,
                                 std::span<const BodyBefore> before, const BodySet& moved, Meetings& met);

} // namespace flying
