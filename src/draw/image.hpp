#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "draw/paint.hpp"
#include "math/expected.hpp"

namespace flying {

enum class ImageFormat
{
    png,
    svg,
    pdf
};

/// By the ending of a file's name, in either case; none for any other ending.
[[nodiscard]] std::optional<ImageFormat> image_format(std::string_view path);

/// A picture as the bytes of an image file. No file is touched.
/// size  in pixels (PNG), or in points (SVG, PDF)
/// Fault: what Cairo says it lacks, such as memory.
[[nodiscard]] Expected<std::string> render_image(const Picture& picture, ImageFormat format, SurfaceSize size,
                                                 const Theme& theme = paper_theme());

} // namespace flying
