#pragma once

#include <span>
#include <string>
#include <string_view>

#include "play/stage.hpp"

namespace flying {

/// One key and what it does. The same table serves the keyboard, the help and the tests.
struct Binding
{
    std::string_view keys;  ///< names with a blank between them: "p space"; modifiers first: "ctrl+z", "shift+left"
    std::string_view shown; ///< as the help shows them: "P, space"
    std::string_view what;  ///< what it does, in a few words
    void (*act)(Stage&) = nullptr;
};

/// All keys that the stage itself answers, in the order of the help.
[[nodiscard]] std::span<const Binding> bindings();

/// A key is pressed.
/// key  lower case, as X names it ("period", "F1"), modifiers before it in the order ctrl+, alt+, shift+
/// False where it means nothing here.
bool press(Stage& stage, std::string_view key);

} // namespace flying
