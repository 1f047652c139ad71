// The figures of chapter 16. Those of seconds are drawn from the run that is kept in measured.jsonl; the others from
// what is computed here.

#include <cstdio>

#include "diagram.hpp"
#include "race.hpp"
#include "support/sketch.hpp"
#include "wrong_blocks.hpp"

using namespace flying;
using namespace flying::work;

namespace {

/// Error against steps: a ball in a box, and one turn of an ellipse.
void draw_orders(const std::string& folder)
{
    Sketch sketch(folder + "/orders.svg", 560.0, 470.0);
    const Race race;
    std::vector<Panel::Curve> curves = {
        {"Euler", {}}, {"symplectic Euler", {}}, {"Verlet", {}}, {"from wall to wall", {}}};
    const auto spot = [](double work, double error) {
        return Panel::Spot{work, work, work, shown_error(error), false};
    };
    for (long n = 480; n <= 122880; n *= 2) {
        curves[0].spots.push_back(spot(static_cast<double>(n), error_by_steps(race, steps::k_euler, n)));
        curves[1].spots.push_back(spot(static_cast<double>(n), error_by_steps(race, steps::k_symplectic, n)));
        curves[2].spots.push_back(spot(static_cast<double>(n), error_by_steps(race, steps::k_verlet, n)));
    }
    const Flown flown = by_walls(race.start(), race.walls(), race.gravity(), race.until);
    curves[3].spots.push_back(spot(static_cast<double>(flown.flights), race.error(flown.ball)));
    const Panel panel(sketch, curves, Vec2(0.0, 0.0), Vec2(560.0, 400.0));
    panel.draw("steps, or flights", "error [m]");
    panel.legend(Vec2(62.0, 422.0), 250.0, 2);
}

/// The race as it runs: the ball by Verlet's steps, sixty a second, and where it is in truth.
void trace_race(const std::string& folder)
{
    std::FILE* file = std::fopen((folder + "/race.ndjson").c_str(), "w");
    if (!file) return;
    const Race race;
    std::fprintf(file, "{\"view\": [0, 0, %g, 2.5], \"shapes\": [{\"radius\": %g}]}\n", race.width, race.radius);
    BodyState ball = race.start();
    for (int k = 0; k <= 480; ++k) {
        const double time = k / 60.0;
        if (k > 0) ball = by_steps(steps::k_verlet, ball, race.walls(), race.gravity(), 1.0 / 60.0, 1);
        const Vec2 truth = race.truth(time);
        std::fprintf(file, "{\"time\": %.6f, \"bodies\": [[%.6f, %.6f, 0]], \"ghosts\": [[%.6f, %.6f, 0]]}\n", time,
                     ball.position.x(), ball.position.y(), truth.x(), truth.y());
    }
    std::fclose(file);
}

/// A ball that meets a wall within a step.
void draw_late(const std::string& folder)
{
    Sketch s(folder + "/late.svg", 560.0, 250.0);
    const double wall = 400.0;
    s.polygon({Vec2(wall, 20), Vec2(wall + 40, 20), Vec2(wall + 40, 216), Vec2(wall, 216)}, pale(k_soft, 0.3), k_none);
    s.line(Vec2(wall, 20), Vec2(wall, 216), k_ink, 2.0);
    const double step = 110.0;
    const double first = 120.0;
    for (int k = 0; k < 3; ++k) {
        s.disc(Vec2(first + step * k, 70.0), 7.0, k_amber, k_none);
        s.arrow(Vec2(first + step * k + 10.0, 70.0), Vec2(first + step * (k + 1) - 10.0, 70.0), k_amber);
    }
    const double deep = first + 3.0 * step;
    s.disc(Vec2(deep, 70.0), 7.0, k_amber, k_none);
    s.arrow(Vec2(deep - 2.0, 92.0), Vec2(deep - step + 10.0, 112.0), k_amber);
    s.disc(Vec2(deep - step, 114.0), 7.0, k_amber, k_none);
    const double truth = 2.0 * wall - deep;
    s.disc(Vec2(truth, 160.0), 7.0, k_none, k_teal, 2.2);
    s.arrow(Vec2(wall - 2.0, 150.0), Vec2(truth + 9.0, 160.0), k_teal);
    s.disc(Vec2(truth - step, 182.0), 7.0, k_none, k_teal, 2.2);
    s.arrow(Vec2(truth - 10.0, 162.0), Vec2(truth - step + 9.0, 181.0), k_teal);
    s.measure(Vec2(truth - step, 214.0), Vec2(deep - step, 214.0), k_ink);
    s.dashed(Vec2(deep - step, 122.0), Vec2(deep - step, 208.0));
    s.formula(Vec2(0.5 * (truth + deep) - step, 240.0), "2 v δ", Anchor::middle, k_ink);
    s.formula(Vec2(first + 0.5 * step, 52.0), "v h", Anchor::middle, k_amber);
    s.measure(Vec2(wall, 44.0), Vec2(deep, 44.0), k_ink);
    s.formula(Vec2(0.5 * (wall + deep), 34.0), "v δ", Anchor::middle, k_ink, 17.0);
    s.words(Vec2(14, 74), "by steps", Anchor::left, k_amber);
    s.words(Vec2(14, 188), "in truth", Anchor::left, k_teal);
}

/// Two equal programs on a machine that grows warm, in blocks and there and back.
void draw_turns(const std::string& folder)
{
    Sketch s(folder + "/turns.svg", 560.0, 270.0);
    const auto panel = [&](double left, const char* title, const std::vector<std::vector<double>>& times,
                           bool in_blocks) {
        s.words(Vec2(left + 115.0, 22.0), title, Anchor::middle, k_ink, 15.0);
        s.line(Vec2(left, 230.0), Vec2(left + 230.0, 230.0), k_soft, 1.4);
        s.line(Vec2(left, 40.0), Vec2(left, 230.0), k_soft, 1.4);
        const int rounds = static_cast<int>(times[0].size());
        double sums[2] = {0.0, 0.0};
        for (int which = 0; which < 2; ++which) {
            const Tone tone = which == 0 ? k_blue : k_rust;
            for (int k = 0; k < rounds; ++k) {
                const int place = in_blocks ? which * rounds + k : 2 * k + (k % 2 == 0 ? which : 1 - which);
                const double time = times[static_cast<std::size_t>(which)][static_cast<std::size_t>(k)];
                sums[which] += time / rounds;
                s.disc(Vec2(left + 8.0 + 213.0 * place / (2.0 * rounds - 1.0), 230.0 - 170.0 * (time - 1.0) / 0.21),
                       4.0, tone, k_none);
            }
        }
        for (int which = 0; which < 2; ++which) {
            const double y = 230.0 - 170.0 * (sums[which] - 1.0) / 0.21;
            s.dashed(Vec2(left, y), Vec2(left + 230.0, y), which == 0 ? k_blue : k_rust, which == 0 ? 3.4 : 1.8);
        }
        s.words(Vec2(left + 230.0, 252.0), "runs, as they come", Anchor::right, k_soft, 14.0);
    };
    DriftingMachine machine;
    const auto clock = [&machine] { return machine.now; };
    const Prepare one = [&machine] { return [&machine] { machine.run(); }; };
    const std::vector<Prepare> twins = {one, one};
    const auto blocks = time_in_blocks(twins, 10, clock);
    machine = {};
    const auto turns = time_in_turn(twins, 10, clock);
    panel(30.0, "in blocks", blocks, true);
    panel(310.0, "there and back", turns, false);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    const std::string folder = argv[1];
    const auto records = read_record_file(FLYING_MEASURED);
    if (!records) {
        std::fprintf(stderr, "%s: found no records; expected the file of a run of ./course bench\n", FLYING_MEASURED);
        return 1;
    }
    const auto second = read_record_file(FLYING_SECOND);
    if (!second) {
        std::fprintf(stderr, "%s: found no records; expected the file of a run of ./course bench\n", FLYING_SECOND);
        return 1;
    }
    const auto growth = read_record_file(FLYING_GROWTH);
    if (!growth) {
        std::fprintf(stderr, "%s: found no records; expected the file of a run of ./course bench\n", FLYING_GROWTH);
        return 1;
    }
    draw_orders(folder);
    trace_race(folder);
    draw_late(folder);
    draw_turns(folder);

    for (const DiagramRecord& diagram : records->diagrams) {
        for (std::size_t k = 0; k < diagram.measures.size(); ++k) {
            const std::string suffix = k == 0 ? "" : "-" + std::to_string(k + 1);
            draw_diagram(folder + "/work-" + diagram.name + suffix + ".svg", diagram, k);
        }
    }
    for (const DiagramRecord& diagram : second->diagrams) {
        for (std::size_t k = 0; k < diagram.measures.size(); ++k) {
            const std::string suffix = k == 0 ? "" : "-" + std::to_string(k + 1);
            draw_diagram(folder + "/second-" + diagram.name + suffix + ".svg", diagram, k);
        }
    }
    for (const GrowthRecord& one : growth->growths) draw_growth(folder + "/growth-" + one.name + ".svg", one);
    draw_ratios(folder + "/ratios.svg", *records);
    draw_skips(folder + "/skips.svg", *records);

    return 0;
}
