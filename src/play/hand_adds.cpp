// The hand as it draws new bodies and adds them to the run.

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>

#include "geometry/make_polygon.hpp"
#include "math/orientation.hpp"
#include "mass/polygon.hpp"
#include "play/pick.hpp"
#include "play/stage.hpp"
#include "scene/fault.hpp"
#include "world/make_shape.hpp"

namespace flying {

namespace {

/// The density of the scene's bodies: of the first that moves.
double usual_density(const PlayRun& run)
{
    const World& world = run.world();
    for (int k = 0; k < world.body_count(); ++k) {
        if (world.is_static(k)) continue;
        return 1.0 / (run.inertia(k).inv_mass * mass_of(world.shape(k), 1.0).mass);
    }
    return 1.0;
}

/// Two sides share a point, their ends included.
bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const int abc = orientation(a, b, c);
    const int abd = orientation(a, b, d);
    const int cda = orientation(c, d, a);
    const int cdb = orientation(c, d, b);
    if (abc != abd && cda != cdb) return true;
    const auto between = [](const Vec2& from, const Vec2& to, const Vec2& p) {
        return (p - from).dot(p - to) <= 0.0;
    };
    return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
           (cdb == 0 && between(c, d, b));
}

/// The drawing as a body: its centre of mass is where it was drawn.
std::optional<BodyDef> drawn_body(const std::vector<Vec2>& points)
{
    const Expected<CentredPolygon> polygon = make_polygon(points);
    if (!polygon) return std::nullopt;
    BodyDef body;
    body.shape = PolygonDef{points, {}};
    body.position = polygon.value().centroid;
    return body;
}

/// A message about what was drawn by hand: its numbers have three decimals at most.
std::string rounded_numbers(std::string_view text)
{
    std::string rounded;
    int decimals = -1; // so far, in a number's fraction; -1 elsewhere
    for (const char c : text) {
        const bool is_digit = c >= '0' && c <= '9';
        if (!is_digit) decimals = c == '.' ? 0 : -1;
        else if (decimals >= 0 && ++decimals > 3) continue;
        rounded += c;
    }
    return rounded;
}

} // namespace

std::vector<int> crossing_sides(const std::vector<Vec2>& points)
{
    std::vector<int> crossing;
    const int sides = static_cast<int>(points.size()) - 1;
    for (int i = 0; i < sides; ++i) {
        bool crosses = false;
        for (int k = 0; k < sides && !crosses; ++k) {
            if (std::abs(i - k) < 2) continue;
            crosses = meet(points[static_cast<std::size_t>(i)], points[static_cast<std::size_t>(i) + 1],
                           points[static_cast<std::size_t>(k)], points[static_cast<std::size_t>(k) + 1]);
        }
        if (crosses) crossing.push_back(i);
    }
    return crossing;
}

std::optional<BodyDef> new_body(const Stage& stage)
{
    const Hand& hand = stage.hand;
    std::optional<BodyDef> body;
    if (hand.tool == Tool::disc || hand.tool == Tool::polygon) {
        body.emplace();
        if (hand.tool == Tool::disc) body->shape = DiscDef{hand.size};
        else body->shape = RegularDef{hand.sides, hand.size};
        body->position = hand.is_pressed ? hand.pressed_at : hand.pointer;
        // Dragged away from where the button went down: that is its speed
        if (hand.is_pressed) body->velocity = (hand.pointer - hand.pressed_at) / k_seconds_of_arrow;
    }
    if (hand.tool == Tool::draw && hand.points.size() >= 3) body = drawn_body(hand.points);
    if (body) body->density = usual_density(stage.run);
    return body;
}

std::string fault_of_new(const Stage& stage, const BodyDef& body)
{
    const Expected<Shape> shape = make_shape(body.shape);
    if (!shape) return format_fault(shape.faults().front());
    const Pose pose{body.position, Rotation::of(body.angle)};
    const std::optional<std::string> thing = obstacle(stage.run.world(), shape.value(), pose, -1);
    return thing ? "No room: it would overlap " + *thing : std::string();
}

void close_drawing(Stage& stage)
{
    Hand& hand = stage.hand;
    if (hand.points.empty()) return;
    const Expected<CentredPolygon> polygon = make_polygon(hand.points);
    if (!polygon) {
        const Fault& fault = polygon.faults().front();
        stage.say("No polygon yet: " + rounded_numbers(fault.found + ", expected " + fault.expected), true);
        return;
    }
    const std::optional<BodyDef> body = new_body(stage);
    if (!body) return;
    if (const std::string fault = fault_of_new(stage, *body); !fault.empty()) {
        stage.say(fault, true);
        return;
    }
    Scene scene = stage.run.scene_now();
    scene.bodies.push_back(*body);
    stage.run.begin_stroke();
    if (stage.change(std::move(scene), "draw", Crowding::refuse)) {
        hand.points.clear();
        hand.selected = stage.run.world().body_count() - 1;
    }
    stage.run.begin_stroke();
}

} // namespace flying
