#pragma once

#include <span>
#include <vector>

#include "rest/heap_sweeps.hpp"
#include "rest/island.hpp"

namespace flying {

/// Takes off the overlap that a step would end with.
class Projection
{
public:
    /// How deep any two of an island overlap where the step ends; looked at only where they may. Of swept islands what
    /// is fair counts for nothing.  [breadths]
    [[nodiscard]] double measure_overlap(RestData& data, const Island& island);
    /// Moves bodies out of what they overlap there: the same conditions for places as for velocities, least by the
    /// masses, without friction. It adds no velocity. What is left then.  [breadths]
    /// overlap  as `measure_overlap` has just found it
    double put_apart(RestData& data, const Island& island, double overlap, HeapSweeps& sweeps);

private:
    void list_pairs_of(const RestData& data, std::span<const ContactPoint> points);
    [[nodiscard]] const RestPair& pair_at(const RestData& data, int index) const;
    [[nodiscard]] double find_overlap_of_pair(RestData& data, int index);
    void find_unforeseen(RestData& data, const Island& island);
    [[nodiscard]] double measure_overlap_of_heap(RestData& data, const Island& island);
    void push_by(RestData& data, std::span<const int> members, double share) const;
    [[nodiscard]] bool may_pay(const RestData& data, const Island& island, double lift) const;
    [[nodiscard]] double share_that_is_paid(const RestData& data, const Island& island) const;
    void find_pushes(RestData& data, const Island& island, double tolerance, HeapSweeps& sweeps);

    std::vector<ContactPoint> points_; // of the pairs that were looked at, as the step ends
    std::vector<int> pairs_near_;      // those pairs: of the list, and after them the unforeseen ones
    std::vector<RestPair> unforeseen_;
    std::vector<Mover> pushes_; // ways in place of velocities
    std::vector<Vec2> shift_before_;
    std::vector<double> turn_before_;
};

} // namespace flying
