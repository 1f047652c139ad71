#include "play/hand.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "play/paint_stage.hpp"
#include "play/pick.hpp"
#include "play/stage.hpp"

namespace flying {

namespace {

constexpr double k_follows_in = 0.06;     ///< how far what is held lags the pointer, where pulls are not rarer [s]
constexpr double k_throw_over = 0.08;     ///< a throw has the pointer's mean speed over this time [s]
constexpr double k_near = 9.0;            ///< of a click at something small [pixels]
constexpr double k_damping = 0.85;        ///< of the spin of what is held, at each pull
constexpr double k_largest_share = 3.0;   ///< costs of a change between two pulls

double pixel_length(const Stage& stage)
{
    return 1.0 / stage_map(stage, stage.size).scale;
}

/// Mean velocity of the pointer until it was seen last, in simulated time.  [m/s]
Vec2 pointer_velocity(const Stage& stage)
{
    const std::vector<Hand::Trace>& traces = stage.hand.traces;
    if (traces.empty()) return Vec2::Zero();
    const Hand::Trace& last = traces.back();
    const double since = last.time - k_throw_over;
    const auto next = std::find_if(traces.begin(), traces.end(), [&](const Hand::Trace& t) { return t.time >= since; });
    Hand::Trace first = *next;
    if (next != traces.begin()) {
        // It was seen before and after that moment: between them it went straight
        const Hand::Trace& before = *std::prev(next);
        const double share = (since - before.time) / (next->time - before.time);
        first = {since, before.place + share * (next->place - before.place)};
    }
    if (first.time >= last.time) return Vec2::Zero();
    return (last.place - first.place) / ((last.time - first.time) * stage.clock.speed);
}

/// What a throw that ends now or later may ask for is kept.
void add_trace(std::vector<Hand::Trace>& traces, const Hand::Trace& trace)
{
    // A time before the last one is that of another clock: keys have taken over from the mouse, or the mouse from keys
    if (!traces.empty() && trace.time < traces.back().time) traces.clear();
    traces.push_back(trace);
    const double since = trace.time - k_throw_over;
    const auto next = std::find_if(traces.begin(), traces.end(), [&](const Hand::Trace& t) { return t.time >= since; });
    if (next != traces.begin()) traces.erase(traces.begin(), std::prev(next));
}

/// Give the held body's point a velocity, by a push at that point.
void push_grip(const Stage& stage, const Vec2& velocity, bool damps, BodyDef& def)
{
    const Hand::Grip& grip = *stage.hand.grip;
    const Inertia inertia = stage.run.inertia(grip.body);
    const Vec2 r = Rotation::of(def.angle) * grip.local;
    const Vec2 change = velocity - (def.velocity + cross(def.spin, r));

    // The matrix that turns a push at r into a change of velocity there, and its inverse
    const double m = inertia.inv_mass;
    const double i = inertia.inv_moment_of_inertia;
    const double xx = m + i * r.y() * r.y();
    const double yy = m + i * r.x() * r.x();
    const double xy = -i * r.x() * r.y();
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0.0)) return;
    const Vec2 push((yy * change.x() - xy * change.y()) / determinant, (xx * change.y() - xy * change.x()) / determinant);
    def.velocity += m * push;
    def.spin = (damps ? k_damping : 1.0) * (def.spin + i * cross(r, push));
}

/// Where time stands still, or the body is static, it goes where the pointer goes, if there is room.
void carry(Stage& stage)
{
    const Hand::Grip grip = *stage.hand.grip;
    const BodyState state = stage.run.world().state(grip.body);
    const Vec2 place = stage.hand.pointer - Rotation::of(state.angle) * grip.local;
    if ((place - state.position).norm() < 0.25 * pixel_length(stage)) return;
    if (obstacle(stage.run.world(), stage.run.world().shape(grip.body), {place, Rotation::of(state.angle)}, grip.body)) return;
    Scene scene = stage.run.scene_now();
    scene.bodies[static_cast<std::size_t>(grip.body)].position = place;
    stage.change(std::move(scene), "move", Crowding::refuse);
}

} // namespace

std::string_view tool_text(Tool tool)
{
    constexpr std::string_view texts[k_tools] = {"grab and throw", "add a disc", "add a polygon", "draw a polygon", "remove"};
    return texts[static_cast<int>(tool)];
}

void point_at(Stage& stage, const Vec2& pixel, std::optional<double> time)
{
    point_at_world(stage, stage_map(stage, stage.size).world_at(pixel), time);
}

void point_at_world(Stage& stage, const Vec2& place, std::optional<double> time)
{
    Hand& hand = stage.hand;
    if (!is_finite(place)) return;
    hand.by_keys = false;
    hand.pointer = place;
    hand.is_here = true;
    if (time) add_trace(hand.traces, {*time, place});
}

void point_by_keys(Stage& stage, const Vec2& place)
{
    point_at_world(stage, place, stage.now);
    stage.hand.by_keys = true;
}

void leave(Stage& stage)
{
    if (!stage.hand.by_keys) stage.hand.is_here = false;
}

