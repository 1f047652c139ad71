#include <cairo.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <vector>

#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

constexpr SurfaceSize k_size{400, 301};

struct Destroy
{
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};

/// One thread can be had, then no more.
std::jthread start_one(const std::function<void(int)>& paint_band, int band)
{
    if (band == 1) return start_thread(paint_band, band);
    throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
}

/// All bytes of the picture, painted in so many bands.
std::vector<int> painted(const Stage& stage, int bands, StartThread* start = start_thread)
{
    const std::unique_ptr<cairo_surface_t, Destroy> image(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, k_size.width, k_size.height));
    paint_stage(image.get(), stage, k_size, bands, start);
    REQUIRE(cairo_surface_status(image.get()) == CAIRO_STATUS_SUCCESS);
    std::vector<int> bytes;
    for (int y = 0; y < k_size.height; ++y) {
        const unsigned char* row =
            cairo_image_surface_get_data(image.get()) + y * cairo_image_surface_get_stride(image.get());
        for (int x = 0; x < 4 * k_size.width; ++x) {
            if (x % 4 != 3) bytes.push_back(row[x]); // the fourth byte of a pixel means nothing
        }
    }
    return bytes;
}

/// Bytes that look otherwise where the pointer is over the stage.
int bytes_of_the_hand(Stage& stage)
{
    stage.hand.is_here = true;
    const std::vector<int> with = painted(stage, 1);
    stage.hand.is_here = false;
    const std::vector<int> without = painted(stage, 1);
    int others = 0;
    for (std::size_t k = 0; k < with.size(); ++k) others += with[k] != without[k];
    return others;
}

/// Where a band cuts a slanting edge, the edge is rounded anew, by less than a quarter of a pixel: two of the sixteen
/// shades that edges have in a crowd.
void check_bands(const Stage& stage)
{
    constexpr int k_slight = 32;
    const std::vector<int> whole = painted(stage, 1);
    for (const int bands : {2, 3, 4}) {
        CAPTURE(bands);
        const std::vector<int> parts = painted(stage, bands);
        int largest = 0;
        int others = 0;
        for (std::size_t k = 0; k < whole.size(); ++k) {
            const int off = std::abs(whole[k] - parts[k]);
            largest = std::max(largest, off);
            others += off > 0;
        }
        CHECK(largest <= k_slight);
        // Three bytes a pixel, some pixels where a thing crosses a border
        CHECK(others < 100 * bands);
    }
}

/// A disc with a colour for each quarter, as a picture for balls.
std::shared_ptr<cairo_surface_t> quarters()
{
    std::shared_ptr<cairo_surface_t> face(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, 64, 64),
                                          cairo_surface_destroy);
    cairo_t* cairo = cairo_create(face.get());
    for (int k = 0; k < 4; ++k) {
        cairo_set_source_rgb(cairo, k % 2, k / 2, 0.5);
        cairo_rectangle(cairo, 32.0 * (k % 2), 32.0 * (k / 2), 32.0, 32.0);
        cairo_fill(cairo);
    }
    cairo_destroy(cairo);
    return face;
}

} // namespace

TEST_CASE("painted in bands, a stage with all its layers looks as when it is painted at once")
{
    Stage stage = stage_of(gas(160));
    for (std::size_t k = 0; k < k_layers; ++k) stage.look.layers[k] = static_cast<Layer>(k) != Layer::help;
    play(stage, 0.6);
    check_bands(stage);
    stage.look.is_dark = true;
    check_bands(stage);
}

TEST_CASE("painted in bands, few bodies with shadows, faces, a ship and the help look as when they are painted at once")
{
    Stage stage = stage_of(three_bodies());
    stage.face = quarters();
    play(stage, 0.5);
    REQUIRE(press(stage, "ctrl+up"));
    play(stage, 0.1);
    check_bands(stage);
    REQUIRE(press(stage, "f1"));
    check_bands(stage);
    stage.face.reset();
    REQUIRE(press(stage, "u"));
    check_bands(stage);
}

TEST_CASE("where a thread can't be had, the bands that are left are painted all the same")
{
    Stage stage = stage_of(three_bodies());
    play(stage, 0.5);
    for (const int bands : {2, 3, 4}) {
        CAPTURE(bands);
        CHECK(painted(stage, bands, start_one) == painted(stage, bands));
    }
}

TEST_CASE("what a click has just added isn't in the way of another before the pointer moves on")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "p");
    press(stage, "2");
    point(stage, {8.0, 2.0});
    press_button(stage, Button::left);
    release_button(stage);
    REQUIRE(stage.run.world().body_count() == 4);
    CHECK(bytes_of_the_hand(stage) == 0);
    point(stage, {8.1, 2.0});
    CHECK(bytes_of_the_hand(stage) > 0);
}

TEST_CASE("words beside the pointer stay on the surface")
{
    Scene scene;
    scene.world.box = BoxDef{{0.0, 0.0}, {10.0, 8.0}};
    Stage stage = stage_of(scene);
    stage.size = k_size;
    press(stage, "4");
    point_at(stage, {40.0, 100.0}, 0.0);
    const int all = bytes_of_the_hand(stage);
    CHECK(all > 1000);
    for (const Vec2& pixel : {Vec2(395.0, 100.0), Vec2(40.0, 298.0), Vec2(395.0, 298.0)}) {
        point_at(stage, pixel, 0.0);
        // What lies under them counts where it is of another colour than their panel
        CHECK(bytes_of_the_hand(stage) > 0.6 * all);
    }
}
