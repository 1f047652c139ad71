#include "draw/paint.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/body_path.hpp"
#include "draw/layout.hpp"
#include "draw/trail_path.hpp"

namespace flying {

namespace {

constexpr double k_outline = 0.13;       ///< [units]
constexpr double k_shadow = 0.26;        ///< [units]
constexpr double k_lowest_shadow = 0.12; ///< under a small body [radii]
constexpr double k_wall = 0.9;           ///< [units]
constexpr double k_corner = 1.2;         ///< [units]
constexpr double k_letters = 1.75;       ///< [units]
constexpr double k_thinnest = 1.0;       ///< [pixels]
constexpr std::size_t k_crowd = 150;     ///< more things than this are drawn with coarser edges
constexpr double k_smallest_mark = 5.;   ///< radius under which a body carries no marks [pixels]

void use(cairo_t* cairo, const Colour& colour, double opacity = 1.0)
{
    cairo_set_source_rgba(cairo, colour.red, colour.green, colour.blue, opacity);
}

void rounded_box(cairo_t* cairo, const PixelBox& box, double radius)
{
    const double quarter = 0.5 * std::numbers::pi;
    cairo_new_sub_path(cairo);
    cairo_arc(cairo, box.right - radius, box.top + radius, radius, -quarter, 0.0);
    cairo_arc(cairo, box.right - radius, box.bottom - radius, radius, 0.0, quarter);
    cairo_arc(cairo, box.left + radius, box.bottom - radius, radius, quarter, 2.0 * quarter);
    cairo_arc(cairo, box.left + radius, box.top + radius, radius, 2.0 * quarter, 3.0 * quarter);
    cairo_close_path(cairo);
}

PixelBox mapped(const Aabb& box, const ViewMap& map)
{
    const Vec2 low = map(box.min);
    const Vec2 high = map(box.max);
    return {low.x(), high.y(), high.x(), low.y()};
}

/// Ground, paper and, where the scene has a box, its walls. Leaves the surface clipped to where the world is seen.
void paint_ground(cairo_t* cairo, const Picture& picture, const Layout& layout, const Theme& theme)
{
    use(cairo, theme.ground);
    cairo_paint(cairo);

    const PixelBox inside = picture.box ? mapped(*picture.box, layout.map) : layout.panel;
    if (picture.box) {
        const double wall = k_wall * layout.unit;
        const PixelBox outside{inside.left - wall, inside.top - wall, inside.right + wall, inside.bottom + wall};
        rounded_box(cairo, outside, 0.7 * wall);
        use(cairo, theme.wall);
        cairo_fill(cairo);
        cairo_rectangle(cairo, inside.left, inside.top, inside.width(), inside.height());
    } else {
        const double corner = std::min({k_corner * layout.unit, 0.5 * inside.width(), 0.5 * inside.height()});
        rounded_box(cairo, inside, corner);
    }
    use(cairo, theme.paper);
    cairo_fill_preserve(cairo);
    cairo_clip(cairo);
}

/// As one fill, so that no overlap shows.
/// shines  through those before it
void paint_trail(cairo_t* cairo, const Trail& trail, const ViewMap& map, const Theme& theme, bool shines)
{
    constexpr double k_strength = 0.22;
    add_trail_path(cairo, trail, map);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
    const Colour colour = body_colour(trail.colour, theme);
    if (shines) use(cairo, colour, k_strength);
    else use(cairo, mixed(theme.paper, colour, k_strength));
    cairo_fill(cairo);
}

/// A line from a disc's centre towards its rim, so that a turn shows.
void paint_radius(cairo_t* cairo, const Vec2& centre, const DrawnBody& body, double radius, double unit,
                  const Colour& colour)
{
    const Vec2 along(body.pose.rotation.cosine, -body.pose.rotation.sine);
    const Vec2 half = std::min(0.055 * radius, 0.13 * unit) * perp(along);
    const Vec2 end = centre + 0.8 * radius * along;
    for (const Vec2& corner : {Vec2(centre + half), Vec2(centre - half), Vec2(end - half), Vec2(end + half)}) {
        cairo_line_to(cairo, corner.x(), corner.y());
    }
    cairo_close_path(cairo);
    use(cairo, colour);
    cairo_fill(cairo);
}

/// About how thick a body is: twice its area over the length of its boundary.  [m]
double thickness_of(const Shape& shape)
{
    const auto* polygon = std::get_if<Polygon>(&shape);
    if (!polygon) return bounding_radius(shape);
    double twice_area = 0.0;
    double length = 0.0;
    for (const Edge& edge : polygon->edges()) {
        const Vec2& from = polygon->vertices()[static_cast<std::size_t>(edge.from)];
        const Vec2& to = polygon->vertices()[static_cast<std::size_t>(edge.to)];
        twice_area += cross(from, to);
        length += (to - from).norm();
    }
    return twice_area / length;
}

/// Dark fill under a smaller fill: strokes cost three times as much.
void paint_body(cairo_t* cairo, const DrawnBody& body, const Layout& layout, const Theme& theme)
{
    const Colour fill = body.fill ? *body.fill : body.is_static ? theme.body_static : body_colour(body.colour, theme);
    const Colour dark = outline_of(fill, theme);
    const double radius = bounding_radius(body.shape) * layout.map.scale;

    // A dot of its own colour is all that a tiny body can show
    if (radius < 2.0) {
        const Vec2 at = layout.map(body.pose.position);
        cairo_arc(cairo, at.x(), at.y(), std::max(radius, 0.8), 0.0, 2.0 * std::numbers::pi);
        use(cairo, fill);
        cairo_fill(cairo);
        return;
    }

    // A line of its own colour is all that a needle can show: it is never thinner than a pixel
    const double thickness = thickness_of(body.shape) * layout.map.scale;
    if (thickness < k_thinnest) {
        add_body_path(cairo, body, layout.map, 0.0);
        use(cairo, fill);
        cairo_set_line_width(cairo, k_thinnest - 0.5 * thickness);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_BEVEL);
        cairo_stroke(cairo);
        return;
    }

