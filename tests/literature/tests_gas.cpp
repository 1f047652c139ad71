#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "literature/disc_gas.hpp"
#include "literature/equation_of_state.hpp"
#include "literature/statistics.hpp"

using namespace flying;

TEST_CASE("the series of hard discs gives the literature's pressure at packing 0.3")
{
    CHECK(gas::series(0.3) == doctest::Approx(2.0632).epsilon(2e-5));
    // Slope and bend against differences
    const double h = 1e-4;
    CHECK(gas::series_slope(0.3) == doctest::Approx((gas::series(0.3 + h) - gas::series(0.3 - h)) / (2 * h)).epsilon(1e-6));
    CHECK(gas::series_bend(0.3) ==
          doctest::Approx((gas::series_slope(0.3 + h) - gas::series_slope(0.3 - h)) / (2 * h)).epsilon(1e-6));
}

TEST_CASE("a gas of a thousand discs has the pressure and the collision rate of the literature, to its statistical error")
{
    // ./course stress gas goes to 2e-4. Here 1.6 million collisions: errors of 1e-3 and 2e-3 of Z
    gas::Gas box = gas::make_gas({32, 0.3, 1.0, 1});
    gas::mix(box, 50.0);
    const gas::Figures found = gas::measure(box, 0.3, 6.0, 16, 100'000);
    MESSAGE("Z from number " << found.z_count.value << " +- " << found.z_count.error << ", from momentum "
                             << found.z_virial.value << " +- " << found.z_virial.error << ", rate " << found.rate.value
                             << " +- " << found.rate.error);
    // Roundings of 1.6 million collisions, as a random walk: 1300 times 1e-16 or so, shared by a thousand discs
    CHECK(std::abs(found.energy_change) <= 1e-12);
    CHECK(found.z_count.error < 3e-3);
    CHECK(found.z_virial.error < 4e-3);
    CHECK(std::abs(found.z_count.value - 2.0632) <= 4.0 * found.z_count.error);
    CHECK(std::abs(found.z_virial.value - 2.0632) <= 4.0 * found.z_virial.error);
    CHECK(std::abs(found.rate.value - 1.0) <= 4.0 * found.rate.error);
}

TEST_CASE("discs that start with one speed end with Maxwell's distribution of speeds")
{
    // m v^2 / 2 over k T is distributed as exp(-x): twenty bins of equal weight
    gas::BoxOptions options{32, 0.3, 1.0, 2};
    options.equal_speeds = true;
    gas::Gas box = gas::make_gas(options);
    gas::Bins before(20);
    gas::Bins bins(20);
    const auto sample = [&](gas::Bins& into) {
        for (int k = 0; k < box.count; ++k)
            into.add(-std::expm1(-0.5 * box.engine.flyer(k).state.velocity.squaredNorm()));
    };
    sample(before);
    gas::mix(box, 20.0);
    for (int k = 0; k < 40; ++k) {
        gas::mix(box, 4.0);
        sample(bins);
    }
    MESSAGE("chi^2 " << bins.chi_square() << " of 19, before " << before.chi_square());
    // One run in a thousand has more than 43.8
    CHECK(bins.chi_square() < 43.8);
    CHECK(before.chi_square() > 1000.0);
}

TEST_CASE("squares that start without spin end with a third of their energy in it")
{
    // Two directions of flight and one of turning share alike: <I w^2> = <m v_x^2> = k T
    gas::BoxOptions options{8, 0.3, 1.0, 3};
    options.squares = true;
    const gas::Equipartition found = gas::share_of_spin(options, 400);
    MESSAGE("share of spin " << found.share.value << " +- " << found.share.error << ", chi^2 of the spins " << found.chi_square);
    CHECK(found.before == 0.0);
    CHECK(found.share.error < 0.003);
    CHECK(std::abs(found.share.value - 1.0 / 3.0) <= 4.0 * found.share.error);
    CHECK(found.chi_square < 43.8);
}

TEST_CASE("slightly inelastic discs cool as T0 / (1 + t / tau)^2")
{
    const gas::Cooling found = gas::cool({64, 0.1, 0.99, 4}, 2.0);
    MESSAGE("worst departure " << found.worst << ", tau " << found.tau << ", temperature at the end " << found.last);
    // At e = 0.99 the distribution of speeds departs from Maxwell's by a coefficient of -0.005, which slows the cooling by
    // a thousandth. Discs at walls collide less often: about 1 % at this size, 0.6 % where the box is half as wide again
    CHECK(found.last == doctest::Approx(1.0 / 9.0).epsilon(0.02));
    CHECK(found.worst < 0.02);
}
