#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("a stage moves on with the time that passes, times the speed of time")
{
    Stage stage = stage_of(three_bodies());
    play(stage, 1.0);
    CHECK(stage.run.time() == doctest::Approx(1.0));
    REQUIRE(press(stage, "plus"));
    CHECK(stage.clock.speed == 2.0);
    play(stage, 1.0);
    CHECK(stage.run.time() == doctest::Approx(3.0));
    REQUIRE(press(stage, "minus"));
    REQUIRE(press(stage, "minus"));
    play(stage, 1.0);
    CHECK(stage.run.time() == doctest::Approx(3.5));
}

TEST_CASE("P holds time and lets it go on")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "p");
    play(stage, 1.0);
    CHECK(stage.run.time() == 0.0);
    press(stage, "p");
    play(stage, 0.5);
    CHECK(stage.run.time() == doctest::Approx(0.5));
}

TEST_CASE("a full stop goes one frame on, a comma one back, and what is met again is the same to the bit")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "p");
    std::vector<std::vector<double>> seen;
    for (int k = 0; k < 200; ++k) {
        seen.push_back(numbers_of(stage));
        press(stage, "period");
    }
    CHECK(stage.run.time() == doctest::Approx(200.0 / 60.0));
    for (int k = 199; k >= 0; --k) {
        press(stage, "comma");
        CAPTURE(k);
        // Times are sums, which rounding makes differ: so do places, by as much
        const std::vector<double> now = numbers_of(stage);
        for (std::size_t i = 0; i < now.size(); ++i) CHECK(std::abs(now[i] - seen[static_cast<std::size_t>(k)][i]) <= 1e-9);
    }
    press(stage, "comma");
    CHECK(stage.notice.text == "This is the earliest moment that is remembered");
}

TEST_CASE("a run that was gone back in goes on as it went before, to the bit")
{
    Stage stage = stage_of(gas(30));
    play(stage, 1.0);
    Stage other = stage_of(gas(30));
    play(other, 1.0);
    REQUIRE(numbers_of(stage) == numbers_of(other));
    REQUIRE(stage.run.go_back(0.4));
    (void)stage.run.advance(other.run.time(), -1);
    CHECK(numbers_of(stage) == numbers_of(other));
    CHECK(stage.run.collisions() == other.run.collisions());
}

TEST_CASE("a frame that uses up its budget says that time runs slower than asked")
{
    Stage stage = stage_of(gas(200));
    set_speed(stage, 16.0);
    for (int k = 0; k < 60; ++k) stage.advance(1.0 / 60.0, short_of_time);
    CHECK(stage.clock.is_behind());
    CHECK(stage.run.time() < 8.0);
    Stage quick = stage_of(three_bodies());
    play(quick, 2.0);
    CHECK_FALSE(quick.clock.is_behind());
}

TEST_CASE("a frame stops at the event or step that uses up its budget")
{
    // Each look at the clock is a millisecond later: as many events as the budget has of them
    Stage stage = stage_of(gas(200));
    set_speed(stage, 64.0);
    const auto ticking = [] {
        static int looks = 0;
        return 1e-3 * ++looks;
    };
    for (int k = 0; k < 20; ++k) {
        const std::int64_t before = stage.run.events();
        stage.advance(1.0 / 60.0, ticking);
        CHECK(stage.run.events() - before <= 1 + static_cast<std::int64_t>(1e3 * stage.clock.budget));
    }
}

TEST_CASE("keys that mean nothing are refused, and nothing else is")
{
    Stage stage = stage_of(three_bodies());
    CHECK_FALSE(press(stage, "ctrl+alt+f12"));
    CHECK_FALSE(press(stage, ""));
    for (const Binding& binding : bindings()) {
        Stage fresh = stage_of(three_bodies());
        const std::string first(binding.keys.substr(0, binding.keys.find(' ')));
        CAPTURE(first);
        CHECK(press(fresh, first));
    }
}

TEST_CASE("no key is bound twice")
{
    std::vector<std::string> seen;
    for (const Binding& binding : bindings()) {
        std::string_view rest = binding.keys;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            seen.emplace_back(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }
    std::sort(seen.begin(), seen.end());
    const auto twice = std::adjacent_find(seen.begin(), seen.end());
    CHECK_MESSAGE(twice == seen.end(), (twice == seen.end() ? "" : *twice));
}

TEST_CASE("costs of frames are told by their median and by what nineteen of twenty don't exceed")
{
    FrameCosts costs;
    CHECK(costs.quantile(0.5) == 0.0);
    for (int k = 0; k <= 1000; ++k) costs.add(k % 100 == 7 ? 50.0 : 1.0 + 0.01 * (k % 10));
    CHECK(costs.quantile(0.5) == doctest::Approx(1.04).epsilon(0.02));
    CHECK(costs.quantile(0.95) < 1.2);
    CHECK(costs.quantile(1.0) == 50.0);
}

TEST_CASE("keys that are pressed within a frame don't search for the next impacts again")
{
    Stage stage = stage_of(gas(45));
    play(stage, 0.5);
    REQUIRE(press(stage, "e"));
    REQUIRE_FALSE(stage.watch.next.empty());
    const double took = stage.watch.next_took;
    for (int k = 0; k < 200; ++k) REQUIRE(press(stage, "n"));
    CHECK(stage.watch.next_took == took);

    // Bodies that were changed are searched anew in time; what was found for others is not shown
    REQUIRE(press(stage, "r"));
    REQUIRE(press(stage, "left"));
    CHECK(stage.watch.next.empty());
    play(stage, 0.5 + 10.0 * took);
    CHECK_FALSE(stage.watch.next.empty());
}

TEST_CASE("in a crowd the impacts that come next are looked for in the nearest future, and are the same")
{
    Stage stage = stage_of(gas(120));
    press(stage, "e");
    const std::vector<NextImpact> all = next_impacts(stage.run.world(), stage.watch.inside, 24, 1.0);
    REQUIRE_FALSE(stage.watch.next.empty());
    REQUIRE(stage.watch.next.size() <= all.size());
    for (std::size_t k = 0; k < stage.watch.next.size(); ++k) {
        CHECK(stage.watch.next[k].time == all[k].time);
        CHECK(stage.watch.next[k].a == all[k].a);
        CHECK(stage.watch.next[k].b == all[k].b);
    }
}

TEST_CASE("keys that only a window can answer ask it, each for its own thing")
{
    Stage stage = stage_of(three_bodies());
    for (const char* key : {"q", "ctrl+q", "f9", "f11", "ctrl+o", "ctrl+f", "ctrl+s", "f6", "f7", "f8"}) press(stage, key);
    CHECK(stage.requests == std::vector<Request>{Request::quit, Request::quit, Request::panel, Request::fullscreen, Request::open,
                                                 Request::face, Request::save, Request::video, Request::trace, Request::state});
}

TEST_CASE("a key that steps a slow run far says how far it got, and goes on from there when it is pressed again")
{
    Stage stage = stage_of(gas(2000));
    set_speed(stage, 64.0);
    const double whole = 20.0 * stage.clock.frame * stage.clock.speed;
    double from = 0.0;
    for (int k = 0; k < 2; ++k) {
        REQUIRE(press(stage, "greater"));
        CHECK(stage.run.time() > from);
        CHECK(stage.run.time() <= from + whole);
        if (stage.run.time() < from + whole) CHECK(stage.notice.text == "This is how far the run gets in a tenth of a second");
        from = stage.run.time();
    }
    REQUIRE(press(stage, "less"));
    CHECK(stage.run.time() < from);
}
