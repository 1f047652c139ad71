#pragma once

#include <span>
#include <vector>

#include "rest/contact_point.hpp"

namespace flying {

/// Sweeps where something is left to do, and nowhere else: over the pairs of which a point misses its bound, then over
/// those that come to miss theirs by that, and so on. Which they are depends on the points and their order alone.
class LocalSweeps
{
public:
    /// True once no point misses its bound by more than it may.
    ///
    /// movers   all bodies; to the impulses that the points have they have answered already
    /// points   those of one pair in a row
    /// allowed  for each point: by how much its normal velocity may be less than its bound, > 0 [m/s]
    /// most     pairs that may be swept, counting each as often as it is
    bool sweep(std::span<Mover> movers, std::span<ContactPoint> points, std::span<const double> allowed, int most);

private:
    /// The points of a pair.
    struct Run
    {
        int first = 0;
        int count = 0;
        bool waits = false; ///< to be swept
    };

    void list_runs(std::span<const Mover> movers, std::span<const ContactPoint> points);
    void look_at(int run, std::span<const Mover> movers, std::span<const ContactPoint> points,
                 std::span<const double> allowed);

    std::vector<Run> runs_;
    std::vector<int> number_;   // of each body that a point is of: 0 if it can't move
    std::vector<int> first_of_; // of each number, and one more: where the runs of that body begin in of_body_
    std::vector<int> of_body_;
    std::vector<int> queue_; // of runs
};

} // namespace flying
