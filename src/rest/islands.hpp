#pragma once

#include <span>
#include <vector>

#include "rest/island.hpp"

namespace flying {

/// The step may take a body further than an overlap that matters.
[[nodiscard]] bool goes_far(const RestData& data, int body);
/// Two bodies of which neither goes far bear on each other at a point, or may come to within the step.
/// fall  how fast they may begin to near each other [m/s^2]
[[nodiscard]] bool holds(const RestData& data, const ContactPoint& point, double fall);

/// Splits bodies and the points between them into islands, each in the order of its bodies and pairs.
class Islands
{
public:
    /// bodies  those that are awake, ascending
    /// found   their points in the order of the pairs; used up
    void split(const RestData& data, std::span<const int> bodies, std::vector<ContactPoint>& found);

    /// What the last split has found, until the next.
    [[nodiscard]] std::span<Island> all() { return islands_; }
    [[nodiscard]] std::size_t point_count() const { return points_.size(); }

private:
    [[nodiscard]] int root_of(int body);
    bool join(const ContactPoint& point);
    void count(const StepMotion& motion, std::span<const int> bodies, std::span<const ContactPoint> found);
    void lay_out(std::span<const int> bodies, std::vector<ContactPoint>& found);
    [[nodiscard]] bool is_row(const StepMotion& motion, const Island& island);
    void part_slow(const RestData& data, std::span<const int> bodies, std::vector<ContactPoint>& found);

    std::vector<Island> islands_;
    std::vector<int> members_;              // by islands
    std::vector<ContactPoint> points_;      // by islands
    std::vector<int> parent_;               // of each body, towards the lowest of its island
    std::vector<int> slot_;                 // of each such lowest body, the number of its island
    std::vector<int> slots_;                // of each point that was found, the same
    std::vector<std::size_t> first_member_; // of each island, and the number of all at the end
    std::vector<std::size_t> first_point_;
    std::vector<std::size_t> next_; // of each island, where the next one goes
    std::vector<int> parts_;        // bodies of islands that may part
    std::vector<char> is_inside_;
};

} // namespace flying
