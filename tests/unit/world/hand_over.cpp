#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "math/random.hpp"
#include "world/hand_over.hpp"

using namespace flying;

namespace {

Leaning body_at(int number, const Vec2& position, double speed)
{
    Leaning one;
    one.body = number;
    one.position = position;
    one.radius = 0.5;
    one.speed = speed;
    one.pull = 10.0;
    one.way = {position - Vec2::Constant(0.6), position + Vec2::Constant(0.6)};
    return one;
}

/// The reaches of those that are awake, and of what they may wake, by comparing all with all.
std::vector<BoxCells::Entry> plain_reaches(const std::vector<Leaning>& awake, const std::vector<Leaning>& asleep,
                                           double time)
{
    std::vector<Leaning> all = awake;
    all.insert(all.end(), asleep.begin(), asleep.end());
    std::vector<std::size_t> group(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) group[k] = k;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t k = 0; k < all.size(); ++k) {
                if (!overlap(all[i].way, all[k].way) || group[i] <= group[k]) continue;
                group[i] = group[k];
                changed = true;
            }
        }
    }
    std::vector<BoxCells::Entry> reaches;
    for (std::size_t i = 0; i < all.size(); ++i) {
        double top = 0.0;
        bool is_awake = false;
        for (std::size_t k = 0; k < all.size(); ++k) {
            if (group[k] != group[i]) continue;
            top = std::max(top, all[k].speed);
            is_awake = is_awake || k < awake.size();
        }
        const double way = time * (2.0 * top + all[i].pull * time) + (1.0 + 0x1p-10) * all[i].radius;
        if (is_awake)
            reaches.push_back({{all[i].position - Vec2(way, way), all[i].position + Vec2(way, way)}, all[i].body});
    }
    return reaches;
}

} // namespace

TEST_CASE("those that sleep are reached as if all were compared with all, whichever comes later")
{
    Random random(1711);
    for (int round = 0; round < 60; ++round) {
        const double width = random.uniform(5.0, 25.0);
        const auto place = [&] { return Vec2(random.uniform(0.0, width), random.uniform(0.0, width)); };
        std::vector<Leaning> asleep;
        std::vector<Leaning> awake;
        for (int k = 0; k < 40; ++k) asleep.push_back(body_at(k, place(), 0.0));
        for (int k = 40; k < 45; ++k) awake.push_back(body_at(k, place(), random.uniform(0.0, 5.0)));
        HandOver rules;
        rules.set_asleep(asleep);
        rules.begin(awake);
        rules.reach(0.02);
        for (int k = 45; k < 145; k += 5) {
            std::vector<Leaning> more;
            const bool is_slow = k % 2 == 0;
            for (int i = 0; i < 5; ++i)
                more.push_back(body_at(k + i, place(), is_slow ? 0.0 : random.uniform(0.0, 6.0)));
            awake.insert(awake.end(), more.begin(), more.end());
            CHECK_FALSE(rules.add(more).empty());
            if (k % 3 == 0) rules.end();
        }
        rules.end();
        const std::vector<BoxCells::Entry> reaches = plain_reaches(awake, asleep, 0.02);
        for (int look = 0; look < 300; ++look) {
            const Vec2 point = 1.4 * place() - Vec2::Constant(0.2 * width);
            const bool is_near = std::any_of(reaches.begin(), reaches.end(), [&](const auto& one) {
                return overlap(one.box, {point, point});
            });
            CHECK(rules.is_near({point, point}) == is_near);
        }
    }
}

TEST_CASE("a step asks for none of those that sleep elsewhere")
{
    std::int64_t alone = 0;
    for (const int sleepers : {0, 10, 1000}) {
        std::vector<Leaning> asleep;
        for (int k = 0; k < sleepers; ++k) asleep.push_back(body_at(k + 3, Vec2(10.0 + k, 0.0), 0.0));
        HandOver rules;
        rules.set_asleep(asleep);
        const std::int64_t before = rules.looked_at();
        rules.begin({body_at(0, Vec2(-2.0, 0.0), 3.0), body_at(1, Vec2(-4.0, 0.0), 3.0)});
        rules.reach(0.02);
        (void)rules.add({body_at(2, Vec2(-6.0, 0.0), 1.0)});
        rules.end();
        const std::int64_t work = rules.looked_at() - before;
        if (sleepers == 0) alone = work;
        CHECK(work > 0);
        CHECK(work == alone);
    }
}

TEST_CASE("those are let go that nothing holds back, by itself or by others, whatever else may go")
{
    Random random(2811);
    for (int round = 0; round < 200; ++round) {
        const double width = random.uniform(5.0, 25.0);
        std::vector<Leaning> awake;
        std::vector<int> may_go;
        for (int k = 0; k < 60; ++k) {
            awake.push_back(body_at(k, Vec2(random.uniform(0.0, width), random.uniform(0.0, width)), 0.0));
            if (random.uniform(0.0, 1.0) < 0.9) may_go.push_back(k);
        }
        HandOver rules;
        rules.begin(awake);
        rules.reach(0.02);

        // By asking again and again, all of them
        const std::vector<BoxCells::Entry> reaches = plain_reaches(awake, {}, 0.02);
        std::vector<int> going = may_go;
        for (bool changed = true; changed;) {
            const std::vector<int> before = going;
            const auto is_held = [&](int body) {
                return std::any_of(reaches.begin(), reaches.end(), [&](const BoxCells::Entry& other) {
                    return overlap(reaches[body].box, other.box) &&
                           !std::binary_search(before.begin(), before.end(), other.body);
                });
            };
            going.erase(std::remove_if(going.begin(), going.end(), is_held), going.end());
            changed = going.size() != before.size();
        }
        CHECK(rules.may_leave(may_go) == going);
    }
}

TEST_CASE("to let go one of a column, and hold back the others, takes work in proportion to its height")
{
    std::int64_t of_ten = 0;
    for (const int count : {10, 100, 1000}) {
        std::vector<Leaning> awake;
        std::vector<int> may_go;
        for (int k = 0; k <= count; ++k) {
            awake.push_back(body_at(k, Vec2(0.0, k), 0.0)); // the lowest stays
            if (k > 0) may_go.push_back(k);
        }
        awake.push_back(body_at(count + 1, Vec2(5.0, 0.0), 0.0));
        may_go.push_back(count + 1);
        HandOver rules;
        rules.begin(awake);
        rules.reach(0.02);
        const std::int64_t before = rules.looked_at();
        CHECK(rules.may_leave(may_go) == std::vector<int>{count + 1});
        const std::int64_t work = rules.looked_at() - before;
        if (count == 10) of_ten = work;
        CHECK(work > 0);
        CHECK(work <= of_ten * (count / 10));
    }
}
