#include "draw/palette.hpp"

#include <array>
#include <cmath>

namespace flying {

namespace {

/// 0xRRGGBB as a colour.
constexpr Colour rgb(int code)
{
    return {((code >> 16) & 0xff) / 255.0, ((code >> 8) & 0xff) / 255.0, (code & 0xff) / 255.0};
}

// Earth and water: neighbours in the list differ in hue and in weight, so that bodies met one after another part well
constexpr std::array k_hues{rgb(0xd1603d), rgb(0x2f7f86), rgb(0xe3a83b), rgb(0x4f6fa8), rgb(0x7fa36b),
                            rgb(0x94587f), rgb(0xe08e79), rgb(0x5ba8a0), rgb(0xb98a50), rgb(0x7d84b8)};

} // namespace

Colour mixed(const Colour& a, const Colour& b, double share)
{
    const double rest = 1.0 - share;
    return {rest * a.red + share * b.red, rest * a.green + share * b.green, rest * a.blue + share * b.blue};
}

Theme paper_theme()
{
    return {rgb(0xf3ede1), rgb(0xfcf9f2), rgb(0x8d949c), rgb(0xa3a9af), rgb(0x2c2d38), 0.0};
}

Theme night_theme()
{
    return {rgb(0x12161f), rgb(0x1a202c), rgb(0x4a5361), rgb(0x667080), rgb(0xe6e2d8), 0.12};
}

Colour body_colour(int index, const Theme& theme)
{
    const std::size_t round = static_cast<std::size_t>(index) / k_hues.size();
    const Colour hue = k_hues[static_cast<std::size_t>(index) % k_hues.size()];

    // Steps of the golden section never fall twice on one shade
    const double step = std::fmod(static_cast<double>(round) * 0.6180339887498949, 1.0);
    const Colour shade = mixed(hue, rgb(0xffffff), 0.3 * step);
    return mixed(shade, rgb(0xffffff), theme.lightness);
}

Colour outline_of(const Colour& fill, const Theme& theme)
{
    const bool is_dark_page = theme.ground.green < 0.5;
    return mixed(fill, is_dark_page ? theme.ground : theme.ink, 0.5);
}

} // namespace flying
