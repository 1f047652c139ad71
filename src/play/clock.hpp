#pragma once

namespace flying {

/// How time runs while a scene is played.
struct PlayClock
{
    bool is_paused = false;
    double speed = 1.0;         ///< simulated seconds a second, > 0
    double frame = 1.0 / 60.0;  ///< length of one step by hand, at speed 1 [s]
    double budget = 0.011;      ///< for the simulation within one frame [s]
    double share = 1.0;         ///< of the speed that is asked for, over the last second or so
    double due = 0.0;           ///< where the run should be [s]
    double simulating = 0.0;    ///< of the last frame [s]
    double drawing = 0.0;       ///< of the last frame [s]
    double mean_simulating = 0.0; ///< of the last twenty frames or so [s]
    double mean_drawing = 0.0;    ///< [s]

    /// It runs visibly slower than was asked for.
    [[nodiscard]] bool is_behind() const { return !is_paused && share < 0.95; }
};

inline constexpr double k_longest_wall = 0.1; ///< of one frame: what is longer was a hitch [s]
inline constexpr double k_slowest = 1.0 / 256.0;
inline constexpr double k_fastest = 64.0;

} // namespace flying
