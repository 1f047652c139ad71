#include <cmath>

#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "math/random.hpp"
#include "rest/contact_point.hpp"
#include "rest/sweeps.hpp"

using namespace flying;

TEST_CASE("sweeps over a column are those of the engine")
{
    Random random(1151);
    for (int i = 0; i < 50; ++i) {
        const int count = 1 + i % 8;
        std::vector<double> masses;
        std::vector<Mover> movers(1);
        std::vector<ContactPoint> points;
        for (int k = 0; k < count; ++k) {
            masses.push_back(random.uniform(0.5, 5.0));
            movers.push_back({0.0, -0.5, 0.0, 1.0 / masses[k], 1.0});
            ContactPoint c;
            c.a = k;
            c.b = k + 1;
            c.n_y = 1.0;
            c.normal_mass = c.tangent_mass = 1.0 / (movers[k].inv_mass + movers[k + 1].inv_mass);
            points.push_back(c);
        }
        const int sweeps = 1 + i % 5;
        for (int s = 0; s < sweeps; ++s) sweep(points, movers);
        const std::vector<double> answer = forces(masses, 0.5, sweeps);
        REQUIRE(answer.size() == masses.size());
        // A few roundings of impulses up to 20 N s in each sweep
        CAPTURE(count);
        CAPTURE(sweeps);
        for (int k = 0; k < count; ++k) {
            CAPTURE(k);
            CHECK(std::abs(answer[k] - points[k].normal) < 1e-13);
        }
    }
}
