#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "balls.hpp"
#include "math/random.hpp"
#include "math/sine_cosine.hpp"

namespace flying {

/// A gas of discs of diameter 1 and mass 1 in a square room, set out on a lattice;
/// all at 1 m/s, in any direction. side  discs in a row; packing  share of the room
/// that they cover
inline EventEngine gas_of(int side, double packing, std::uint64_t seed,
                          PairFinder finder = PairFinder::grid)
{
    Random random(seed);
    const double count = static_cast<double>(side) * side;
    const double length = std::sqrt(count * 0.25 * std::numbers::pi / packing);
    const double pitch = length / side;
    std::vector<EventBody> bodies;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const SineCosine way = sine_cosine(random.uniform(0.0, 2.0 * std::numbers::pi));
            bodies.push_back(ball(0.5, 1.0, {(column + 0.5) * pitch, (row + 0.5) * pitch},
                                  {way.cosine, way.sine}));
        }
    }
    bodies.push_back(wall({1.0, 0.0}, 0.0));
    bodies.push_back(wall({-1.0, 0.0}, -length));
    bodies.push_back(wall({0.0, 1.0}, 0.0));
    bodies.push_back(wall({0.0, -1.0}, -length));
    EventEngineOptions options;
    options.pair_finder = finder;
    return EventEngine(std::move(bodies), options);
}

/// The same bodies at the same places, all velocities turned round.  discs  those
/// that move
inline EventEngine turned_round(const EventEngine& engine, int discs)
{
    std::vector<EventBody> bodies;
    for (int k = 0; k < engine.body_count(); ++k) {
        EventBody body{engine.shape(k), {}, engine.inertia(k), {}, k >= discs};
        if (k < discs) {
            const BodyState now = state_at(engine.flyer(k), engine.time());
            body.flyer.state.position = now.position;
            body.flyer.state.velocity = -now.velocity;
        }
        bodies.push_back(body);
    }
    return EventEngine(std::move(bodies), {});
}

/// How often a disc of a gas meets others.  [1/s]
/// z  compressibility; kT  temperature as energy [J]; mass [kg]; sigma  diameter [m]
inline double gas_rate(double z, double kT, double mass, double sigma)
{
    return 4.0 * (z - 1.0) * std::sqrt(kT / (std::numbers::pi * mass)) / sigma;
}

/// Compressibility of hard discs by its virial series, coefficients in units of the
/// second (Clisby and McCoy 2006).  packing  up to 0.4 or so
inline double compressibility(double packing)
{
    constexpr std::array<double, 9> k_coefficients{1.0,      0.782004, 0.532232,
                                                   0.333556, 0.198833, 0.114868,
                                                   0.064991, 0.036257, 0.019956};
    double z = 1.0;
    double power = 1.0;
    for (const double coefficient : k_coefficients) {
        power *= 2.0 * packing;
        z += coefficient * power;
    }
    return z;
}

/// A mean and what it may be off by: the standard error of the blocks' means.
struct Estimate
{
    double mean = 0.0;
    double error = 0.0;
};

inline Estimate estimate(const std::vector<double>& blocks)
{
    const double count = static_cast<double>(blocks.size());
    Estimate e;
    for (const double x : blocks) e.mean += x / count;
    double sum = 0.0;
    for (const double x : blocks) sum += (x - e.mean) * (x - e.mean);
    e.error = std::sqrt(sum / (count - 1.0) / count);
    return e;
}

/// What a gas does in the middle of its room, where no wall orders it.
struct GasMeasure
{
    Estimate packing;
    Estimate rate;       ///< impacts of one disc with others [1/s]
    Estimate from_rate;  ///< compressibility, from the rate of impacts
    Estimate from_walls; ///< compressibility, from the push on the middle of the walls
    std::array<long, 30> speeds{}; ///< how many in each tenth of a m/s
    long samples = 0;
};

