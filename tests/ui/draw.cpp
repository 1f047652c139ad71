#include <cairo.h>
#include <doctest/doctest.h>

#include <cmath>

#include "draw/image.hpp"
#include "draw/layout.hpp"

using namespace flying;

namespace {

/// A frame of 4 m with a hole of 2 m, in a view of 10 m.
Picture frame_with_hole()
{
    const Polygon frame(
        {{Vec2(-2, -2), Vec2(2, -2), Vec2(2, 2), Vec2(-2, 2)}, {Vec2(-1, -1), Vec2(-1, 1), Vec2(1, 1), Vec2(1, -1)}});
    Picture picture;
    picture.bodies.push_back({frame, Pose{}, 0, false});
    picture.box = Aabb{Vec2(-5, -5), Vec2(5, 5)};
    picture.view = fitting_view(picture);
    return picture;
}

/// The colour that a picture has at a point of the world, 0xRRGGBB.
unsigned colour_at(const Picture& picture, const Vec2& world)
{
    const SurfaceSize size = fitting_size(picture, 400);
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height);
    cairo_t* cairo = cairo_create(surface);
    paint(cairo, picture, size, paper_theme());
    cairo_surface_flush(surface);
    const Vec2 at = view_map(picture, size)(world);
    const unsigned char* row =
        cairo_image_surface_get_data(surface) + static_cast<long>(at.y()) * cairo_image_surface_get_stride(surface);
    const unsigned colour = reinterpret_cast<const unsigned*>(row)[static_cast<long>(at.x())] & 0xffffffu;
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    return colour;
}

unsigned code(const Colour& c)
{
    const auto byte = [](double part) { return static_cast<unsigned>(part * 255.0 + 0.5); };
    return byte(c.red) << 16 | byte(c.green) << 8 | byte(c.blue);
}

} // namespace

TEST_CASE("the hole of a polygon stays open, its body is filled")
{
    const Picture picture = frame_with_hole();
    const Theme theme = paper_theme();
    CHECK(colour_at(picture, Vec2(0, 0)) == code(theme.paper));
    CHECK(colour_at(picture, Vec2(1.5, 0)) == code(body_colour(0, theme)));
    CHECK(colour_at(picture, Vec2(0, 1.5)) == code(body_colour(0, theme)));
    CHECK(colour_at(picture, Vec2(4, 4)) == code(theme.paper));
}

TEST_CASE("y points up, and a metre is as long across as upwards")
{
    Picture picture = frame_with_hole();
    picture.box = Aabb{Vec2(0, 0), Vec2(20, 5)};
    picture.view = fitting_view(picture);
    const SurfaceSize size = fitting_size(picture, 1000);
    const ViewMap map = view_map(picture, size);
    const Vec2 origin = map(Vec2(3, 2));
    CHECK(map(Vec2(4, 2)).x() - origin.x() == doctest::Approx(map.scale));
    CHECK(origin.y() - map(Vec2(3, 3)).y() == doctest::Approx(map.scale));
    // The whole box lies on the surface
    CHECK(map(Vec2(0, 5)).minCoeff() > 0.0);
    CHECK(map(Vec2(20, 0)).x() < size.width);
    CHECK(map(Vec2(20, 0)).y() < size.height);
}

TEST_CASE("without a box the view holds all that moves, and not all of a long floor")
{
    Picture picture;
    const Polygon floor({{Vec2(-1e6, -1), Vec2(1e6, -1), Vec2(1e6, 0), Vec2(-1e6, 0)}});
    picture.bodies.push_back({floor, Pose{}, 0, true});
    picture.bodies.push_back({Disc{1.0}, Pose{Vec2(-3, 1), {}}, 1, false});
    picture.bodies.push_back({Disc{1.0}, Pose{Vec2(7, 5), {}}, 2, false});
    const Aabb view = fitting_view(picture);
    CHECK(view.min.x() <= -4.0);
    CHECK(view.max.x() >= 8.0);
    CHECK(view.max.y() >= 6.0);
    CHECK(view.max.x() - view.min.x() < 20.0);
    picture.view = view;
    // The floor is drawn where it is near, though its ends are millions of pixels away
    CHECK(colour_at(picture, Vec2(0, -0.3)) == code(paper_theme().body_static));
}

