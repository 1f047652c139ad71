#pragma once

#include <cstdint>

namespace flying {

/// Work done so far, and work left out.
struct EventCounts
{
    std::int64_t events = 0;      ///< all that were handled
    std::int64_t impacts = 0;     ///< in which some point was pushed
    std::int64_t cells = 0;       ///< cells left
    std::int64_t looks = 0;       ///< pairs looked at again
    std::int64_t predictions = 0; ///< pairs predicted, all told
    std::int64_t stale = 0;       ///< events that had been overtaken
    std::int64_t searches = 0;    ///< predictions and looks that took the general search
    std::int64_t static_pairs_skipped = 0;
    std::int64_t far_pairs_skipped = 0;    ///< pairs that the grid left alone, compared with all pairs
    std::int64_t far_features_skipped = 0; ///< predictions of turning pairs whose bounding circles never meet
};

/// Seconds spent, where a clock was lent.
struct EventSeconds
{
    double predict = 0.0;
    double look = 0.0;
    double impact = 0.0;
    double cells = 0.0;
};

} // namespace flying
