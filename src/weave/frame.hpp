#pragma once

#include <string>

#include "weave/material.hpp"
#include "weave/pages.hpp"

namespace flying::weave {

/// A whole page: its head, the contents of the book beside it, and `body`, which is finished HTML. `root` leads from
/// the page's folder to the book's: empty, or `../`.
[[nodiscard]] std::string framed(const Material& material, const Page& page, const std::string& body,
                                 const std::string& root);

} // namespace flying::weave