TEST_CASE("pictures of nothing and of very small and very large worlds can be drawn")
{
    for (const double scale : {1e-30, 1.0, 1e30}) {
        Picture picture;
        picture.bodies.push_back({Disc{scale}, Pose{Vec2(scale, scale), {}}, 0, false});
        picture.view = fitting_view(picture);
        CAPTURE(scale);
        CHECK(render_image(picture, ImageFormat::png, fitting_size(picture, 200)).has_value());
    }
    Picture nothing;
    nothing.view = fitting_view(nothing);
    for (const ImageFormat format : {ImageFormat::png, ImageFormat::svg, ImageFormat::pdf}) {
        CHECK(render_image(nothing, format, fitting_size(nothing, 200)).has_value());
    }
}

TEST_CASE("a scale bar has a round length that people can read")
{
    CHECK(round_length(3.7) == doctest::Approx(2.0));
    CHECK(round_length(5.1) == doctest::Approx(5.0));
    CHECK(round_length(0.0123) == doctest::Approx(0.01));
    CHECK(length_text(2.0) == "2 m");
    CHECK(length_text(0.5) == "50 cm");
    CHECK(length_text(0.005) == "5 mm");
    CHECK(length_text(2000.0) == "2 km");
    CHECK(length_text(1e12) == "1e+12 m");
    CHECK(time_text(2.5) == "t = 2.50 s");
    CHECK(image_format("a.PNG") == ImageFormat::png);
    CHECK(!image_format("png"));
    CHECK(!image_format("a.jpg"));
}

TEST_CASE("a trail has one shade everywhere, along straight ways, round bends, and where it turns back over itself")
{
    Picture picture = frame_with_hole();
    picture.bodies.clear();
    const Theme theme = paper_theme();
    Trail trail{0, 1.0, {}};
    const auto go = [&](const Vec2& to) {
        const Vec2 from = trail.points.empty() ? to : trail.points.back();
        for (int k = 1; k <= 8; ++k) trail.points.push_back(from + k / 8.0 * (to - from));
    };
    go(Vec2(-4, -4));
    go(Vec2(4, -4));                // straight ...
    go(Vec2(4, 0));                 // ... round a corner ...
    for (int k = 1; k <= 24; ++k) { // ... round a bend ...
        const double turn = k / 24.0 * 3.141592653589793;
        trail.points.push_back(Vec2(2.0 + 2.0 * std::cos(turn), 2.0 * std::sin(turn)));
    }
    go(Vec2(0, -3));
    go(Vec2(0, 1)); // ... and back
    picture.trails = {trail};
    const unsigned shade = code(mixed(theme.paper, body_colour(0, theme), 0.22));
    const auto near_shade = [&](const Vec2& at) {
        const unsigned found = colour_at(picture, at);
        for (int part = 0; part < 24; part += 8) {
            const int off = static_cast<int>(found >> part & 0xffu) - static_cast<int>(shade >> part & 0xffu);
            if (off < -2 || off > 2) return false;
        }
        return true;
    };
    // Within it, and at most as much beside it as the widest place is wide
    for (const Vec2& at : {Vec2(1, -4), Vec2(3.9, -3.9), Vec2(4, -2), Vec2(2, 2),
                           Vec2(2 + std::sqrt(2.0), std::sqrt(2.0)), Vec2(0, -1), Vec2(0, 0.9)}) {
        CAPTURE(at.transpose());
        CHECK(near_shade(at));
    }
    for (const Vec2& at : {Vec2(1, -3.2), Vec2(2, 0), Vec2(2, -2), Vec2(-4, -3.5), Vec2(-1, 0)}) {
        CAPTURE(at.transpose());
        CHECK(colour_at(picture, at) == code(theme.paper));
    }
}
