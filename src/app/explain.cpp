#include "app/explain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "app/commands.hpp"
#include "app/messages.hpp"

namespace flying {

namespace {

const char* class_text(SkipClass kind)
{
    switch (kind) {
    case SkipClass::neutral:
        return "neutral: same bits";
    case SkipClass::ordered:
        return "neutral by order: same bits";
    case SkipClass::altering:
        break;
    }
    return "alters results";
}

std::string skip_text(const Skip& skip, PlanMoment moment)
{
    std::string text = fmt::format("  {:<7}  {} ({})\n", fate_of(skip), skip.name, class_text(skip.kind));
    text += fmt::format("           {}\n", skip.reason);
    if (moment == PlanMoment::after_run && skip.active && !skip.saved_unit.empty()) {
        text += fmt::format("           saved {} {}\n", skip.saved, skip.saved_unit);
    }
    return text;
}

} // namespace

std::string explain_plan(const Scene& scene, const Plan& plan, PlanMoment moment)
{
    const long all = static_cast<long>(scene.bodies.size());
    const long fixed =
        std::count_if(scene.bodies.begin(), scene.bodies.end(), [](const BodyDef& b) { return b.is_static; });
    std::string text = fmt::format("Plan for {} that {}, {} static{}\n", counted(all - fixed, "body", "bodies"),
                                   all - fixed == 1 ? "moves" : "move", fixed, scene.world.box ? ", in a box" : "");
    text += fmt::format("  pairs are found by {}\n",
                        plan.pair_finder == PairFinder::grid ? "a grid of cells" : "looking at all of them");
    for (const Skip& skip : plan.skips) text += skip_text(skip, moment);
    return text;
}

int explain(const std::string& scene_path, const std::vector<std::string>& without)
{
    if (!are_skip_names(without)) return status::k_usage;
    const std::optional<Scene> scene = read_scene_or_complain(scene_path);
    if (!scene) return status::k_usage;
    if (!scene->title.empty()) fmt::print("{}\n", scene->title);
    fmt::print("{}", explain_plan(*scene, make_plan(*scene, without), PlanMoment::before_run));
    return status::k_done;
}

int check(const std::string& scene_path)
{
    const std::optional<Scene> scene = read_scene_or_complain(scene_path);
    if (!scene) return status::k_usage;
    const long all = static_cast<long>(scene->bodies.size());
    const long fixed =
        std::count_if(scene->bodies.begin(), scene->bodies.end(), [](const BodyDef& b) { return b.is_static; });
    fmt::print("{}: fit to run: {}, {} of them static, until {:g} s\n", scene_path, counted(all, "body", "bodies"),
               fixed, scene->until);
    return status::k_done;
}

} // namespace flying
