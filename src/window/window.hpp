#pragma once

#include <string>

#include "play/stage.hpp"

namespace flying {

/// How to open the window.
struct WindowOptions
{
    int width = 1280;  ///< > 0 [pixels]
    int height = 800;  ///< > 0
    std::string state; ///< where F8 writes what the window knows; empty for beside the scene
    std::string scene; ///< path of the scene, for saving beside it; empty where it has none
};

/// Show the stage in a window until it is closed. Returns the exit status of the program: 1, and a line on standard error,
/// where there is no display.
[[nodiscard]] int run_window(Stage stage, const WindowOptions& options);

} // namespace flying
