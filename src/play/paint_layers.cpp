#include "play/paint_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "play/brush.hpp"

namespace flying {

namespace {

constexpr double k_normal = 16.0;       ///< length of a normal [pixels]
constexpr double k_push = 90.0;         ///< length of the longest push [pixels]
constexpr double k_head = 8.0;          ///< how far an arrow's head is from its line, at most [pixels]
constexpr double k_smallest_cell = 5.0; ///< [pixels]

void line(cairo_t* cairo, const Vec2& from, const Vec2& to)
{
    cairo_move_to(cairo, from.x(), from.y());
    cairo_line_to(cairo, to.x(), to.y());
}

/// The part of the surface that the clip lets through.  [pixels]
PixelBox sight_of(cairo_t* cairo)
{
    PixelBox sight;
    cairo_clip_extents(cairo, &sight.left, &sight.top, &sight.right, &sight.bottom);
    return sight;
}

/// Something about a point, so far out, may show.  reach  [pixels]
bool in_sight(const PixelBox& sight, const Vec2& at, double reach)
{
    return at.x() > sight.left - reach && at.y() > sight.top - reach && at.x() < sight.right + reach &&
           at.y() < sight.bottom + reach;
}

void dashes(cairo_t* cairo, double length)
{
    const double lengths[] = {length, length};
    cairo_set_dash(cairo, lengths, length > 0.0 ? 2 : 0, 0.0);
}

void paint_cells(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    const double size = stage.watch.inside.cell_size;
    if (!(size * map.scale >= k_smallest_cell)) return;
    const Vec2 low = map.world_at(Vec2(0.0, stage.size.height));
    const Vec2 high = map.world_at(Vec2(stage.size.width, 0.0));
    // By their numbers: far from the origin a cell more may be less than the rounding of its place
    const Vec2 first(std::ceil(low.x() / size), std::ceil(low.y() / size));
    for (int k = 0; (first.x() + k) * size <= high.x() && k < stage.size.width; ++k) {
        cairo_rectangle(cairo, std::round(map(Vec2((first.x() + k) * size, 0.0)).x()), 0.0, 1.0, stage.size.height);
    }
    for (int k = 0; (first.y() + k) * size <= high.y() && k < stage.size.height; ++k) {
        cairo_rectangle(cairo, 0.0, std::round(map(Vec2(0.0, (first.y() + k) * size)).y()), stage.size.width, 1.0);
    }
    brush::use(cairo, theme.ink, 0.22);
    cairo_fill(cairo);
}

/// Lines of whole pixels: they are sharp, and Cairo fills them without looking for their edges.
void paint_boxes(cairo_t* cairo, const Stage& stage, const ViewMap& map)
{
    const PixelBox sight = sight_of(cairo);
    for (const DrawnBody& body : stage.picture.bodies) {
        if (std::holds_alternative<HalfPlane>(body.shape)) continue;
        const Aabb box = bounding_box(body.shape, body.pose);
        const Vec2 low = map(box.min);
        const Vec2 high = map(box.max);
        const Vec2 middle = 0.5 * (low + high);
        const double width = std::round(high.x() - low.x());
        const double height = std::round(low.y() - high.y());
        if (width < 2.0 || height < 2.0 || !in_sight(sight, middle, 0.5 * std::max(width, height))) continue;
        const double left = std::round(low.x());
        const double top = std::round(high.y());
        cairo_rectangle(cairo, left, top, width, 1.0);
        cairo_rectangle(cairo, left, top + height - 1.0, width, 1.0);
        cairo_rectangle(cairo, left, top + 1.0, 1.0, height - 2.0);
        cairo_rectangle(cairo, left + width - 1.0, top + 1.0, 1.0, height - 2.0);
    }
    brush::use(cairo, brush::k_blue, 0.9);
    cairo_fill(cairo);
}

/// Bodies of one island are tied together; each island has a colour of its own.
void paint_islands(cairo_t* cairo, const Stage& stage, const ViewMap& map, const std::vector<LeaningContact>& contacts)
{
    constexpr Colour colours[] = {brush::k_blue,   brush::k_vermilion, brush::k_green,
                                  brush::k_purple, brush::k_orange,    brush::k_sky};
    const World& world = stage.run.world();
    const std::vector<int> groups = islands(world, contacts);
    const int count = world.body_count();
    const auto group = [&](int body) { return body < count ? groups[static_cast<std::size_t>(body)] : -1; };
    cairo_set_line_width(cairo, 3.0);
    for (int number = 0; number < static_cast<int>(std::size(colours)); ++number) {
        const auto has_this_colour = [&](int body) {
            return group(body) >= 0 && group(body) % static_cast<int>(std::size(colours)) == number;
        };
        brush::use(cairo, colours[number]);
        for (const LeaningContact& contact : contacts) {
            if (!has_this_colour(contact.a) || group(contact.a) != group(contact.b)) continue;
            line(cairo, map(world.state(contact.a).position), map(world.state(contact.b).position));
        }
        cairo_stroke(cairo);
        for (int k = 0; k < count; ++k) {
            if (has_this_colour(k) && !world.is_static(k)) brush::add_dot(cairo, map(world.state(k).position), 5.0);
        }
        cairo_fill(cairo);
    }
}

/// Opaque, and each by itself: two thirds of the work that all are in one path, with any transparency.
void paint_centroids(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    constexpr double k_line = 1.5; // [pixels]
    const World& world = stage.run.world();
    const PixelBox sight = sight_of(cairo);
    brush::use(cairo, mixed(theme.paper, theme.ink, 0.9));
    for (int k = 0; k < world.body_count(); ++k) {
        const Vec2 at = map(world.state(k).position);
        const Inertia& inertia = stage.run.inertia(k);
        const bool turns = inertia.inv_moment_of_inertia > 0.0;
        // Radius of gyration: a ring of the same mass and inertia
        const double radius = turns ? std::sqrt(inertia.inv_mass / inertia.inv_moment_of_inertia) * map.scale : 0.0;
        if (!in_sight(sight, at, radius + 5.0)) continue;
        cairo_rectangle(cairo, at.x() - 5.0, at.y() - 0.5 * k_line, 10.0, k_line);
        cairo_rectangle(cairo, at.x() - 0.5 * k_line, at.y() - 5.0, k_line, 10.0);
        if (turns) brush::add_circle(cairo, at, radius, k_line);
        cairo_fill(cairo);
    }
}

void paint_velocities(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    const World& world = stage.run.world();
    const PixelBox sight = sight_of(cairo);
    brush::use(cairo, mixed(theme.paper, theme.ink, 0.85));
    for (int k = 0; k < world.body_count(); ++k) {
        if (world.is_static(k)) continue;
        const BodyState body = world.state(k);
        const Vec2 from = map(body.position);
        const Vec2 to = map(body.position + k_seconds_of_arrow * body.velocity);
        if (in_sight(sight, from, (to - from).norm() + k_head)) brush::arrow(cairo, from, to, 2.0);
    }
}

/// A push as an arrow, as long as the root of its size: small and large ones are both seen.
void paint_push(cairo_t* cairo, const Vec2& at, const Vec2& push, double full, double width)
{
    const double size = push.norm();
    if (!(size > 0.0) || !(full > 0.0)) return;
    const double length = std::min(k_push, 70.0 * std::sqrt(size / full));
    brush::arrow(cairo, at, at + length / size * Vec2(push.x(), -push.y()), width);
}

void paint_contacts(cairo_t* cairo, const Look& look, const ViewMap& map, const std::vector<LeaningContact>& contacts)
{
    if (look.shows(Layer::normals)) {
        brush::use(cairo, brush::k_green);
        for (const LeaningContact& contact : contacts) {
            const Vec2 at = map(contact.point);
            brush::arrow(cairo, at, at + k_normal * Vec2(contact.normal.x(), -contact.normal.y()), 2.0);
        }
    }
    if (look.shows(Layer::impulses)) {
        double greatest = 0.0;
        for (const LeaningContact& contact : contacts) greatest = std::max(greatest, contact.normal_force);
        brush::use(cairo, brush::k_vermilion);
        for (const LeaningContact& contact : contacts) {
            const Vec2 force = contact.normal_force * contact.normal + contact.tangent_force * perp(contact.normal);
            paint_push(cairo, map(contact.point), force, greatest, 3.0);
        }
    }
    if (!look.shows(Layer::contacts)) return;
    for (const bool bears : {false, true}) {
        brush::use(cairo, bears ? brush::k_vermilion : brush::k_sky);
        for (const LeaningContact& contact : contacts) {
            if ((contact.normal_force > 0.0) == bears) brush::dot(cairo, map(contact.point), 3.5);
        }
    }
}

/// Impacts grow thin as they become past, until nothing is left of them; the latest lie on top.
void paint_impacts(cairo_t* cairo, const Stage& stage, const ViewMap& map)
{
    const Look& look = stage.look;
    double greatest = 0.0;
    for (const SeenImpact& impact : stage.watch.impacts) greatest = std::max(greatest, impact.push.norm());
    const PixelBox sight = sight_of(cairo);
    const auto shows = [&](const SeenImpact& impact, double reach) {
        return in_sight(sight, map(impact.point), reach);
    };
    const auto left_of = [&](const SeenImpact& impact) {
        return std::clamp(1.0 - (stage.now - impact.seen) / k_impact_fades, 0.0, 1.0);
    };
    if (look.shows(Layer::normals)) {
        brush::use(cairo, brush::k_green);
        for (const SeenImpact& impact : stage.watch.impacts) {
            const Vec2 at = map(impact.point);
            const double size = impact.push.norm();
            const double length = k_normal * left_of(impact);
            if (size > 0.0 && shows(impact, length + k_head))
                brush::arrow(cairo, at, at + length / size * Vec2(impact.push.x(), -impact.push.y()), 2.0);
        }
    }
    if (look.shows(Layer::impulses)) {
        brush::use(cairo, brush::k_vermilion);
        for (const SeenImpact& impact : stage.watch.impacts) {
            if (shows(impact, k_push + k_head))
                paint_push(cairo, map(impact.point), impact.push, greatest, 3.0 * left_of(impact));
        }
    }
    if (look.shows(Layer::contacts)) {
        brush::use(cairo, brush::k_purple);
        for (const SeenImpact& impact : stage.watch.impacts) {
            if (shows(impact, 6.0)) brush::dot(cairo, map(impact.point), 6.0 * left_of(impact));
        }
    }
}

/// Impacts that are foreseen: where the two will be when they meet, and in which order.
void paint_next(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    const World& world = stage.run.world();
    const std::vector<NextImpact>& impacts = stage.watch.next;
    brush::letters(cairo, 12.0, true);
    for (std::size_t k = 0; k < impacts.size(); ++k) {
        const NextImpact& impact = impacts[k];
        if (impact.time < world.time() || impact.a >= world.body_count()) continue;
        const double opacity = 1.0 - 0.7 * static_cast<double>(k) / static_cast<double>(impacts.size());
        const auto show_way = [&](int body, const Vec2& place) {
            dashes(cairo, 4.0);
            line(cairo, map(world.state(body).position), map(place));
            brush::use(cairo, brush::k_blue, opacity);
            cairo_set_line_width(cairo, 1.5);
            cairo_stroke(cairo);
            dashes(cairo, 0.0);
            brush::dot(cairo, map(place), 3.0);
        };
        show_way(impact.a, impact.place_a);
        Vec2 at = map(impact.place_a);
        if (impact.b < world.body_count() && !world.is_static(impact.b)) {
            show_way(impact.b, impact.place_b);
            at = 0.5 * (at + map(impact.place_b));
        }
        brush::use(cairo, theme.ink, opacity);
        brush::text(cairo, at.x() + 6.0, at.y() - 6.0, fmt::format("{}: {:.2f} s", k + 1, impact.time - world.time()));
    }
}

void paint_labels(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    const World& world = stage.run.world();
    brush::letters(cairo, 12.0);
    brush::Writing writing(cairo);
    const PixelBox sight = sight_of(cairo);
    for (int k = 0; k < world.body_count(); ++k) {
        const Vec2 at = map(world.state(k).position);
        if (!in_sight(sight, at, 60.0)) continue;
        const std::string& name = world.scene().bodies[static_cast<std::size_t>(k)].name;
        const double width = writing.add_about(at.x(), at.y() + 4.0, name.empty() ? std::to_string(k) : name);
        cairo_rectangle(cairo, std::round(at.x() - 0.5 * width - 3.0), std::round(at.y() - 8.0),
                        std::round(width + 6.0), 15.0);
    }
    brush::use(cairo, theme.paper, 0.75);
    cairo_fill(cairo);
    brush::use(cairo, theme.ink);
    writing.show();
}

/// The ship's arrow, and its flame as arcs behind it.
void paint_ship(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    const Ship& ship = stage.ship;
    if (ship.body < 0 || ship.body >= stage.run.world().body_count()) return;
    const Vec2 at = map(stage.run.world().state(ship.body).position);
    const double radius = std::max(8.0, bounding_radius(stage.run.world().shape(ship.body)) * map.scale);
    const Vec2 ahead(std::cos(ship.heading), -std::sin(ship.heading));
    if (ship.burns(stage.now)) {
        const double sign = ship.thrust > 0.0 ? -1.0 : 1.0;
        const double back = std::atan2(sign * ahead.y(), sign * ahead.x());
        const double flicker = 0.85 + 0.15 * std::sin(70.0 * stage.now);
        const int arcs = 2 + static_cast<int>(4.0 * std::abs(ship.thrust));
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
        for (int k = 0; k < arcs; ++k) {
            const double share = static_cast<double>(k) / arcs;
            const double out = radius * (1.2 + flicker * std::abs(ship.thrust) * 1.6 * share);
            const double half = 0.5 * (1.0 - share);
            cairo_new_sub_path(cairo);
            cairo_arc(cairo, at.x(), at.y(), out, back - half, back + half);
            brush::use(cairo, mixed(brush::k_yellow, brush::k_vermilion, 0.35 + 0.65 * share), 1.0 - 0.5 * share);
            cairo_set_line_width(cairo, std::max(2.0, 0.14 * radius));
            cairo_stroke(cairo);
        }
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    }
    brush::use(cairo, theme.paper);
    brush::arrow(cairo, at - 0.75 * radius * ahead, at + 1.15 * radius * ahead, 6.0);
    brush::use(cairo, theme.ink);
    brush::arrow(cairo, at - 0.7 * radius * ahead, at + 1.05 * radius * ahead, 3.0);
}

/// Another surface on the pixels of an image, for as long as that lives.
std::shared_ptr<cairo_surface_t> same_pixels(cairo_surface_t* image)
{
    cairo_surface_t* other =
        cairo_image_surface_create_for_data(cairo_image_surface_get_data(image), cairo_image_surface_get_format(image),
                                            cairo_image_surface_get_width(image), cairo_image_surface_get_height(image),
                                            cairo_image_surface_get_stride(image));
    return {other, cairo_surface_destroy};
}

} // namespace

void paint_layers(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    const Look& look = stage.look;
    const std::vector<LeaningContact>& contacts = stage.watch.contacts;
    smooth_edges(cairo, stage.picture.bodies.size());
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING); // of many in one path, none cuts out another
    if (look.shows(Layer::cells)) paint_cells(cairo, stage, map, theme);
    if (look.shows(Layer::boxes)) paint_boxes(cairo, stage, map);
    if (look.shows(Layer::islands)) paint_islands(cairo, stage, map, contacts);
    if (look.shows(Layer::centroids)) paint_centroids(cairo, stage, map, theme);
    if (look.shows(Layer::arrows)) paint_velocities(cairo, stage, map, theme);
    paint_ship(cairo, stage, map, theme);
    paint_contacts(cairo, look, map, contacts);
    paint_impacts(cairo, stage, map);
    if (look.shows(Layer::next)) paint_next(cairo, stage, map, theme);
    if (look.shows(Layer::labels)) paint_labels(cairo, stage, map, theme);
}

