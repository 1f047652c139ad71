#include <cstdio>
#include <initializer_list>
#include <numbers>

#include "collide/manifold.hpp"
#include "collide/separating_axis.hpp"
#include "find_axis.hpp"
#include "shadows.hpp"

using namespace flying;

namespace {

constexpr double k_degree = std::numbers::pi / 180.0;


/// A square of side 1, and another turned by 30 degrees that comes from the right.
void bring_together()
{
    const Polygon square = box_of(1.0, 1.0);
    std::printf("distance   separation   edge   contacts\n");
    for (const double x : {2.0, 1.5, 1.25, 1.1, 0.9, 0.5, 0.0}) {
        const Pose a = placed(0.0, 0.0);
        const Pose b = placed(x, 0.0, 30.0 * k_degree);
        const Axis axis = greatest_separation(square, square, relative_pose(a, b));
        const Manifold manifold = make_manifold(square, a, square, b, 0.0);
        std::printf("%6.2f m %+10.4f m %4s %d %8d\n", x, axis.separation,
                    axis.owner == Owner::a ? "A" : "B", axis.edge, manifold.count);
    }
}



/// How many edges were tried before this one was found.
int tried(const Axis& found, const std::optional<Axis>& guess, int edges_of_a)
{
    const int in_order = found.owner == Owner::a ? found.edge + 1 : edges_of_a + found.edge + 1;
    if (!guess) return in_order;
    return found.owner == guess->owner && found.edge == guess->edge ? 1 : 1 + in_order;
}



/// A hexagon flies past an octagon and turns: a thousand looks, with and without memory.
void fly_past()
{
    const Polygon octagon = regular(8, 1.0);
    const Polygon hexagon = regular(6, 1.0);
    int without = 0;
    int with = 0;
    std::optional<Axis> last;
    for (int k = 0; k < 1000; ++k) {
        const Pose b = placed(-4.0 + 0.008 * k, -2.2, 0.003 * k);
        const std::optional<Axis> fresh = find_separating_axis(octagon, hexagon, b);
        const std::optional<Axis> again = find_separating_axis(octagon, hexagon, b, last);
        if (!fresh || !again) continue;
        without += tried(*fresh, std::nullopt, 8);
        with += tried(*again, last, 8);
        last = again;
    }
    std::printf("\nedges tried from the start = %d\n", without);
    std::printf("edges tried with a memory = %d\n", with);
}


} // namespace


int main()
{
    bring_together();
    fly_past();
}

