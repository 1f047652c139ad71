#pragma once

#include <cstdio>
#include <string>

/// The text with the fewest significant digits that reads back as the same double, to the
/// bit. x  finite
inline std::string shortest(double x)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    return text; // loses nothing, and is too long: your code here
}