    const double outline = std::min(k_outline * layout.unit, 0.14 * radius);
    const OutlineKind kind = add_body_path(cairo, body, layout.map, 0.0);
    use(cairo, dark);
    if (kind == OutlineKind::by_inset) {
        cairo_fill(cairo);
        if (add_body_path(cairo, body, layout.map, outline) == OutlineKind::too_thin) {
            cairo_new_path(cairo);
            add_body_path(cairo, body, layout.map, 0.0);
        }
        use(cairo, fill);
        cairo_fill(cairo);
    } else {
        // Half of a stroke lies inside: clip away the half outside, which would show the body too large
        cairo_save(cairo);
        cairo_path_t* path = cairo_copy_path(cairo);
        cairo_clip(cairo);
        use(cairo, fill);
        cairo_paint(cairo);
        cairo_append_path(cairo, path);
        cairo_path_destroy(path);
        use(cairo, dark);
        cairo_set_line_width(cairo, 2.0 * outline);
        cairo_stroke(cairo);
        cairo_restore(cairo);
    }
    if (std::holds_alternative<Disc>(body.shape) && radius >= k_smallest_mark) {
        paint_radius(cairo, layout.map(body.pose.position), body, radius, layout.unit, mixed(fill, dark, 0.75));
    }
}

void paint_shadow(cairo_t* cairo, const DrawnBody& body, const Layout& layout)
{
    const double radius = bounding_radius(body.shape) * layout.map.scale;
    if (radius < k_smallest_mark) return;
    ViewMap lower = layout.map;
    lower.origin += Vec2(0.0, std::min(k_shadow * layout.unit, k_lowest_shadow * radius));
    add_body_path(cairo, body, lower, 0.0);
    cairo_set_source_rgba(cairo, 0.0, 0.0, 0.0, 0.12);
    cairo_fill(cairo);
}

/// The part of the world that shows through the clip, and a pixel around it.
Aabb sight_of(cairo_t* cairo, const ViewMap& map)
{
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;
    cairo_clip_extents(cairo, &left, &top, &right, &bottom);
    return {map.world_at(Vec2(left - 1.0, bottom + 1.0)), map.world_at(Vec2(right + 1.0, top - 1.0))};
}

/// Its shadow included.
bool is_in_sight(const DrawnBody& body, const Aabb& sight)
{
    if (std::holds_alternative<HalfPlane>(body.shape)) return false;
    Aabb box = bounding_box(body.shape, body.pose);
    box.min.y() -= k_lowest_shadow * bounding_radius(body.shape);
    return overlap(box, sight);
}

bool is_in_sight(const Trail& trail, const Aabb& sight)
{
    if (trail.points.empty()) return false;
    Aabb box{trail.points.front(), trail.points.front()};
    for (const Vec2& point : trail.points) box = joined(box, {point, point});
    const Vec2 half = Vec2::Constant(0.5 * trail.width);
    return overlap({box.min - half, box.max + half}, sight);
}

/// Title above; scale bar and time below.
void paint_writing(cairo_t* cairo, const Picture& picture, const Layout& layout, SurfaceSize size, const Theme& theme)
{
    const double unit = layout.unit;
    const PixelBox& panel = layout.panel;
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, k_letters * unit);
    use(cairo, theme.ink, 0.85);

