#include "play/paint_hand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "draw/body_path.hpp"
#include "geometry/make_polygon.hpp"
#include "play/brush.hpp"
#include "play/pick.hpp"
#include "world/make_shape.hpp"

namespace flying {

namespace {

constexpr double k_note_letters = 13.0; ///< [pixels]

void move_to(cairo_t* cairo, const Vec2& at) { cairo_move_to(cairo, at.x(), at.y()); }
void line_to(cairo_t* cairo, const Vec2& at) { cairo_line_to(cairo, at.x(), at.y()); }

void dash(cairo_t* cairo, bool dashed)
{
    const double lengths[] = {6.0, 5.0};
    cairo_set_dash(cairo, lengths, dashed ? 2 : 0, 0.0);
}

/// A few words beside a point, below and to the right of it; where the surface ends, as far to the left as they need, and
/// above it.
void paint_words(cairo_t* cairo, SurfaceSize size, const Vec2& at, const std::string& words, const Theme& theme)
{
    brush::letters(cairo, k_note_letters);
    const double width = brush::text_width(cairo, words) + 16.0;
    const double height = 24.0;
    const double left = std::max(0.0, std::min(at.x() + 14.0, size.width - width));
    const double top = at.y() + 12.0 + height <= size.height ? at.y() + 12.0 : at.y() - 12.0 - height;
    const PixelBox box{left, top, left + width, top + height};
    brush::panel(cairo, box, theme);
    brush::use(cairo, theme.ink);
    brush::text(cairo, box.left + 8.0, box.top + 16.5, words);
}

void paint_selected(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    const int body = stage.hand.selected;
    if (body < 0 || body >= static_cast<int>(stage.picture.bodies.size())) return;
    add_body_path(cairo, stage.picture.bodies[static_cast<std::size_t>(body)], map, 0.0);
    brush::use(cairo, theme.ink);
    cairo_set_line_width(cairo, 2.5);
    cairo_stroke(cairo);
}

/// What there is to know of it, in the upper right corner.
void paint_facts(cairo_t* cairo, const Stage& stage, const Theme& theme)
{
    const int body = stage.hand.selected;
    const World& world = stage.run.world();
    if (body < 0 || body >= world.body_count() || !stage.hand.points.empty()) return; // a drawing needs the room
    const BodyState s = world.state(body);
    const Inertia inertia = stage.run.inertia(body);
    const char* movers[] = {"static", "flies: moved from impact to impact", "leans: moved by steps", "asleep"};
    std::vector<std::string> lines{body_label(world.scene(), body), movers[static_cast<int>(world.mover(body))]};
    if (!world.is_static(body)) {
        lines.push_back(fmt::format("mass {:.4g} kg, inertia {:.4g} kg m\u00b2", 1.0 / inertia.inv_mass, 1.0 / inertia.inv_moment_of_inertia));
        lines.push_back(fmt::format("speed {:.4g} m/s, spin {:.3g} rad/s", s.velocity.norm(), s.spin));
    }
    lines.push_back(fmt::format("at ({:.4g}, {:.4g}) m, angle {:.4g} rad", s.position.x(), s.position.y(), s.angle));
    brush::letters(cairo, k_note_letters);
    double width = 0.0;
    for (const std::string& line : lines) width = std::max(width, brush::text_width(cairo, line));
    const double right = stage.size.width - 14.0;
    const PixelBox box{right - width - 20.0, 14.0, right, 14.0 + 18.0 * static_cast<double>(lines.size()) + 14.0};
    brush::panel(cairo, box, theme);
    brush::use(cairo, theme.ink);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        brush::letters(cairo, k_note_letters, k == 0);
        brush::text(cairo, box.left + 10.0, box.top + 20.0 + 18.0 * static_cast<double>(k), lines[k]);
    }
}

void paint_grip(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    if (!stage.hand.grip) return;
    const BodyState s = stage.run.world().state(stage.hand.grip->body);
    const Vec2 held = map(s.position + Rotation::of(s.angle) * stage.hand.grip->local);
    const Vec2 to = map(stage.hand.pointer);
    brush::use(cairo, theme.ink, 0.8);
    cairo_set_line_width(cairo, 2.0);
    move_to(cairo, held);
    line_to(cairo, to);
    cairo_stroke(cairo);
    brush::dot(cairo, held, 4.0);
}

/// The pointer is still where a click has added what lies under it. That there's no room for another needn't be said yet.
bool has_just_added(const Stage& stage)
{
    const Hand& hand = stage.hand;
    return !hand.is_pressed && hand.pointer == hand.pressed_at && hand.selected >= 0 &&
           body_at(stage.run.world(), hand.pointer, 0.0) == hand.selected;
}

/// The body that a click would add, as a shadow of itself.
void paint_new(cairo_t* cairo, const Stage& stage, SurfaceSize size, const ViewMap& map, const Theme& theme)
{
    const Hand& hand = stage.hand;
    if (!hand.is_here || hand.tool == Tool::draw || has_just_added(stage)) return;
    const std::optional<BodyDef> body = new_body(stage);
    if (!body) return;
    const Expected<Shape> shape = make_shape(body->shape);
    if (!shape) return;
    const std::string fault = fault_of_new(stage, *body);
    const DrawnBody drawn{shape.value(), {body->position, Rotation::of(body->angle)}, 0, false, std::nullopt};
    add_body_path(cairo, drawn, map, 0.0);
    brush::use(cairo, fault.empty() ? brush::k_blue : brush::k_vermilion, 0.35);
    cairo_fill_preserve(cairo);
    brush::use(cairo, fault.empty() ? brush::k_blue : brush::k_vermilion);
    cairo_set_line_width(cairo, 2.0);
    dash(cairo, !fault.empty());
    cairo_stroke(cairo);
    dash(cairo, false);
    std::string words = fault;
    if (body->velocity.norm() > 0.0) {
        brush::use(cairo, theme.ink);
        brush::arrow(cairo, map(body->position), map(body->position + k_seconds_of_arrow * body->velocity), 2.5);
        if (fault.empty()) words = fmt::format("{:.3g} m/s", body->velocity.norm());
    }
    if (!words.empty()) paint_words(cairo, size, map(hand.pointer), words, theme);
}

/// The polygon so far; sides that cross are thick, and what is wrong is said.
void paint_drawing(cairo_t* cairo, const Stage& stage, SurfaceSize size, const ViewMap& map, const Theme& theme)
{
    const Hand& hand = stage.hand;
    if (hand.tool != Tool::draw) return;
    if (hand.points.empty()) {
        if (hand.is_here)
            paint_words(cairo, size, map(hand.pointer), "click the corners; close at the first one", theme);
        return;
    }
    std::vector<Vec2> points = hand.points;
    if (hand.is_here && points.back() != hand.pointer) points.push_back(hand.pointer);
    const std::vector<int> crossing = crossing_sides(points);

    cairo_set_line_width(cairo, 2.0);
    brush::use(cairo, brush::k_blue);
    for (const Vec2& point : points) line_to(cairo, map(point));
    cairo_stroke(cairo);
    for (const int side : crossing) {
        move_to(cairo, map(points[static_cast<std::size_t>(side)]));
        line_to(cairo, map(points[static_cast<std::size_t>(side) + 1]));
    }
    cairo_set_line_width(cairo, 5.0);
    brush::use(cairo, brush::k_vermilion);
    cairo_stroke(cairo);

    // Were it closed now
    std::string fault = crossing.empty() ? "" : "sides cross";
    if (points.size() >= 3) {
        const Expected<CentredPolygon> closed = make_polygon(points);
        const bool closes = closed.has_value();
        if (!closes && fault.empty()) fault = "the last side would cross another";
        if (closes) {
            BodyDef body;
            body.shape = PolygonDef{points, {}};
            body.position = closed.value().centroid;
            fault = fault_of_new(stage, body);
        }
        cairo_set_line_width(cairo, 2.0);
        brush::use(cairo, closes ? brush::k_blue : brush::k_vermilion);
        dash(cairo, true);
        move_to(cairo, map(points.back()));
        line_to(cairo, map(points.front()));
        cairo_stroke(cairo);
        dash(cairo, false);
    }
    brush::use(cairo, theme.ink);
    for (const Vec2& point : hand.points) brush::dot(cairo, map(point), 4.0);
    cairo_new_sub_path(cairo);
    const Vec2 first = map(hand.points.front());
    cairo_arc(cairo, first.x(), first.y(), 8.0, 0.0, 2.0 * std::numbers::pi);
    cairo_set_line_width(cairo, 1.5);
    cairo_stroke(cairo);
    if (!fault.empty()) paint_words(cairo, size, map(points.back()), fault, theme);
}

void paint_crosshair(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    if (!stage.hand.by_keys || !stage.hand.is_here) return;
    const Vec2 at = map(stage.hand.pointer);
    for (const Vec2& way : {Vec2(1.0, 0.0), Vec2(-1.0, 0.0), Vec2(0.0, 1.0), Vec2(0.0, -1.0)}) {
        move_to(cairo, at + 5.0 * way);
        line_to(cairo, at + 14.0 * way);
    }
    cairo_set_line_width(cairo, 4.0);
    brush::use(cairo, theme.paper);
    cairo_stroke_preserve(cairo);
    cairo_set_line_width(cairo, 2.0);
    brush::use(cairo, theme.ink);
    cairo_stroke(cairo);
}

} // namespace

void paint_hand(cairo_t* cairo, const Stage& stage, SurfaceSize size, const ViewMap& map, const Theme& theme)
{
    paint_selected(cairo, stage, map, theme);
    paint_grip(cairo, stage, map, theme);
    paint_new(cairo, stage, size, map, theme);
    paint_drawing(cairo, stage, size, map, theme);
    paint_crosshair(cairo, stage, map, theme);
    paint_facts(cairo, stage, theme);
}

} // namespace flying