/// Watches a gas impact by impact.
class GasWatch
{
public:
    /// side  discs in a row; packing  as for gas_of
    GasWatch(EventEngine& gas, int discs) : gas_(gas), discs_(discs)
    {
        length_ = -std::get<HalfPlane>(gas.shape(discs + 1)).offset;
        for (int k = 0; k < discs; ++k) velocities_.push_back(gas.flyer(k).state.velocity);
    }

    /// Blocks of equal time; each gives one value of everything.
    /// block  [s]; count  how many
    GasMeasure measure(double block, int count)
    {
        std::vector<double> packings;
        std::vector<double> rates;
        std::vector<double> by_rate;
        std::vector<double> by_walls;
        const double middle = length_ - 2.0 * k_margin;
        const double start = gas_.time();
        for (int k = 0; k < count; ++k) {
            impacts_ = 0.0;
            pushes_ = 0.0;
            double inside = 0.0;
            const int samples = static_cast<int>(4.0 * block);
            for (int n = 1; n <= samples; ++n) {
                follow(start + block * (k + static_cast<double>(n) / samples));
                inside += count_inside() / samples;
            }
            // kT = 1/2: each disc has half a joule, in two directions
            const double kT = 0.5;
            const double density = inside / (middle * middle);
            const double rate = 2.0 * impacts_ / (inside * block);
            packings.push_back(0.25 * std::numbers::pi * density);
            rates.push_back(rate);
            by_rate.push_back(1.0 + 0.25 * rate * std::sqrt(std::numbers::pi / kT));
            by_walls.push_back(pushes_ / (4.0 * middle * block) / (density * kT));
        }
        measured_.packing = estimate(packings);
        measured_.rate = estimate(rates);
        measured_.from_rate = estimate(by_rate);
        measured_.from_walls = estimate(by_walls);
        return measured_;
    }

    /// Event by event to a time; each impact is noted.  [s]
    void follow(double until)
    {
        while (gas_.time() < until) {
            const std::int64_t before = gas_.counts().impacts;
            if (gas_.advance(until, 1)) return;
            if (gas_.counts().impacts != before) note_impact();
        }
    }

private:
    void note_impact()
    {
        // Walls have the ids after those of the discs
        const Event& impact = gas_.last_impacts().back();
        const BodyState a = gas_.flyer(impact.a).state;
        if (impact.b < discs_) {
            const BodyState b = gas_.flyer(impact.b).state;
            if (is_inside(0.5 * (a.position + b.position))) impacts_ += 1.0;
            velocities_[impact.b] = b.velocity;
        } else {
            // Along a wall, leave out what lies near its ends
            const Vec2 push = a.velocity - velocities_[impact.a];
            const double along =
                std::abs(push.x()) > std::abs(push.y()) ? a.position.y() : a.position.x();
            if (along > k_margin && along < length_ - k_margin) pushes_ += push.norm();
        }
        velocities_[impact.a] = a.velocity;
    }

    [[nodiscard]] double count_inside()
    {
        double inside = 0.0;
        for (int k = 0; k < discs_; ++k) {
            const BodyState state = state_at(gas_.flyer(k), gas_.time());
            if (is_inside(state.position)) inside += 1.0;
            const auto bin = static_cast<std::size_t>(10.0 * state.velocity.norm());
            if (bin < measured_.speeds.size()) ++measured_.speeds[bin];
            ++measured_.samples;
        }
        return inside;
    }

    [[nodiscard]] bool is_inside(const Vec2& p) const
    {
        return p.minCoeff() > k_margin && p.maxCoeff() < length_ - k_margin;
    }

    static constexpr double k_margin =
        4.0; // diameters, within which walls order the discs [m]

    EventEngine& gas_;
    int discs_;
    double length_ = 0.0; // [m]
    std::vector<Vec2> velocities_;
    double impacts_ = 0.0; // inside, in this block
    double pushes_ = 0.0;  // on the middle of the walls, in this block [N s]
    GasMeasure measured_;
};

} // namespace flying
