#pragma once

#include <functional>
#include <string>
#include <vector>

namespace flying::bench {

/// How fast this engine is at one size of a scene.
struct Rate
{
    int size = 0;            ///< bodies, or vertices of each
    double events = 0.0;     ///< handled a second of computing [1/s]
    double collisions = 0.0; ///< of these, impacts [1/s]
};

/// Collisions a second ~ factor * size^slope, by least squares of the logarithms.
struct PowerLaw
{
    double factor = 0.0;
    double slope = 0.0;
};

/// Rates against a size, and how they fall with it.
struct Growth
{
    std::string name; ///< of the data file
    std::string what; ///< in words
    std::vector<Rate> rates;
    PowerLaw all; ///< fitted to all sizes
    PowerLaw end; ///< fitted to the larger half of them, where small things no longer count
};

enum class Extent
{
    brief,
    full
};

/// Discs against their number, pentagons against their number, 200 regular polygons against their number of vertices.
[[nodiscard]] std::vector<Growth> measure_growth(Extent extent, const std::function<void(const std::string&)>& tell);

} // namespace flying::bench
