#include "play/stage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "draw/layout.hpp"
#include "math/random.hpp"
#include "play/paint_stage.hpp"
#include "play/seconds.hpp"
#include "scene/fault.hpp"

namespace flying {

namespace {

/// A hue by lot, the same whenever it is asked for.
Colour random_colour(int body)
{
    Random random(0x5eed + static_cast<std::uint64_t>(body));
    const double hue = 6.0 * random.uniform();
    const double strength = random.uniform(0.45, 0.85);
    const auto part = [&](double shift) {
        const double at = std::fmod(hue + shift, 6.0);
        return 0.92 - strength * std::clamp(std::min(at, 4.0 - at), 0.0, 1.0);
    };
    return {part(5.0), part(3.0), part(1.0)};
}

constexpr double k_shown_for = 3.0;     ///< a mode's bar, and a notice [s]
constexpr double k_longest_key = 0.1;   ///< of the run, for a key that steps it: the window answers after that [s]
constexpr double k_averaged_over = 1.0; ///< [s]
constexpr std::size_t k_few =
    150;                        ///< more bodies have no shadows, nor trails that shine through each other: frames count
constexpr double k_mean = 0.05; ///< share of a frame in the mean costs
constexpr double k_remembered_every = 12; ///< [frames]

double options_step(const Stage& stage)
{
    return stage.run.options().step;
}

/// Fills that don't follow from the palette.
void colour_bodies(Stage& stage)
{
    const Theme theme = stage_theme(stage);
    for (std::size_t k = 0; k < stage.picture.bodies.size(); ++k) {
        DrawnBody& body = stage.picture.bodies[k];
        body.fill.reset();
        if (static_cast<int>(k) >= stage.run.world().body_count()) continue;
        if (stage.look.colouring == Colouring::mover)
            body.fill = mover_colour(stage.run.world().mover(static_cast<int>(k)), theme);
        if (stage.look.colouring == Colouring::random && !body.is_static)
            body.fill = random_colour(static_cast<int>(k));
    }
}

/// On to a moment, as far as a budget of real time lets it: by one event or step at a time, any of which may be the
/// slow one.
PlayRun::Advance go_on(Stage& stage, double target, double budget, double (*seconds)())
{
    const double started = seconds();
    const Look& look = stage.look;
    const bool sees_impacts = look.shows(Layer::contacts) || look.shows(Layer::normals) || look.shows(Layer::impulses);
    if (sees_impacts) begin_watch(stage.watch, stage.run);
    PlayRun::Advance done;
    do {
        done = stage.run.advance(target, 1);
        if (sees_impacts) watch_event(stage.watch, stage.run, stage.now);
    } while (!done.arrived && !done.failure && seconds() - started < budget);
    return done;
}

} // namespace

Colour mover_colour(BodyMover mover, const Theme& theme)
{
    switch (mover) {
    case BodyMover::events:
        return {0.337, 0.706, 0.914};
    case BodyMover::rest:
        return {0.902, 0.560, 0.0};
    case BodyMover::asleep:
        return {0.0, 0.30, 0.48};
    case BodyMover::none:
        break;
    }
    return theme.body_static;
}

std::string_view layer_text(Layer layer)
{
    static constexpr std::array<std::string_view, k_layers> texts{"speed arrows",
                                                                  "contact points",
                                                                  "normals",
                                                                  "impulses",
                                                                  "bounding boxes",
                                                                  "cells",
                                                                  "islands",
                                                                  "next events",
                                                                  "trails",
                                                                  "centroid, inertia",
                                                                  "labels",
                                                                  "energy and momentum",
                                                                  "what the plan skips",
                                                                  "cost figures",
                                                                  "help"};
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
        picture.has_shadows = picture.bodies.size() <= k_few;
        picture.trails_shine = picture.has_shadows;
        if (keeps_view) picture.view = old;
        generation = run.generation();
    } else {
        move_bodies(picture, run.world());
    }
    if (!view_is_free && !picture.box) picture.view = joined(picture.view, fitting_view(picture));
    picture.time = run.time();
    check_hand(*this);
    if (ship.body >= run.world().body_count()) ship = Ship{};
    colour_bodies(*this);
    watch_present(watch, run, look, now);
    picture.trails.clear();
    for (std::size_t k = 0; k < watch.trails.size() && k < picture.bodies.size(); ++k) {
        if (watch.trails[k].size() < 2) continue;
        const DrawnBody& body = picture.bodies[k];
        picture.trails.push_back(
            {body.colour, 0.6 * trail_width(body.shape), {watch.trails[k].begin(), watch.trails[k].end()}});
    }
}

void Stage::say(std::string text, bool is_fault)
{
    notice = {std::move(text), now + (is_fault ? 2.0 : 1.0) * k_shown_for, is_fault};
}

