#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/boxed_body.hpp"

namespace flying {

/// Finds the boxes that overlap by sweeping a line over them: only boxes that the line
/// touches at one time are compared. The order in which it meets them is kept from one look
/// to the next; where bodies have moved little, putting it right again takes hardly more
/// than a walk.
class Sweep
{
public:

    /// Line bodies up by the lower ends of their boxes, along the axis on which the middles
    /// of those that move are spread further. Which pairs are found depends on the boxes
    /// alone, not on what was lined up before.
    ///
    /// bodies  each id once; boxes may be infinite, but hold no NaN
    void line_up(std::span<const BoxedBody> bodies);

    /// The axis of the last look: 0 for x, 1 for y.
    [[nodiscard]] int axis() const { return axis_; }
    /// Places by which bodies were moved along the line, in all looks.
    [[nodiscard]] std::int64_t shifts() const { return shifts_; }

    /// Call visit(one, two) for every two spans of the line that share a place, the one
    /// that starts first in front. It returns true to go on, false to end the sweep.
    template <typename Visit>
    void for_each_side_by_side(Visit&& visit) const
    {
        for (std::size_t i = 0; i < line_.size(); ++i) {
            const Span one = line_[i];
            for (std::size_t k = i + 1; k < line_.size() && line_[k].low <= one.high; ++k) {
                if (!visit(one, line_[k])) return;
            }
        }
    }

    /// Call visit(a, b), ids with a < b, for every two bodies, not both static, whose boxes
    /// share a point, in the order of the line. It returns true to go on, false to end the
    /// sweep.
    template <typename Visit>
    void for_each_pair(Visit&& visit) const
    {
        for_each_side_by_side([&](const Span& one, const Span& two) {
            if (two.bottom > one.top || one.bottom > two.top) return true;
            if (one.is_static && two.is_static) return true;
            return visit(std::min(one.body, two.body), std::max(one.body, two.body));
        });
    }

private:

    /// A box as the line sees it: its ends along the line, and across.
    struct Span
    {
        double low = 0.0;    // [m]
        double high = 0.0;   // [m]
        double bottom = 0.0; // [m]
        double top = 0.0;    // [m]
        int body = 0;
        int member = 0; // its place in what was lined up
        bool is_static = false;
    };

    [[nodiscard]] Span span_of(const BoxedBody& body, int member) const;
    [[nodiscard]] static bool starts_before(const Span& one, const Span& two);
    [[nodiscard]] bool put_right();

    std::vector<Span> line_; // by lower end, then by id
    int axis_ = 0;
    std::int64_t shifts_ = 0;
};

} // namespace flying