void press_button(Stage& stage, Button button)
{
    Hand& hand = stage.hand;
    if (button == Button::right) {
        if (hand.tool == Tool::draw) close_drawing(stage);
        else hand.selected = body_at(stage.run.world(), hand.pointer, k_near * pixel_length(stage));
        return;
    }
    if (hand.is_pressed) release_button(stage);
    hand.is_pressed = true;
    hand.pressed_at = hand.pointer;
    stage.run.begin_stroke();
    if (hand.tool == Tool::draw) {
        const bool closes = hand.points.size() >= 3 && (hand.points.front() - hand.pointer).norm() < 1.3 * k_near * pixel_length(stage);
        if (closes) close_drawing(stage);
        else if (hand.points.empty() || hand.points.back() != hand.pointer) hand.points.push_back(hand.pointer);
        return;
    }
    if (hand.tool != Tool::grab && hand.tool != Tool::remove) return;

    const int body = body_at(stage.run.world(), hand.pointer, k_near * pixel_length(stage));
    if (hand.tool == Tool::remove) {
        if (body >= 0) remove_body(stage, body);
        return;
    }
    hand.selected = body;
    if (body < 0) return;
    const BodyState state = stage.run.world().state(body);
    const Vec2 local = inverse(Rotation::of(state.angle)) * Vec2(hand.pointer - state.position);
    hand.grip = Hand::Grip{body, local, stage.run.time()};
}

void release_button(Stage& stage)
{
    Hand& hand = stage.hand;
    const bool was_pressed = hand.is_pressed;
    const std::optional<BodyDef> body = was_pressed && hand.tool != Tool::draw ? new_body(stage) : std::nullopt;
    hand.is_pressed = false;
    if (hand.grip && !stage.clock.is_paused && !stage.run.world().is_static(hand.grip->body) &&
        (hand.pointer - hand.pressed_at).norm() > 3.0 * pixel_length(stage)) {
        Scene scene = stage.run.scene_now();
        push_grip(stage, pointer_velocity(stage), false, scene.bodies[static_cast<std::size_t>(hand.grip->body)]);
        stage.change(std::move(scene), "throw", Crowding::refuse);
    }
    hand.grip.reset();
    if (body) {
        if (const std::string fault = fault_of_new(stage, *body); !fault.empty()) {
            stage.say(fault, true);
        } else {
            Scene scene = stage.run.scene_now();
            scene.bodies.push_back(*body);
            if (stage.change(std::move(scene), "add", Crowding::refuse)) hand.selected = stage.run.world().body_count() - 1;
        }
    }
    stage.run.begin_stroke();
}

void press_return(Stage& stage)
{
    Hand& hand = stage.hand;
    if (!hand.is_here) return;
    const bool holds_on = hand.tool == Tool::grab || hand.tool == Tool::disc || hand.tool == Tool::polygon;
    if (holds_on && hand.is_pressed) {
        add_trace(hand.traces, {stage.now, hand.pointer}); // it has been there until now
        release_button(stage);
        return;
    }
    press_button(stage, Button::left);
    // Nothing to hold: a whole click
    if (!holds_on || (hand.tool == Tool::grab && !hand.grip)) release_button(stage);
}

void pull(Stage& stage, double (*seconds)())
{
    Hand& hand = stage.hand;
    if (!hand.grip) return;
    if (stage.clock.is_paused || stage.run.world().is_static(hand.grip->body)) {
        carry(stage);
        return;
    }
    if (stage.now < hand.wait_until) return;
    const double started = seconds();
    Scene scene = stage.run.scene_now();
    BodyDef& def = scene.bodies[static_cast<std::size_t>(hand.grip->body)];
    const Vec2 there = def.position + Rotation::of(def.angle) * hand.grip->local;

    // It keeps this velocity until the next pull, about as late as this one
    const double since = stage.run.time() - std::exchange(hand.grip->pulled_at, stage.run.time());
    push_grip(stage, (hand.pointer - there) / std::max(k_follows_in * stage.clock.speed, since), true, def);
    stage.change(std::move(scene), "throw", Crowding::refuse);
    hand.wait_until = stage.now + k_largest_share * (seconds() - started);
}

void take_tool(Stage& stage, Tool tool)
{
    cancel(stage);
    stage.hand.tool = tool;
}

void cancel(Stage& stage)
{
    Hand& hand = stage.hand;
    hand.grip.reset();
    hand.is_pressed = false;
    hand.points.clear();
    stage.run.begin_stroke();
}

void take_point_back(Stage& stage)
{
    if (!stage.hand.points.empty()) stage.hand.points.pop_back();
}

void remove_body(Stage& stage, int body)
{
    if (body < 0 || body >= stage.run.world().body_count()) return;
    Scene scene = stage.run.scene_now();
    scene.bodies.erase(scene.bodies.begin() + body);
    stage.run.begin_stroke();
    if (stage.change(std::move(scene), "remove", Crowding::refuse)) stage.hand.selected = -1;
    stage.run.begin_stroke();
}

void resize_new(Stage& stage, int steps)
{
    const Vec2 extent = stage.picture.view.max - stage.picture.view.min;
    const double most = 0.5 * extent.maxCoeff();
    stage.hand.size = std::clamp(stage.hand.size * std::pow(1.2, steps), 1e-3 * most, most);
}

void select_next(Stage& stage, int steps)
{
    const int count = stage.run.world().body_count();
    if (count == 0) return;
    const int from = stage.hand.selected < 0 ? (steps > 0 ? -1 : 0) : stage.hand.selected;
    stage.hand.selected = ((from + steps) % count + count) % count;
    point_by_keys(stage, stage.run.world().state(stage.hand.selected).position);
}

void check_hand(Stage& stage)
{
    Hand& hand = stage.hand;
    const int count = stage.run.world().body_count();
    if (hand.selected >= count) hand.selected = -1;
    if (hand.grip && hand.grip->body >= count) hand.grip.reset();
    if (hand.size == 0.0) {
        const Vec2 extent = stage.picture.view.max - stage.picture.view.min;
        hand.size = 0.05 * extent.minCoeff();
        if (!(hand.size > 0.0)) hand.size = 0.05 * extent.maxCoeff();
    }
}

} // namespace flying