bool Stage::change(Scene scene, const std::string& label, Crowding crowding)
{
    const Faults faults = run.change(std::move(scene), label, crowding);
    if (!faults.empty()) {
        const std::string more =
            faults.size() > 1 ? " (and " + std::to_string(faults.size() - 1) + " faults more)" : "";
        say(format_fault(faults.front()) + more, true);
    }
    refresh();
    return faults.empty();
}

void Stage::advance(double wall, double (*seconds)())
{
    now += wall;
    if (wall <= 0.0) return;
    const double from = run.time();
    pull(*this, seconds);
    drive(*this, wall, seconds);
    if (clock.is_paused) {
        clock.due = run.time();
        return;
    }

    // A change may have brought the run to the end of a step: it waits until its time has come
    const double asked = wall * clock.speed;
    const double way = std::min(wall, k_longest_wall) * clock.speed;
    const bool is_astray = clock.due > from + way || clock.due < from - options_step(*this) - way;
    const double due_before = is_astray ? from : clock.due;
    clock.due = due_before + way;
    const double target = std::max(run.time(), clock.due);

    const double started = seconds();
    const PlayRun::Advance done = go_on(*this, target, clock.budget, seconds);
    clock.simulating = seconds() - started;
    if (!done.arrived) clock.due = run.time();
    if (done.failure) {
        clock.is_paused = true;
        say("The run stopped: " + done.failure->message, true);
    }

    const double fresh = std::min(1.0, wall / k_averaged_over);
    clock.share += fresh * (std::min(1.0, (clock.due - due_before) / asked) - clock.share);
    run.remember(k_remembered_every * clock.frame * clock.speed);
    clock.mean_simulating += k_mean * (clock.simulating - clock.mean_simulating);
    clock.mean_drawing += k_mean * (clock.drawing - clock.mean_drawing);
    watch.simulating.add(clock.simulating);
    watch.drawing.add(clock.drawing);
    watch_frame(watch, run, look, now);
    refresh();
}

void step(Stage& stage, int frames)
{
    stage.clock.is_paused = true;
    const double from = stage.run.time();
    const double to = std::max(0.0, from + frames * stage.clock.frame * stage.clock.speed);
    double end = to;
    if (frames > 0) stage.run.remember(k_remembered_every * stage.clock.frame * stage.clock.speed);
    else end = stage.run.rewind(to);
    PlayRun::Advance done;
    done.arrived = stage.run.time() >= end;
    if (!done.arrived) done = go_on(stage, end, k_longest_key, seconds_now);
    if (done.failure) stage.say("The run stopped: " + done.failure->message, true);
    else if (!done.arrived) stage.say("This is how far the run gets in a tenth of a second");
    else if (stage.run.time() != to || to == from) stage.say("This is the earliest moment that is remembered");
    stage.refresh();
}

void zoom(Stage& stage, double factor, const Vec2& pixel)
{
    const Vec2 extent = stage.picture.view.max - stage.picture.view.min;
    const double longest = extent.maxCoeff();
    if (!(factor > 0.0) || !(longest / factor > 1e-9) || !(longest / factor < 1e9)) return;
    const Vec2 before = stage_map(stage, stage.size).world_at(pixel);
    const Vec2 middle = 0.5 * (stage.picture.view.min + stage.picture.view.max);
    stage.picture.view = {middle - 0.5 / factor * extent, middle + 0.5 / factor * extent};
    const Vec2 shift = before - stage_map(stage, stage.size).world_at(pixel);
    stage.picture.view.min += shift;
    stage.picture.view.max += shift;
    stage.view_is_free = true;
}

void pan(Stage& stage, const Vec2& pixels)
{
    const double scale = stage_map(stage, stage.size).scale;
    const Vec2 shift(-pixels.x() / scale, pixels.y() / scale);
    stage.picture.view.min += shift;
    stage.picture.view.max += shift;
    stage.view_is_free = true;
}

void fit_view(Stage& stage)
{
    stage.view_is_free = false;
    stage.picture.view = fitting_view(stage.picture);
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

void resize_box(Stage& stage, double wider, double higher)
{
    Scene scene = stage.run.scene_now();
    if (!scene.world.box || !(wider > 0.0) || !(higher > 0.0)) return;
    const Vec2 extent = scene.world.box->max - scene.world.box->min;
    scene.world.box->max = scene.world.box->min + Vec2(wider * extent.x(), higher * extent.y());
    if (stage.change(std::move(scene), "resize") && !stage.view_is_free)
        stage.picture.view = fitting_view(stage.picture);
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
        field = CentralField{0.5 * (view.min + view.max), round_length(2.5 * radius * radius * radius),
                             round_length(height / 16.0)};
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
