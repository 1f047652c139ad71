// The energy of a gas of elastic discs grew by 1e-16 of a disc's with each collision, on the average: the length of the
// rounded normal was allowed for by a sum of squares, and near 1 such a sum loses more above than below.

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "math/random.hpp"
#include "math/twofold.hpp"
#include "response/impact.hpp"

using namespace flying;

namespace {

/// A body's kinetic energy, without rounding in its sums and products. [J]
Twofold energy_of(const Vec2& velocity, double spin, const Inertia& inertia)
{
    const Twofold moved =
        Twofold(two_product(velocity.x(), velocity.x())) + Twofold(two_product(velocity.y(), velocity.y()));
    Twofold energy = moved / Twofold(inertia.inv_mass);
    if (spin != 0.0) energy = energy + Twofold(two_product(spin, spin)) / Twofold(inertia.inv_moment_of_inertia);
    return Twofold(0.5) * energy;
}

double bell(Random& random)
{
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) sum += random.uniform();
    return sum;
}

struct Case
{
    double radius;
    double density;
    double arm; // of the push, in radii
};

} // namespace

TEST_CASE("roundings of elastic impacts take as much energy as they give")
{
    constexpr int k_impacts = 40'000;
    for (const Case& each :
         {Case{0.5, 1.0, 0.0}, Case{0.1, 1.0, 0.0}, Case{0.37, 1.0, 0.0}, Case{0.1784, 0.3, 0.0},
          Case{1.0 / std::sqrt(3.14159265358979), 1.0, 0.0}, Case{0.5, 1.0, 0.6}, Case{0.2, 2.0, 0.3}}) {
        CAPTURE(each.radius);
        CAPTURE(each.arm);
        Random random(3);
        const double mass = 3.14159265358979 * each.radius * each.radius * each.density;
        const Inertia inertia{1.0 / mass, 2.0 / (mass * each.radius * each.radius)};
        double sum = 0.0;
        double squares = 0.0;
        int count = 0;
        while (count < k_impacts) {
            // Two discs of a gas, where they touch: their places have digits that the way between them hasn't
            const double angle = random.uniform(0.0, 6.28);
            const Vec2 place_a(random.uniform(0.0, 50.0), random.uniform(0.0, 50.0));
            const Vec2 place_b = place_a + 2.0 * each.radius * Vec2(std::cos(angle), std::sin(angle));
            const Vec2 b_to_a = place_a - place_b;
            const Vec2 normal = -b_to_a / b_to_a.norm();
            const double aside = each.arm * each.radius;
            ImpactPoint point{each.radius * normal, -each.radius * normal, normal};
            if (aside != 0.0) {
                point.r_a += random.uniform(-aside, aside) * perp(normal);
                point.r_b += random.uniform(-aside, aside) * perp(normal);
            }
            const bool turns = aside != 0.0;
            const ImpactBody a{{bell(random), bell(random)}, turns ? bell(random) : 0.0, inertia};
            const ImpactBody b{{bell(random), bell(random)}, turns ? bell(random) : 0.0, inertia};
            const double approach = (a.velocity - b.velocity).dot(normal);
            if (approach < random.uniform(0.0, 5.0)) continue;
            const ImpactResult after = resolve_impact(a, b, {&point, 1}, {1.0, 0.0});
            const Twofold change =
                energy_of(after.velocity_a, after.spin_a, inertia) - energy_of(a.velocity, a.spin, inertia) +
                (energy_of(after.velocity_b, after.spin_b, inertia) - energy_of(b.velocity, b.spin, inertia));
            const double in_means = change.rounded() / mass; // the mean energy of a disc is its mass times 1 m^2/s^2
            sum += in_means;
            squares += in_means * in_means;
            ++count;
        }
        // Independent roundings leave a sum below five of its standard deviations but once in two million cases
        CHECK(std::abs(sum) <= 5.0 * std::sqrt(squares));
        // A mean gain of an eighth of the rounding of doubles would have been seen
        CHECK(5.0 * std::sqrt(squares) / k_impacts <= 0x1p-52 / 8.0);
    }
}
