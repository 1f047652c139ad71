#include <doctest/doctest.h>

#include FLYING_ANSWER

#include "02-rectangle/rectangle.hpp"

using namespace flying;

TEST_CASE("the frame and the plate that fits into it make the whole plate")
{
    const MassProperties frame = frame_mass(3.0, 2.0, 0.25, 5.0);
    const MassProperties whole = rectangle_mass(3.0, 2.0, 5.0);
    const MassProperties inside = rectangle_mass(2.5, 1.5, 5.0);
    CHECK(frame.mass + inside.mass == doctest::Approx(whole.mass).epsilon(1e-14));
    CHECK(frame.moment_of_inertia + inside.moment_of_inertia ==
          doctest::Approx(whole.moment_of_inertia).epsilon(1e-14));
}

TEST_CASE("a frame of a wire keeps its digits")
{
    // A square of wire, side 1: four rods of mass m/4, each m/4 (1/12 + 1/4), together m/3. The width of the wire adds
    // shares of its own size, 1e-12
    const double t = 1e-12;
    const MassProperties wire = frame_mass(1.0, 1.0, t, 1.0 / t);
    CHECK(wire.mass == doctest::Approx(4.0).epsilon(1e-11));
    CHECK(wire.moment_of_inertia / wire.mass == doctest::Approx(1.0 / 3.0).epsilon(1e-11));
}
