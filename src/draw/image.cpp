#include "draw/image.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <algorithm>
#include <memory>
#include <new>

namespace flying {

namespace {

struct Destroy
{
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
using Surface = std::unique_ptr<cairo_surface_t, Destroy>;
using Context = std::unique_ptr<cairo_t, Destroy>;

/// Called back by Cairo with the next bytes; C code stands in between, so nothing may be thrown through.
cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length)
{
    try {
        static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

Surface make_surface(ImageFormat format, SurfaceSize size, std::string& bytes)
{
    switch (format) {
    case ImageFormat::svg:
        return Surface(cairo_svg_surface_create_for_stream(append, &bytes, size.width, size.height));
    case ImageFormat::pdf:
        return Surface(cairo_pdf_surface_create_for_stream(append, &bytes, size.width, size.height));
    case ImageFormat::png:
        break;
    }
    return Surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height));
}

} // namespace

std::optional<ImageFormat> image_format(std::string_view path)
{
    if (path.size() < 4) return std::nullopt;
    std::string ending(path.substr(path.size() - 4));
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending == ".png") return ImageFormat::png;
    if (ending == ".svg") return ImageFormat::svg;
    if (ending == ".pdf") return ImageFormat::pdf;
    return std::nullopt;
}

Expected<std::string> render_image(const Picture& picture, ImageFormat format, SurfaceSize size, const Theme& theme)
{
    std::string bytes;
    const Surface surface = make_surface(format, size, bytes);
    {
        const Context cairo(cairo_create(surface.get()));
        paint(cairo.get(), picture, size, theme);
        if (const cairo_status_t status = cairo_status(cairo.get()); status != CAIRO_STATUS_SUCCESS) {
            return Fault{"", cairo_status_to_string(status), ""};
        }
    }
    cairo_status_t status = CAIRO_STATUS_SUCCESS;
    if (format == ImageFormat::png) status = cairo_surface_write_to_png_stream(surface.get(), append, &bytes);
    cairo_surface_finish(surface.get());
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface.get());
    if (status != CAIRO_STATUS_SUCCESS) return Fault{"", cairo_status_to_string(status), ""};
    return bytes;
}

} // namespace flying
