#pragma once

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "../11-coming-to-rest/column.hpp"
#include "../support/lying_bodies.hpp"
#include "math/block_system.hpp"
#include "math/random.hpp"
#include "rest/sweep_batches.hpp"

/// Heaps, and what it takes to find their forces.
namespace flying::test {

/// Discs over a pit that is 12 m wide, in rows that are not quite even, each from 0.3
/// to 0.5 m in radius. The floor comes first, then the two walls.
inline std::vector<RestBody> over_a_pit(int count)
{
    const Material material{0.0, 0.5};
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material), wall(Vec2(1.0, 0.0), -6.0, material),
                                    wall(Vec2(-1.0, 0.0), -6.0, material)};
    Random random(1701);
    for (int k = 0; k < count; ++k) {
        const double r = random.uniform(0.3, 0.5);
        const double aside = random.uniform(-0.03, 0.03);
        const Vec2 place(-5.4 + 1.08 * (k % 11) + aside, 0.6 + 1.08 * (k / 11));
        bodies.push_back(disc(r, place, r * r, material));
    }
    return bodies;
}

/// The disc rolls along the level floor, as one may in a hollow of the heap: no law here ever stops it.
inline bool rolls(const RestEngine& engine, int disc)
{
    const BodyState& s = engine.body(disc).state;
    const double slip = s.velocity.x() + s.position.y() * s.spin; // its centre is as high as its radius
    return s.velocity.y() == 0.0 && std::abs(slip) < 1e-4 * std::abs(s.velocity.x());
}

/// Steps until all discs sleep, but for those that roll; or so long.  [s]
inline double time_to_sleep(RestEngine& engine, double longest)
{
    while (engine.time() < longest) {
        engine.step();
        int awake = 0;
        for (int k = 0; k < engine.body_count(); ++k) {
            if (!engine.body(k).is_static && !engine.is_asleep(k) && !rolls(engine, k)) ++awake;
        }
        if (awake == 0) break;
    }
    return engine.time();
}

/// The weight of all bodies, and what floor and walls bear of it upwards.  [N]
struct Weighed
{
    double weight = 0.0;
    double borne = 0.0;
};

inline Weighed weigh(const RestEngine& engine)
{
    Weighed result;
    for (int k = 0; k < engine.body_count(); ++k) {
        if (!engine.body(k).is_static) result.weight += k_gravity / engine.body(k).inertia.inv_mass;
    }
    for (const RestContact& c : engine.contacts()) {
        if (!engine.body(c.a).is_static) continue; // they come first in our heaps
        result.borne += c.normal_force * c.normal.y() + c.tangent_force * c.normal.x();
    }
    return result;
}

/// Bodies that touch, as pairs.
using Pairs = std::vector<std::pair<int, int>>;

inline Pairs chain_of(int count)
{
    Pairs pairs;
    for (int k = 1; k < count; ++k) pairs.emplace_back(k - 1, k);
    return pairs;
}

inline Pairs ring_of(int count)
{
    Pairs pairs = chain_of(count);
    pairs.emplace_back(0, count - 1);
    return pairs;
}

/// Row by row from the ground; in a row, boxes touch as well.
inline Pairs pyramid_of(int base)
{
    Pairs pairs;
    int first = 0;
    for (int row = base; row > 0; --row) {
        for (int k = 0; k + 1 < row; ++k) {
            pairs.emplace_back(first + k, first + k + 1);
            pairs.emplace_back(first + k, first + row + k);
            pairs.emplace_back(first + k + 1, first + row + k);
        }
        first += row;
    }
    return pairs;
}

/// Blocks beside the diagonal once all bodies are eliminated, by the engine.
inline int blocks_of(int count, const Pairs& pairs)
{
    std::vector<BlockSystem::Edge> edges;
    for (const auto& [a, b] : pairs) edges.push_back({a, b});
    BlockSystem system;
    system.set_pattern(count, edges);
    return static_cast<int>(system.size());
}

/// The same on paper: who has the fewest neighbours left goes, and couples them.
struct OnPaper
{
    std::vector<int> order;                ///< in which they go
    std::vector<std::set<int>> neighbours; ///< of each body, when it goes
    int blocks = 0;
    long work = 0; ///< products of blocks
};

inline OnPaper blocks_by_hand(int count, const Pairs& pairs)
{
    std::vector<std::set<int>> now(count);
    for (const auto& [a, b] : pairs) {
        now[a].insert(b);
        now[b].insert(a);
    }
    OnPaper paper;
    paper.neighbours.resize(count);
    std::set<int> left;
    for (int k = 0; k < count; ++k) left.insert(k);
    while (!left.empty()) {
        const auto fewer = [&](int a, int b) { return now[a].size() < now[b].size(); };
        const int next = *std::min_element(left.begin(), left.end(), fewer);
        for (const int a : now[next]) {
            now[a].erase(next);
            for (const int b : now[next])
                if (a != b) now[a].insert(b);
        }
        const int few = static_cast<int>(now[next].size());
        paper.blocks += few;
        paper.work += static_cast<long>(few) * few;
        paper.order.push_back(next);
        paper.neighbours[next] = now[next];
        left.erase(next);
    }
    return paper;
}

/// The worst error that so many sweeps leave in a column, if each looks back.
inline double error_looking_back(int count, int sweeps)
{
    const std::vector<double> masses(count, 1.0);
    Column column = column_of(masses, 1.0);
    SweepBatches batches;
    batches.lay_out(column.points, column.movers, column.members);
    batches.sweep_ahead({sweeps, sweeps, 0.0});
    batches.get_impulses(column.points);
    return worst_error(column.points, weights_above(masses, 1.0));
}

/// How many of them it takes until no impulse is off by more than `share`.
inline int sweeps_looking_back(int count, double share)
{
    int sweeps = 1;
    while (sweeps < 10000 && error_looking_back(count, sweeps) > share) ++sweeps;
    return sweeps;
}

/// A row of equal balls that touch, on a smooth floor, of which the first rolls.
inline RestEngine row_of_balls(int count, double v, double e)
{
    const Material material{e, 0.0};
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, material)};
    for (int k = 0; k < count; ++k) bodies.push_back(disc(0.5, Vec2(k, 0.5), 1.0, material));
    bodies[1].state.velocity = Vec2(v, 0.0);
    return RestEngine(bodies);
}

/// Two boxes side by side on a smooth floor, swept, and drawn along it by a share of
/// gravity: whether they stay for a second.
inline bool stays_put(double share)
{
    const Material smooth{0.0, 0.0};
    std::vector<RestBody> bodies = {wall(Vec2(0.0, 1.0), 0.0, smooth)};
    for (int k = 0; k < 2; ++k) {
        bodies.push_back(box(1.0, 1.0, Vec2(k, 0.5), 1.0, smooth));
        bodies.back().acceleration.x() = share * k_gravity;
    }
    RestOptions options;
    options.most_solved = 0;
    RestEngine engine(bodies, options);
    engine.advance(1.0);
    return engine.state(1).position.x() == 0.0;
}

} // namespace flying::test
