#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "all_pairs.hpp"
#include "broadphase/grid.hpp"
#include "broadphase/sweep.hpp"
#include "math/random.hpp"

// Boxes in random places, and every way of this chapter to find those that overlap.
namespace flying {

using Pairs = std::vector<std::pair<int, int>>;


/// Discs of radius R at random places of a room, by their boxes.
inline std::vector<BoxedBody> discs_in_room(int n, double R, double W, double H,
                                            Random& random)
{
    std::vector<BoxedBody> bodies;
    for (int k = 0; k < n; ++k) {
        const Vec2 x{random.uniform(0.0, W), random.uniform(0.0, H)};
        bodies.push_back({k, false, {x - Vec2(R, R), x + Vec2(R, R)}});
    }
    return bodies;
}



inline Pairs pairs_of_all(std::span<const BoxedBody> bodies)
{
    Pairs pairs;
    for_each_pair_of_all(bodies, [&](int a, int b) { pairs.emplace_back(a, b); });
    return pairs;
}



inline Pairs pairs_of_sweep(const Sweep& sweep)
{
    Pairs pairs;
    sweep.for_each_pair([&](int a, int b) {
        pairs.emplace_back(a, b);
        return true;
    });
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}



/// Middle of a box.
inline Vec2 middle(const Aabb& box)
{
    return 0.5 * (box.min + box.max);
}

/// The pairs that a grid finds, and how many it compares to find them. Moving bodies lie in
/// the cells of their middles; static ones are listed in all cells near them.
struct GridLook
{
    Pairs pairs;
    long compared = 0;
};

inline GridLook pairs_of_grid(const Grid& grid, std::span<const BoxedBody> bodies)
{
    GridLook look;
    const auto compare = [&](int a, int b) {
        ++look.compared;
        if (overlap(bodies[a].box, bodies[b].box))
            look.pairs.emplace_back(std::min(a, b), std::max(a, b));
    };
    for (const BoxedBody& body : bodies) {
        if (body.is_static) continue;
        grid.for_each_near(grid.cell_of(body.body), [&](int other) {
            if (other > body.body) compare(body.body, other);
        });
        for (const int other : grid.statics_near(grid.cell_of(body.body)))
            compare(body.body, other);
    }
    std::sort(look.pairs.begin(), look.pairs.end());
    return look;
}



/// The grid that the engine would make for these bodies, with all of them in it. `radius`
/// is that of the largest bounding circle of those that move.
inline Grid filled_grid(std::span<const BoxedBody> bodies, double radius)
{
    Aabb extent;
    int movers = 0;
    for (const BoxedBody& body : bodies) {
        if (body.is_static) continue;
        const Vec2 x = middle(body.box);
        extent =
            movers == 0 ? Aabb{x, x} : Aabb{extent.min.cwiseMin(x), extent.max.cwiseMax(x)};
        ++movers;
    }
    Grid grid = make_grid(extent, radius, static_cast<int>(bodies.size()), movers);
    for (const BoxedBody& body : bodies) {
        if (body.is_static) grid.insert_static(body.body, body.box, radius);
        else grid.insert(body.body, grid.cell_at(middle(body.box)));
    }
    return grid;
}


} // namespace flying