void paint_faces(cairo_t* cairo, const Stage& stage, const ViewMap& map)
{
    const World& world = stage.run.world();
    const bool lights = !stage.face && stage.look.colouring == Colouring::random;
    if (!stage.face && !lights) return;
    // On the same pixels, but a surface of its own: Cairo wants that no two threads use the same
    const std::shared_ptr<cairo_surface_t> face = lights ? nullptr : same_pixels(stage.face.get());
    for (int k = 0; k < world.body_count(); ++k) {
        const auto* disc = std::get_if<Disc>(&world.shape(k));
        if (!disc || world.is_static(k)) continue;
        const BodyState s = world.state(k);
        const Vec2 at = map(s.position);
        const double radius = disc->radius * map.scale;
        if (radius < 1.0 || radius > 1e4) continue;
        cairo_save(cairo);
        cairo_new_path(cairo);
        cairo_arc(cairo, at.x(), at.y(), radius, 0.0, 2.0 * std::numbers::pi);
        if (face) {
            const int width = cairo_image_surface_get_width(face.get());
            const int height = cairo_image_surface_get_height(face.get());
            const double side = std::min(width, height);
            cairo_clip(cairo);
            cairo_translate(cairo, at.x(), at.y());
            if (stage.look.faces_turn) cairo_rotate(cairo, -std::remainder(s.angle, 2.0 * std::numbers::pi));
            cairo_scale(cairo, 2.0 * radius / side, 2.0 * radius / side);
            cairo_set_source_surface(cairo, face.get(), -0.5 * width, -0.5 * height);
            cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_BILINEAR);
            cairo_paint(cairo);
        } else {
            cairo_pattern_t* light = cairo_pattern_create_radial(at.x() - 0.35 * radius, at.y() - 0.4 * radius,
                                                                 0.05 * radius, at.x(), at.y(), radius);
            cairo_pattern_add_color_stop_rgba(light, 0.0, 1.0, 1.0, 1.0, 0.75);
            cairo_pattern_add_color_stop_rgba(light, 0.55, 1.0, 1.0, 1.0, 0.05);
            cairo_pattern_add_color_stop_rgba(light, 1.0, 0.0, 0.0, 0.0, 0.28);
            cairo_set_source(cairo, light);
            cairo_fill(cairo);
            cairo_pattern_destroy(light);
        }
        cairo_restore(cairo);
    }
}

} // namespace flying