    if (!picture.title.empty()) {
        cairo_move_to(cairo, panel.left, panel.top - 2.1 * unit);
        cairo_show_text(cairo, picture.title.c_str());
    }
    const double base = size.height - 1.5 * unit;
    if (picture.time) {
        const std::string text = time_text(*picture.time);
        cairo_text_extents_t extents{};
        cairo_text_extents(cairo, text.c_str(), &extents);
        cairo_move_to(cairo, panel.right - extents.x_advance, base);
        cairo_show_text(cairo, text.c_str());
    }
    if (picture.has_scale_bar) {
        const double length = round_length(0.2 * panel.width() / layout.map.scale);
        const double width = length * layout.map.scale;
        const double middle = base - 0.62 * unit;
        cairo_rectangle(cairo, panel.left, middle - 0.1 * unit, width, 0.2 * unit);
        cairo_rectangle(cairo, panel.left, middle - 0.6 * unit, 0.2 * unit, 1.2 * unit);
        cairo_rectangle(cairo, panel.left + width - 0.2 * unit, middle - 0.6 * unit, 0.2 * unit, 1.2 * unit);
        cairo_fill(cairo);
        cairo_move_to(cairo, panel.left + width + unit, base);
        cairo_show_text(cairo, length_text(length).c_str());
    }
}

} // namespace

void smooth_edges(cairo_t* cairo, std::size_t things)
{
    const bool is_crowd = things > k_crowd;
    cairo_set_antialias(cairo, is_crowd ? CAIRO_ANTIALIAS_FAST : CAIRO_ANTIALIAS_DEFAULT);
    cairo_set_tolerance(cairo, is_crowd ? 0.3 : 0.1);
}

void paint(cairo_t* cairo, const Picture& picture, SurfaceSize size, const Theme& theme)
{
    const Layout layout = layout_of(picture, size);

    cairo_save(cairo);
    paint_ground(cairo, picture, layout, theme);
    const Aabb sight = sight_of(cairo, layout.map);
    smooth_edges(cairo, picture.trails.size());
    for (const Trail& trail : picture.trails) {
        if (is_in_sight(trail, sight)) paint_trail(cairo, trail, layout.map, theme, picture.trails_shine);
    }
    smooth_edges(cairo, 0);
    for (const DrawnBody& body : picture.bodies) {
        if (picture.has_shadows && is_in_sight(body, sight)) paint_shadow(cairo, body, layout);
    }
    for (const DrawnBody& body : picture.bodies) {
        if (is_in_sight(body, sight)) paint_body(cairo, body, layout, theme);
    }
    cairo_restore(cairo);

    cairo_save(cairo);
    paint_writing(cairo, picture, layout, size, theme);
    cairo_restore(cairo);
}

} // namespace flying

#ifdef FLYING_SANITIZED
/// What fontconfig keeps until the program ends is no leak of ours; the leak checker asks for this by name.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions()
{
    return "leak:libfontconfig\n";
}
#endif
