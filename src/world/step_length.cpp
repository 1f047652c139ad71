#include "world/step_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "world/reach_in_step.hpp"

namespace flying {
namespace {

/// [steps] A step that would be shorter is joined to the next.
constexpr double k_shortest = 0x1p-20;

/// [sizes] The way of a body in one step: no more, if few enough halvings of the step do it.
constexpr double k_way = 0x1p-1;
constexpr int k_most_halvings = 10;

/// [sizes] A body that leans may fall so far before it is asked again how fast it is. With a half, stars of 1 cm are
/// found in each other by a fourteenth of their size.
constexpr double k_fall = 0x1p2;

} // namespace

double next_end(double step, double time, int halvings)
{
    const double h = std::ldexp(step, -halvings);
    double count = std::floor(time / h) + 1.0;
    while (count * h - time < k_shortest * h) count += 1.0;
    return count * h;
}

bool ends_whole_step(double step, double time)
{
    return time == std::round(time / step) * step;
}

double length_of_step(double step, double from, double end)
{
    for (double h = step; h > 0.75 * (end - from); h *= 0.5) {
        const double count = std::round(from / h);
        if (from == count * h && end == (count + 1.0) * h) return h;
    }
    return end - from;
}

double pace_of(const BodyState& state, const Shape& shape, double radius, const Field& field)
{
    const auto* central = std::get_if<CentralField>(&field);
    double size = radius;
    if (central) size = std::min(size, (state.position - central->centre).norm()); // the field changes as fast
    const double after_fall = std::sqrt(2.0 * greatest_pull(field, state.position) * (k_fall * radius));
    const double pace = std::max(state.velocity.norm(), after_fall) / size;
    // A turn leaves a disc where it is
    const double most = std::holds_alternative<Disc>(shape) ? pace : std::numeric_limits<double>::infinity();
    return pace + std::min(std::abs(state.spin), most);
}

int halvings_for(double step, double pace)
{
    int halvings = 0;
    for (double way = pace * step; way > k_way && halvings < k_most_halvings; way *= 0.5) ++halvings;
    return halvings;
}

} // namespace flying
