// What each layer of the window costs, without a window: 500 polygons at 1280 x 800, or a scene that is named.
//
//   flying_layers [SCENE]
//
// Milliseconds of a frame, for one layer after the other and for all at once: what it takes to move on, to paint in as
// many bands as the window does, and how much the processors work on that, all bands together. Medians; other programs
// that run besides make the first two longer, unless the real-time scheduler puts them off (chrt -r 5), but not the
// work.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "play/paint_stage.hpp"
#include "play/seconds.hpp"
#include "play/stage.hpp"
#include "scene/generate.hpp"
#include "scene/read.hpp"

namespace {

using namespace flying;

constexpr SurfaceSize k_size{1280, 800};
constexpr int k_before = 60; ///< frames that aren't counted: trails and strips fill
constexpr int k_frames = 120;

double quantile(std::vector<double>& values, double share)
{
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size()));
    std::nth_element(values.begin(), place, values.end());
    return 1e3 * *place;
}

void measure(Stage& stage, cairo_surface_t* surface, const std::string& what)
{
    std::vector<double> moving;
    std::vector<double> painting;
    std::vector<double> work;
    for (int k = 0; k < k_before + k_frames; ++k) {
        const double started = seconds_now();
        stage.advance(stage.clock.frame, seconds_now);
        const double moved = seconds_now();
        const std::clock_t worked = std::clock();
        paint_stage(surface, stage, k_size, usual_bands());
        const double painted = seconds_now();
        if (k < k_before) continue;
        moving.push_back(moved - started);
        painting.push_back(painted - moved);
        work.push_back(static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC);
    }
    std::printf("%-22s %8.2f %8.2f %8.2f\n", what.c_str(), quantile(moving, 0.5), quantile(painting, 0.5),
                quantile(work, 0.5));
}

} // namespace

int main(int count, char** words)
{
    GenerateOptions options;
    options.count = 500;
    options.shape = "polygon";
    options.seed = 1;
    Expected<Scene> scene = count > 1 ? read_scene_file(words[1]) : generate("gas", options);
    Expected<Stage> opened = scene ? Stage::open(std::move(scene).value()) : Expected<Stage>(scene.faults());
    if (!opened) {
        std::fprintf(stderr, "flying_layers: %s\n", opened.faults().front().found.c_str());
        return 2;
    }
    Stage stage = std::move(opened).value();
    stage.size = k_size;
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, k_size.width, k_size.height);
    std::printf("%-22s %8s %8s %8s\n", "[ms]", "moving", "painting", "work");
    measure(stage, surface, "no layer");
    for (std::size_t k = 0; k < k_layers; ++k) {
        const auto layer = static_cast<Layer>(k);
        if (layer == Layer::help) continue; // covers all the rest
        stage.look.toggle(layer);
        measure(stage, surface, std::string(layer_text(layer)));
        stage.look.toggle(layer);
    }
    for (std::size_t k = 0; k < k_layers; ++k) stage.look.layers[k] = static_cast<Layer>(k) != Layer::help;
    measure(stage, surface, "all but help");
    cairo_surface_destroy(surface);
    return 0;
}
