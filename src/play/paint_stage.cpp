#include "play/paint_stage.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <vector>

#include "play/paint_figures.hpp"
#include "play/paint_hand.hpp"
#include "play/paint_layers.hpp"
#include "play/panels.hpp"

namespace flying {

Theme stage_theme(const Stage& stage)
{
    return stage.look.is_dark ? night_theme() : paper_theme();
}

ViewMap stage_map(const Stage& stage, SurfaceSize size)
{
    return view_map(stage.picture, size);
}

void paint_stage(cairo_t* cairo, const Stage& stage, SurfaceSize size)
{
    const Theme theme = stage_theme(stage);
    paint(cairo, stage.picture, size, theme);
    cairo_new_path(cairo); // the caption has left its end as the present point
    const ViewMap map = stage_map(stage, size);
    cairo_save(cairo);
    paint_faces(cairo, stage, map);
    paint_layers(cairo, stage, map, theme);
    paint_hand(cairo, stage, size, map, theme);
    paint_figures(cairo, stage, size, theme);
    paint_panels(cairo, stage, size, theme);
    cairo_restore(cairo);
}

namespace {

/// Orders of the colours within a pixel. Letters in shades of grey look the same in all of them.
constexpr cairo_subpixel_order_t k_orders[] = {CAIRO_SUBPIXEL_ORDER_RGB, CAIRO_SUBPIXEL_ORDER_BGR,
                                               CAIRO_SUBPIXEL_ORDER_VRGB, CAIRO_SUBPIXEL_ORDER_VBGR};
constexpr int k_most_bands = static_cast<int>(std::size(k_orders));

/// Gives a band fonts of its own. Cairo (1.16) keeps a font by its options for all threads; when one gives it back,
/// Cairo asserts that it isn't in use, but by then another may have taken it up.
void use_own_fonts(cairo_t* cairo, int band)
{
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_subpixel_order(options, k_orders[band]);
    cairo_set_font_options(cairo, options);
    cairo_font_options_destroy(options);
}

} // namespace

std::jthread start_thread(const std::function<void(int)>& paint_band, int band)
{
    return std::jthread(paint_band, band);
}

void paint_stage(cairo_surface_t* image, const Stage& stage, SurfaceSize size, int bands, StartThread* start)
{
    bands = std::clamp(bands, 1, k_most_bands);
    cairo_surface_flush(image);
    unsigned char* pixels = cairo_image_surface_get_data(image);
    if (!pixels) return; // there was no memory for it
    const int stride = cairo_image_surface_get_stride(image);
    const std::function<void(int)> paint_band = [&](int band) {
        const int top = band * size.height / bands;
        const int rows = (band + 1) * size.height / bands - top;
        if (rows == 0) return;
        cairo_surface_t* part = cairo_image_surface_create_for_data(pixels + static_cast<std::ptrdiff_t>(top) * stride,
                                                                    CAIRO_FORMAT_RGB24, size.width, rows, stride);
        cairo_surface_set_device_offset(part, 0.0, -top);
        cairo_t* cairo = cairo_create(part);
        use_own_fonts(cairo, band);
        paint_stage(cairo, stage, size);
        cairo_destroy(cairo);
        cairo_surface_destroy(part);
    };
    std::vector<std::jthread> others;
    int band = 1;
    try {
        for (; band < bands; ++band) others.push_back(start(paint_band, band));
    } catch (const std::system_error&) {
        // No more threads to be had: all the rest is for this one
    }
    paint_band(0);
    for (; band < bands; ++band) paint_band(band);
    others.clear(); // waits for them
    cairo_surface_mark_dirty(image);
}

int usual_bands()
{
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, k_most_bands);
}

} // namespace flying
