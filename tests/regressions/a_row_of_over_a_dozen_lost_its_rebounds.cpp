#include <doctest/doctest.h>

#include <vector>

#include "support/worlds.hpp"

// A ball that struck a row of twelve others, a billionth of a metre or a centimetre apart, came to rest among them as
// if nothing rebounded: where impacts have no moments of their own, what was thrown against the next within a step was
// only stopped. With eleven, or with none between them, the blow was handed on. So it was, later, to the 65th ball and
// no further.

using namespace flying;
using namespace flying::testing;

namespace {

struct Row
{
    int balls;
    double gap; ///< [m]
    double restitution;
    double mass;  ///< of the ball that strikes; that of each other is 1 [kg]
    double speed; ///< [m/s]
};

constexpr double k_radius = 0.25;
constexpr double k_apart = 0.25; ///< of the ball that strikes [m]
constexpr double k_row_until = 1.0;

/// Impacts on a line, each at its moment.
struct OnALine
{
    std::vector<double> place;
    std::vector<double> velocity;
    std::vector<double> mass;

    explicit OnALine(const Row& row) : place{-k_apart - 2.0 * k_radius}, velocity{row.speed}, mass{row.mass}
    {
        for (int k = 0; k < row.balls; ++k) {
            place.push_back(k * (2.0 * k_radius + row.gap));
            velocity.push_back(0.0);
            mass.push_back(1.0);
        }
    }

    void advance(double until, double restitution)
    {
        for (double time = 0.0; time < until;) {
            double wait = until - time;
            std::size_t left = place.size();
            for (std::size_t k = 0; k + 1 < place.size(); ++k) {
                const double closing = velocity[k] - velocity[k + 1];
                const double gap = place[k + 1] - place[k] - 2.0 * k_radius;
                if (!(closing > 0.0) || gap / closing >= wait) continue;
                wait = gap / closing;
                left = k;
            }
            for (std::size_t k = 0; k < place.size(); ++k) place[k] += wait * velocity[k];
            time += wait;
            if (left == place.size()) return;
            const double push =
                (1.0 + restitution) * (velocity[left] - velocity[left + 1]) / (1.0 / mass[left] + 1.0 / mass[left + 1]);
            velocity[left] -= push / mass[left];
            velocity[left + 1] += push / mass[left + 1];
        }
    }

    [[nodiscard]] double energy() const
    {
        double sum = 0.0;
        for (std::size_t k = 0; k < place.size(); ++k) sum += 0.5 * mass[k] * velocity[k] * velocity[k];
        return sum;
    }
};

} // namespace

TEST_CASE("a row of balls hands a blow on whether twelve stand in it or more and however near")
{
    for (const Row& row :
         {Row{12, 1e-9, 0.95, 2.0, 6.0}, Row{13, 1e-2, 0.95, 2.0, 6.0}, Row{20, 1e-3, 0.99, 1.0, 2.5},
          Row{12, 1e-3, 0.99, 1.0, 2.5}, Row{20, 2e-2, 0.8, 3.0, 20.0}, Row{40, 1e-4, 0.9, 0.5, 8.0},
          Row{70, 5e-3, 0.95, 2.0, 10.0}, Row{70, 1e-6, 0.95, 1.0, 6.0}, Row{200, 1e-9, 0.99, 1.0, 3.0}}) {
        Scene scene = on_a_floor(row.restitution, 0.0);
        const auto add = [&](double x, double speed, double mass) {
            scene.bodies.push_back(disc(k_radius, {x, k_radius}, {speed, 0.0}));
            scene.bodies.back().mass = mass;
        };
        OnALine line(row);
        for (std::size_t k = 0; k < line.place.size(); ++k) add(line.place[k], line.velocity[k], line.mass[k]);
        World world = world_of(scene);
        run(world, k_row_until);
        line.advance(k_row_until, row.restitution);
        double energy = 0.0;
        for (std::size_t k = 0; k < line.place.size(); ++k)
            energy += 0.5 * line.mass[k] * world.state(static_cast<int>(k) + 1).velocity.squaredNorm();
        CAPTURE(row.balls);
        CAPTURE(row.gap);
        CHECK(world.state(row.balls + 1).velocity.x() == doctest::Approx(line.velocity.back()).epsilon(1e-3));
        CHECK(energy == doctest::Approx(line.energy()).epsilon(0.02));
    }
}
