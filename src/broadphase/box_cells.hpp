#pragma once

#include <algorithm>
#include <vector>

#include "geometry/aabb.hpp"

namespace flying {

/// Boxes sorted into cells, to be asked for those that share a point with another box, or with each other.
///
/// Cells are about as wide as the boxes, and no more than twice as many: work grows with the number of boxes, unless a
/// few are much larger than the rest.
class BoxCells
{
public:
    struct Entry
    {
        Aabb box; ///< finite
        int body = -1;
    };

    /// Forget what was there before, and sort these.
    void sort(std::vector<Entry> entries);
    void clear() { sort({}); }

    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

    /// Call visit(entry) for every entry whose box shares a point with this one, some of them more than once. It returns
    /// true to go on, false to end the search. True where it never ended it.
    template <typename Visit>
    bool visit_all_at(const Aabb& box, Visit&& visit) const
    {
        if (entries_.empty() || !overlap(box, all_)) return true;
        const Place low = place_of(box.min);
        const Place high = place_of(box.max);
        for (int row = low.row; row <= high.row; ++row) {
            for (int column = low.column; column <= high.column; ++column) {
                const int cell = row * columns_ + column;
                for (int k = starts_[cell]; k < starts_[cell + 1]; ++k) {
                    const Entry& entry = entries_[members_[k]];
                    if (overlap(entry.box, box) && !visit(entry)) return false;
                }
            }
        }
        return true;
    }

    /// Call visit(one, two) once for every two entries whose boxes share a point.
    template <typename Visit>
    void for_each_pair(Visit&& visit) const
    {
        if (entries_.empty()) return;
        for (int cell = 0; cell < columns_ * rows_; ++cell) {
            for (int i = starts_[cell]; i < starts_[cell + 1]; ++i) {
                const Entry& one = entries_[members_[i]];
                for (int k = i + 1; k < starts_[cell + 1]; ++k) {
                    const Entry& two = entries_[members_[k]];
                    if (!overlap(one.box, two.box)) continue;
                    // Two may meet in several cells; one of them holds the lower left corner of what they share
                    const Place corner = place_of(one.box.min.cwiseMax(two.box.min));
                    if (corner.row * columns_ + corner.column == cell) visit(one, two);
                }
            }
        }
    }

private:
    struct Place
    {
        int column = 0;
        int row = 0;
    };
    /// The cell of a point; of one outside all boxes, the nearest.
    [[nodiscard]] Place place_of(const Vec2& point) const
    {
        const Vec2 cells = (point - all_.min) * per_length_;
        return {static_cast<int>(std::clamp(cells.x(), 0.0, columns_ - 1.0)),
                static_cast<int>(std::clamp(cells.y(), 0.0, rows_ - 1.0))};
    }

    std::vector<Entry> entries_;
    Aabb all_;                // holds all boxes
    double per_length_ = 0.0; // cells [1/m]
    int columns_ = 1;
    int rows_ = 1;
    std::vector<int> starts_;  // of each cell, and the end
    std::vector<int> members_; // entries by cells
};

} // namespace flying
