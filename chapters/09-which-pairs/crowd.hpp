#pragma once

#include <cmath>
#include <vector>

#include "boxes.hpp"

// Equal discs that move by small steps and exchange their speeds where they are found to
// overlap.
namespace flying {


/// What the bodies are filed under.
enum class Index
{
    position,
    velocity
};

struct Crowd
{
    double radius = 0.5; ///< [m]
    Vec2 room = Vec2(12.0, 12.0);
    std::vector<Vec2> position;
    std::vector<Vec2> velocity;

    /// The pairs of discs that overlap, as an index finds them.
    [[nodiscard]] Pairs find(Index index) const
    {
        const int n = static_cast<int>(position.size());
        Grid grid(2.5 * radius, 16, 16, n);
        for (int k = 0; k < n; ++k) {
            grid.insert(k,
                        grid.cell_at(index == Index::position ? position[k] : velocity[k]));
        }

        Pairs pairs;
        for (int k = 0; k < n; ++k) {
            grid.for_each_near(grid.cell_of(k), [&](int other) {
                const bool meets = (position[other] - position[k]).norm() < 2.0 * radius;
                if (other > k && meets) pairs.emplace_back(k, other);
            });
        }
        return pairs;

    }

    void step(Index index, double dt);
    [[nodiscard]] double energy() const;
};



inline void Crowd::step(Index index, double dt)
{
    for (std::size_t k = 0; k < position.size(); ++k) {
        position[k] += dt * velocity[k];
        for (int i = 0; i < 2; ++i) {
            const bool low = position[k][i] < radius && velocity[k][i] < 0.0;
            const bool high = position[k][i] > room[i] - radius && velocity[k][i] > 0.0;
            if (low || high) velocity[k][i] = -velocity[k][i];
        }
    }
    for (const auto& [a, b] : find(index)) {
        const Vec2 n = (position[b] - position[a]).normalized();
        const double v_n = n.dot(velocity[b] - velocity[a]);
        if (v_n >= 0.0) continue;
        velocity[a] += v_n * n;
        velocity[b] -= v_n * n;
    }
}



/// Energy of motion, for masses of 1 kg.  [J]
inline double Crowd::energy() const
{
    double sum = 0.0;
    for (const Vec2& v : velocity) sum += 0.5 * v.squaredNorm();
    return sum;
}



/// n discs in random places of a square room; velocities up to `speed` in either direction.
inline Crowd make_crowd(int n, double side, double speed, std::uint64_t seed)
{
    Random random(seed);
    Crowd crowd;
    crowd.room = Vec2(side, side);
    for (int k = 0; k < n; ++k) {
        crowd.position.push_back(
            Vec2{random.uniform(0.5, side - 0.5), random.uniform(0.5, side - 0.5)});
        crowd.velocity.push_back(
            Vec2{random.uniform(-speed, speed), random.uniform(-speed, speed)});
    }
    return crowd;
}


} // namespace flying
