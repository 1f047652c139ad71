#include <doctest/doctest.h>

#include FLYING_ANSWER

TEST_CASE("twice the width, four times the inertia") { CHECK(ratio() == 4.0); }
