#include "play/stage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "draw/layout.hpp"
#include "scene/fault.hpp"

namespace flying {

namespace {

constexpr double k_shown_for = 3.0;       ///< a mode's bar, and a notice [s]
constexpr double k_longest_wall = 0.1;    ///< of one frame: what is longer was a hitch [s]
constexpr double k_averaged_over = 1.0;   ///< [s]
constexpr double k_remembered_every = 12; ///< [frames]

} // namespace

std::string_view layer_text(Layer layer)
{
    static constexpr std::array<std::string_view, k_layers> texts{
        "speed arrows", "contact points", "normals",     "impulses", "bounding boxes",      "cells",             "islands",   "next events",
        "trails",       "centroid, inertia", "labels", "energy and momentum", "what the plan skips", "cost figures", "help"};
    return texts[static_cast<std::size_t>(layer)];
}

Expected<Stage> Stage::open(Scene scene, const WorldOptions& options)
{
    Expected<PlayRun> run = PlayRun::start(std::move(scene), options);
    if (!run) return run.faults();
    return Stage(std::move(run).value());
}

Stage::Stage(PlayRun started) : run(std::move(started))
{
    refresh();
}

void Stage::refresh()
{
    if (generation != run.generation()) {
        const bool keeps_view = generation >= 0 && (view_is_free || !picture.box);
        const Aabb old = picture.view;
        picture = picture_of(run.world());
        picture.title.clear();
        if (keeps_view) picture.view = old;
        generation = run.generation();
    } else {
        move_bodies(picture, run.world());
    }
    if (!view_is_free && !picture.box) picture.view = joined(picture.view, fitting_view(picture));
    picture.time = run.time();
}

void Stage::say(std::string text, bool is_fault)
{
    notice = {std::move(text), now + (is_fault ? 2.0 : 1.0) * k_shown_for, is_fault};
}

bool Stage::change(Scene scene, const std::string& label, Crowding crowding)
{
    const Faults faults = run.change(std::move(scene), label, crowding);
    if (!faults.empty()) {
        const std::string more = faults.size() > 1 ? " (and " + std::to_string(faults.size() - 1) + " faults more)" : "";
        say(format_fault(faults.front()) + more, true);
    }
    refresh();
    return faults.empty();
}

void Stage::advance(double wall, double (*seconds)())
{
    now += wall;
    if (clock.is_paused || wall <= 0.0) return;
    const double asked = wall * clock.speed;
    const double from = run.time();
    const double target = from + std::min(wall, k_longest_wall) * clock.speed;

    // As far as the budget lets it, a few events at a time
    const double started = seconds();
    std::int64_t most = 32;
    PlayRun::Advance done;
    do {
        done = run.advance(target, most);
        most = std::min<std::int64_t>(2 * most, 512);
    } while (!done.arrived && !done.failure && seconds() - started < clock.budget);
    clock.simulating = seconds() - started;
    if (done.failure) {
        clock.is_paused = true;
        say("The run stopped: " + done.failure->message, true);
    }

    const double fresh = std::min(1.0, wall / k_averaged_over);
    clock.share += fresh * ((run.time() - from) / asked - clock.share);
    run.remember(k_remembered_every * clock.frame * clock.speed);
    refresh();
}

void step(Stage& stage, int frames)
{
    stage.clock.is_paused = true;
    const double way = frames * stage.clock.frame * stage.clock.speed;
    if (frames > 0) {
        stage.run.remember(k_remembered_every * stage.clock.frame * stage.clock.speed);
        const PlayRun::Advance done = stage.run.advance(stage.run.time() + way, -1);
        if (done.failure) stage.say("The run stopped: " + done.failure->message, true);
    } else if (stage.run.time() <= 0.0 || !stage.run.go_back(std::max(0.0, stage.run.time() + way))) {
        stage.say("This is the earliest moment that is remembered");
    }
    stage.refresh();
}

void set_speed(Stage& stage, double speed)
{
    if (!std::isfinite(speed)) return;
    stage.clock.speed = std::clamp(speed, k_slowest, k_fastest);
    stage.clock.share = 1.0;
}

void set_restitution(Stage& stage, double e)
{
    Scene scene = stage.run.scene_now();
    const double before = scene.world.restitution;
    scene.world.restitution = std::clamp(std::round(e * 1e6) / 1e6, 0.0, 1.0);
    if (scene.world.restitution != before) stage.change(std::move(scene), "restitution", Crowding::refuse);
}

void set_friction(Stage& stage, double mu)
{
    Scene scene = stage.run.scene_now();
    const double before = scene.world.friction;
    scene.world.friction = std::clamp(std::round(mu * 1e6) / 1e6, 0.0, 100.0);
    if (scene.world.friction != before) stage.change(std::move(scene), "friction", Crowding::refuse);
}

void set_field(Stage& stage, const Field& field)
{
    Scene scene = stage.run.scene_now();
    scene.world.field = field;
    stage.change(std::move(scene), "field");
}

FieldKind field_kind(const Field& field)
{
    return std::holds_alternative<CentralField>(field)   ? FieldKind::central
           : std::holds_alternative<UniformField>(field) ? FieldKind::uniform
                                                         : FieldKind::none;
}

double gravity_step(const Stage& stage)
{
    const Vec2 extent = stage.picture.view.max - stage.picture.view.min;
    return round_length(extent.y() / 80.0);
}

void set_field_kind(Stage& stage, FieldKind kind)
{
    if (field_kind(stage.run.scene().world.field) == kind) return;
    const Aabb& view = stage.picture.view;
    const double height = view.max.y() - view.min.y();
    Field field = NoField{};
    if (kind == FieldKind::uniform) field = UniformField{Vec2(0.0, -10.0 * gravity_step(stage))};
    if (kind == FieldKind::central) {
        // A turn about the middle at a quarter of the height takes four seconds
        const double radius = 0.25 * height;
        field = CentralField{0.5 * (view.min + view.max), round_length(2.5 * radius * radius * radius), round_length(height / 16.0)};
    }
    set_field(stage, field);
}

void turn_knob(Stage& stage, int dx, int dy, bool coarse)
{
    stage.mode_until = stage.now + k_shown_for;
    const double times = coarse ? 10.0 : 1.0;
    if (stage.arrow_keys == ArrowKeys::restitution) {
        set_restitution(stage, stage.run.scene().world.restitution + 0.01 * times * (dx + dy));
        return;
    }
    if (stage.arrow_keys != ArrowKeys::gravity) return;

    const double step = gravity_step(stage);
    if (const auto* central = std::get_if<CentralField>(&stage.run.scene().world.field)) {
        CentralField changed = *central;
        changed.mu *= std::pow(1.1, times * dy);
        changed.radius = std::max(0.0, step * std::round(changed.radius / step + times * dx));
        set_field(stage, changed);
        return;
    }
    const Vec2 gravity = uniform_acceleration(stage.run.scene().world.field) + step * times * Vec2(dx, dy);
    // Whole steps, so that nought is met again
    const Vec2 rounded(step * std::round(gravity.x() / step), step * std::round(gravity.y() / step));
    if (rounded == Vec2::Zero()) set_field(stage, NoField{});
    else set_field(stage, UniformField{rounded});
}

} // namespace flying
