#include "play/paint_stage.hpp"

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
    paint_hand(cairo, stage, map, theme);
    paint_figures(cairo, stage, size, theme);
    paint_panels(cairo, stage, size, theme);
    cairo_restore(cairo);
}

} // namespace flying
