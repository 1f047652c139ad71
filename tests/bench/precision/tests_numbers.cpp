// The kernels in floats and in doubles: both do the same, and rounding is all that differs.

#include <doctest/doctest.h>

#include "numbers.hpp"
#include "sweep.hpp"

using namespace flying::bench;
namespace work = flying::work;

namespace {

double frozen()
{
    return 0.0;
}

/// Errors of doubles and of floats in the trial of this name, at the one setting.
std::vector<double> errors(const std::string& name, double hertz)
{
    std::vector<double> all;
    for (const TrialMaker& maker : number_trials()) {
        if (maker.name != name) continue;
        SweepOptions options;
        options.repeats = 1;
        options.hertz = {hertz};
        options.seconds = frozen;
        options.least = 0.0;
        const work::DiagramRecord record =
            sweep(maker.make(Coarseness::quick), number_engines(), options, [](const std::string&) {});
        for (const work::CurveRecord& curve : record.curves) all.push_back(curve.points.at(0).measures.at(0));
    }
    return all;
}

} // namespace

TEST_CASE("a gas in doubles follows the truth, one in floats loses it by what rounding grows to")
{
    const std::vector<double> gas = errors("numbers-gas", 60.0);
    REQUIRE(gas.size() == 2);
    // 2^-53 and 2^-24 of a box of some ten metres, each grown alike over a second's collisions
    CHECK(gas[0] < 1e-10);
    CHECK(gas[1] < 1e10 * gas[0]);
    CHECK(gas[1] > 1e-7);
}

TEST_CASE("sweeps over a stack find the forces to the rounding of their numbers")
{
    // Ten contacts lose a fortieth of the error a sweep: after 2000 sweeps e^-45 is left
    const std::vector<double> stack = errors("numbers-stack", 60.0 * 2000.0);
    REQUIRE(stack.size() == 2);
    CHECK(stack[0] < 100.0 * 0x1p-53);
    CHECK(stack[1] < 100.0 * 0x1p-24);
    CHECK(stack[1] > stack[0]);
}

TEST_CASE("few steps are as wrong in floats as in doubles")
{
    const std::vector<double> orbit = errors("numbers-orbit", 960.0);
    REQUIRE(orbit.size() == 2);
    CHECK(std::abs(orbit[1] / orbit[0] - 1.0) < 0.1);
}
