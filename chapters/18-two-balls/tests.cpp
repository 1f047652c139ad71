#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "billiard.hpp"
#include "math/random.hpp"
#include "support/receipts.hpp"
#include "toi/discs.hpp"
#include "wrong_loops.hpp"
#include "wrong_quadratic.hpp"

using namespace flying;

namespace {

constexpr double k_ulp = std::numeric_limits<double>::epsilon();

} // namespace

TEST_CASE("the loop counts five digits of pi")
{
    double ratio = 1.0;
    for (const long expected : {3L, 31L, 314L, 3141L, 31'415L, 314'159L}) {
        discs::Room room = billiard_room(ratio);
        CHECK(discs::run(room, 1000.0) == expected);
        CHECK(expected == whole_steps_below_pi(billiard_angle(ratio)));
        ratio *= 100.0;
    }
}

TEST_CASE("between its impacts, too, the billiard is where the folded line is")
{
    double worst = 0.0;
    for (const double ratio : {1.0, 16.0, 100.0, 1e4}) {
        for (int k = 1; k <= 300; ++k) {
            discs::Room room = billiard_room(ratio);
            discs::run(room, 0.01 * k);
            const BilliardPlaces places = billiard_places(ratio, 0.01 * k);
            worst = std::max({worst, std::abs(room.discs[0].x - places.light),
                              std::abs(room.discs[1].x - places.heavy)});
        }
    }
    // Each of up to 314 impacts rounds a time of 3 s at most, at a speed of 100 m/s at most
    CHECK(worst < 314 * 100.0 * 1.5 * k_ulp);
    RECORD_VALUE("discs.wedge.off", worst);
}

// [discs.tests.back]
TEST_CASE("with all velocities turned round, nine discs go back the way they came")
{
    const discs::Room start = discs::nine_discs();
    discs::Room room = start;
    const long there = discs::run(room, 10.0);
    for (discs::Disc& d : room.discs) d.vx = -d.vx, d.vy = -d.vy;
    CHECK(discs::run(room, 10.0) == there);
    CHECK(there > 20);
    double worst = 0.0;
    for (std::size_t k = 0; k < 9; ++k) {
        worst = std::max({worst, std::abs(room.discs[k].x - start.discs[k].x),
                          std::abs(room.discs[k].y - start.discs[k].y)});
    }
    CHECK(worst < 1e-9);
    RECORD_VALUE("discs.back.off", worst);
    RECORD_VALUE("discs.back.impacts", there);
}
// [discs.tests.back]

TEST_CASE("a hundred seconds of nine discs keep their energy, and no disc leaves the room")
{
    discs::Room room = discs::nine_discs();
    const double before = discs::energy(room);
    for (int k = 0; k < 1000; ++k) {
        discs::run(room, 0.1);
        for (const discs::Disc& d : room.discs) {
            CHECK(d.x >= d.r - 1e-12);
            CHECK(d.x <= 10.0 - d.r + 1e-12);
            CHECK(d.y >= d.r - 1e-12);
            CHECK(d.y <= 10.0 - d.r + 1e-12);
        }
        for (std::size_t a = 0; a < 9; ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const discs::Disc& p = room.discs[a];
                const discs::Disc& q = room.discs[b];
                CHECK(std::hypot(p.x - q.x, p.y - q.y) >= p.r + q.r - 1e-12);
            }
        }
    }
    CHECK(std::abs(discs::energy(room) / before - 1.0) < 1e-13);
}

TEST_CASE("the loop that moves all discs and the page that moves two agree on every impact")
{
    Few few = crowd_of(5);
    discs::Room room{{}, discs::k_never, discs::k_never};
    for (const Clocked& c : few.discs) {
        discs::Disc d = c.disc;
        d.x += 256.0, d.y += 256.0; // far from the walls, which start at 0
        room.discs.push_back(d);
    }
    few.run(100.0);
    CHECK(discs::run(room, 100.0) == static_cast<long>(few.handled.size()));
    // The places were rounded to 2^-45 m; each impact in a row makes that some eight times
    // as large
    for (std::size_t k = 0; k < 25; ++k) {
        CHECK(std::abs(few.discs[k].disc.vx - room.discs[k].vx) < 1e-8);
        CHECK(std::abs(few.discs[k].disc.vy - room.discs[k].vy) < 1e-8);
    }
}

TEST_CASE("the quadratic formula from school loses digits with the distance, "
          "and far away it loses the meeting")
{
    Random random(809);
    int missed = 0;
    for (int i = 0; i < 1000; ++i) {
        const FarPair far = far_pair(random.uniform(1e5, 1e6), random.uniform(0.0, 0.9));
        const double t = exactly(far, 1.0);
        CHECK(std::abs(time_to_meet(far.x, far.v, 1.0) - t) <= 6e-16 * t);
        const FarPair farther =
            far_pair(random.uniform(1e9, 1e10), random.uniform(0.0, 0.9));
        CHECK(time_to_meet(farther.x, farther.v, 1.0) < k_never);
        missed += school_meet(farther.x, farther.v, 1.0) == k_never ? 1 : 0;
    }
    CHECK(missed > 100);
    RECORD_VALUE("toi.wrong.missed", 0.1 * missed);
}

// [events.tests.wrong_stale]
TEST_CASE("overtaken impacts push discs metres apart, and no conserved quantity notices")
{
    Few right = crowd_of(5);
    Few wrong = right;
    const FewSums start = sums_of(right);
    right.run(100.0);
    run_all_foreseen(wrong, 100.0);
    for (const Few* few : {&right, &wrong}) {
        CHECK(std::abs(sums_of(*few).energy - start.energy) < 1e-13);
        CHECK((sums_of(*few).momentum - start.momentum).norm() < 1e-13);
    }
    // At an impact two discs touch: to a part in a million million of their size
    CHECK(right.widest_gap < 1e-12);
    CHECK_FALSE(wrong.widest_gap < 1e-12);
    CHECK(wrong.widest_gap > 1.0);
    RECORD_VALUE("events.stale.pushes", wrong.handled.size() - right.handled.size());
}
// [events.tests.wrong_stale]

// [discs.tests.hops]
TEST_CASE("a loop of hops never passes their end")
{
    const Hops hops = hop_until(10.0, 4.9, 0.5, 9.8, 1'000'000);
    CHECK(hops.count == 1'000'000);
    CHECK(hops.time == doctest::Approx(2.0).epsilon(1e-15));
    CHECK_FALSE(hops.time >= 10.0); // where it was to go
}
// [discs.tests.hops]
