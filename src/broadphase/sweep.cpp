#include "broadphase/sweep.hpp"

namespace flying {
namespace {

/// The axis along which the middles of the bodies that move are spread further: 0 for x,
/// 1 for y.
[[nodiscard]] int longer_axis(std::span<const BoxedBody> bodies)
{
    Aabb spread;
    bool any = false;
    for (const BoxedBody& body : bodies) {
        if (body.is_static) continue;
        const Vec2 twice = body.box.min + body.box.max;
        if (any) spread = {spread.min.cwiseMin(twice), spread.max.cwiseMax(twice)};
        else spread = {twice, twice};
        any = true;
    }
    const Vec2 size = spread.max - spread.min;
    return size.x() >= size.y() ? 0 : 1;
}

} // namespace

Sweep::Span Sweep::span_of(const BoxedBody& body, int member) const
{
    const Aabb& box = body.box;
    const int across = 1 - axis_;
    return {box.min[axis_], box.max[axis_], box.min[across], box.max[across],
            body.body,      member,         body.is_static};
}

bool Sweep::starts_before(const Span& one, const Span& two)
{
    return one.low != two.low ? one.low < two.low : one.body < two.body;
}

void Sweep::line_up(std::span<const BoxedBody> bodies)
{
    // Start from the order of the last look, if there is one
    const int axis = longer_axis(bodies);
    const bool is_known = axis == axis_ && line_.size() == bodies.size();
    axis_ = axis;
    if (!is_known) {
        line_.resize(bodies.size());
        for (std::size_t k = 0; k < line_.size(); ++k)
            line_[k].member = static_cast<int>(k);
    }

    // [sweep.line_up.sort]
    // Find where every body is by now
    for (Span& span : line_) {
        span = span_of(bodies[static_cast<std::size_t>(span.member)], span.member);
    }

    // No two spans are equal, so that there is one order, however it is found
    if (!is_known || !put_right()) std::sort(line_.begin(), line_.end(), starts_before);
    // [sweep.line_up.sort]
}

/// Let each box step back past those that start later. False, and no order, where that is
/// not over soon: then so much has changed that sorting afresh is cheaper.
bool Sweep::put_right()
{
    constexpr std::size_t k_most_places = 8; // of a body, on average
    std::size_t left = k_most_places * line_.size();
    for (std::size_t i = 1; i < line_.size(); ++i) {
        const Span span = line_[i];
        std::size_t k = i;
        for (; k > 0 && starts_before(span, line_[k - 1]) && left > 0; --k, --left) {
            line_[k] = line_[k - 1];
            ++shifts_;
        }
        line_[k] = span;
        if (left == 0) return false;
    }
    return true;
}

} // namespace flying
