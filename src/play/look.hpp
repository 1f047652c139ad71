#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace flying {

/// What can be shown beside the bodies; each by itself.
enum class Layer
{
    arrows,    ///< velocity of every body
    contacts,  ///< points at which bodies touch
    normals,   ///< their normals
    impulses,  ///< what impacts and contacts push with
    boxes,     ///< bounding boxes
    cells,     ///< of the grid in which neighbours are found
    islands,   ///< bodies that touch each other
    next,      ///< impacts that come next
    trails,    ///< where bodies have been
    centroids, ///< centres of mass, and radii of gyration about them
    labels,    ///< names
    strips,    ///< energy and momentum against time
    plan,      ///< what the plan skips
    costs,     ///< what a frame costs
    help       ///< all keys
};
inline constexpr std::size_t k_layers = 15;

/// Where the fill of bodies comes from.
enum class Colouring
{
    number, ///< the palette, by the body's number
    random, ///< a hue by lot, lit like a ball
    mover   ///< what moves the body: events, steps, or nothing as it sleeps
};

/// How things are shown.
struct Look
{
    std::array<bool, k_layers> layers{};
    Colouring colouring = Colouring::number;
    bool is_dark = false;
    bool faces_turn = true; ///< pictures on bodies turn with them

    [[nodiscard]] bool shows(Layer layer) const { return layers[static_cast<std::size_t>(layer)]; }
    void toggle(Layer layer) { layers[static_cast<std::size_t>(layer)] = !layers[static_cast<std::size_t>(layer)]; }
};

/// In words, for widgets and messages: "contact points".
[[nodiscard]] std::string_view layer_text(Layer layer);

} // namespace flying
