#include <cmath>

#include <doctest/doctest.h>

#include "../../../01-flying-balls/orbits.hpp"

#include FLYING_ANSWER

using namespace flying::steps;

namespace {

/// The eccentricity found from two moments of an orbit, as shares of its period below a half.
double found(const Orbit& o, double from, double to)
{
    const double r_1 = on_ellipse(o, from * o.period()).x.norm();
    const double r_2 = on_ellipse(o, to * o.period()).x.norm();
    return eccentricity_from(o.mu, o.a, r_1, r_2, (to - from) * o.period());
}

} // namespace

TEST_CASE("two looks at an orbit give back its eccentricity")
{
    for (const double ecc : {0.1, 0.3, 0.6, 0.9, 0.99})
        CHECK(std::abs(found({1.0, 1.0, ecc}, 0.1, 0.4) - ecc) < 1e-9);
}

TEST_CASE("the size of the orbit and the strength of the sun play no part")
{
    CHECK(std::abs(found({1.32712440018e20, 1.495978707e11, 0.25}, 0.15, 0.35) - 0.25) < 1e-9);
}
