#pragma once

#include "draw/paint.hpp"

namespace flying {

/// A rectangle of the surface, y down.  [pixels]
struct PixelBox
{
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;
    [[nodiscard]] double width() const { return right - left; }
    [[nodiscard]] double height() const { return bottom - top; }
};

/// What goes where on a surface.
struct Layout
{
    double unit = 1.0; ///< a hundredth of the longer side; all of the decoration is measured by it [pixels]
    PixelBox panel;    ///< where the world is seen
    ViewMap map;
};

[[nodiscard]] Layout layout_of(const Picture& picture, SurfaceSize size);

/// The greatest of 1, 2 or 5 times a power of ten that is not over `length`.
/// length  positive and finite  [m]
[[nodiscard]] double round_length(double length);

/// A length as people write it: "2 m", "50 cm", "1e+12 m".
/// length  positive, as `round_length` gives  [m]
[[nodiscard]] std::string length_text(double length);

/// A time for a caption: "t = 2.50 s"; very short and very long ones by powers of ten.
/// time  finite  [s]
[[nodiscard]] std::string time_text(double time);

} // namespace flying
