#include "play/paint_stage.hpp"

#include "play/brush.hpp"
#include "play/panels.hpp"

namespace flying {

namespace {

constexpr double k_seconds_of_arrow = 0.25; ///< an arrow shows the way that a body makes in this time [s]

void paint_velocities(cairo_t* cairo, const Stage& stage, const ViewMap& map, const Theme& theme)
{
    brush::use(cairo, theme.ink, 0.85);
    for (int k = 0; k < stage.run.world().body_count(); ++k) {
        if (stage.run.world().is_static(k)) continue;
        const BodyState body = stage.run.world().state(k);
        brush::arrow(cairo, map(body.position), map(body.position + k_seconds_of_arrow * body.velocity), 2.0);
    }
}

} // namespace

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
    const ViewMap map = stage_map(stage, size);
    cairo_save(cairo);
    if (stage.look.shows(Layer::arrows)) paint_velocities(cairo, stage, map, theme);
    paint_panels(cairo, stage, size, theme);
    cairo_restore(cairo);
}

} // namespace flying
