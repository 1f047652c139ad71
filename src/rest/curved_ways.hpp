#pragma once

#include <vector>

#include "rest/island.hpp"

namespace flying {

/// Islands of which few lines of push turn within a step are solved along the ways that they go: to the second order of
/// the step, with no gap or overlap at its end. In others the lines of halfway stand for all of the way.
class CurvedWays
{
public:
    /// Finds ways, velocities and impulses along curves from those of straight lines, where lines bend; else leaves all
    /// as it is. True where it found them.
    bool follow(RestData& data, Island& island);

    /// When, on the ways that were found, the first slip ends; 0 where none does. By how much full friction would have
    /// turned it round, at one point by itself, tells; what is left of it ends in the part that comes next.  [s]
    [[nodiscard]] double end_of_slip(const RestData& data, const Island& island) const;

    /// Where none were found since a point that bears lets go on the way, and there may be more parts of the step.
    [[nodiscard]] bool lets_go() const { return lets_go_; }

    /// Few enough of its points move for that, whatever rests around them.
    [[nodiscard]] static bool may_follow(const RestData& data, const Island& island);

    /// Elsewhere, what bears pushes along the line that it will have halfway, by the velocities at the start: Moreau's
    /// midpoint rule. Along the line of the start, what rolls or rocks would swing ever further.
    void take_lines_halfway(RestData& data, Island& island);

private:
    /// Of the lines of the points that bear, or may come to, while bodies go their ways.
    enum class Bend : char
    {
        none,
        some,
        lost
    };
    [[nodiscard]] Bend bend_lines(RestData& data, const Island& island, bool is_corrected);
    void look_along(RestData& data, const Island& island, double part, std::vector<ContactPoint>& there);
    [[nodiscard]] bool find_mean_velocities(RestData& data, const Island& island);
    [[nodiscard]] bool see_ends(RestData& data, const Island& island);
    [[nodiscard]] bool all_close(const RestData& data) const;
    [[nodiscard]] bool end_velocities(RestData& data, Island& island);

    std::vector<ContactPoint> bent_;   // points with the mean of their lines over the step,
    std::vector<ContactPoint> half_;   // those halfway,
    std::vector<ContactPoint> end_;    // and those at its end
    std::vector<char> is_seen_;        // halfway and at the end
    std::vector<ContactPoint> at_end_; // of those at the end, the ones that bear
    std::vector<Mover> straight_;      // bodies as straight lines leave them
    bool lets_go_ = false;
};

} // namespace flying
