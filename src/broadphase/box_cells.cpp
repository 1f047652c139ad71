#include "broadphase/box_cells.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace flying {
namespace {

/// [m] So far out that a body is less than a rounding, all boxes may be one point.
constexpr double k_least_cell = std::numeric_limits<double>::min();

} // namespace

void BoxCells::sort(std::vector<Entry> entries)
{
    entries_ = std::move(entries);
    if (entries_.empty()) return;

    // Choose cells that a box of middling width fits into, and of which there are not many more than boxes
    const double count = static_cast<double>(entries_.size());
    double squares = 0.0;
    all_ = entries_.front().box;
    for (const Entry& entry : entries_) {
        all_.min = all_.min.cwiseMin(entry.box.min);
        all_.max = all_.max.cwiseMax(entry.box.max);
        squares += (entry.box.max - entry.box.min).squaredNorm();
    }
    const Vec2 size = all_.max - all_.min;
    const double longest = std::max(size.x(), size.y());
    const double middling = std::sqrt(squares / count);
    const double cell = std::max({middling, std::sqrt(size.x() * (size.y() / count)), longest / count, k_least_cell});
    per_length_ = 1.0 / cell;
    columns_ = 1 + static_cast<int>(size.x() * per_length_);
    rows_ = 1 + static_cast<int>(size.y() * per_length_);

    // Name each box to all cells that it reaches
    const auto each = [&](auto&& act) {
        for (int k = 0; k < static_cast<int>(entries_.size()); ++k) {
            const Place low = place_of(entries_[k].box.min);
            const Place high = place_of(entries_[k].box.max);
            for (int row = low.row; row <= high.row; ++row) {
                for (int column = low.column; column <= high.column; ++column) act(row * columns_ + column, k);
            }
        }
    };
    starts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    each([&](int number, int) { ++starts_[number + 1]; });
    for (std::size_t k = 1; k < starts_.size(); ++k) starts_[k] += starts_[k - 1];
    members_.resize(static_cast<std::size_t>(starts_.back()));
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    each([&](int number, int k) { members_[next[number]++] = k; });
}

} // namespace flying
