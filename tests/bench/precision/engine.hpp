#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "trial.hpp"

namespace flying::bench {

/// A scene in one engine, as all engines look from outside.
struct Run
{
    std::function<void(double)> advance; ///< to a time that is later than before [s]
    std::function<std::vector<BodyState>()> states;
    std::function<std::vector<Load>()> loads = {};            ///< may be empty: the engine doesn't tell
    std::function<std::optional<std::string>()> failure = {}; ///< may be empty: it never fails
};

/// How an engine is to run.
struct Setting
{
    double hertz = 60.0; ///< steps a second, where it steps [1/s]
};

/// One curve of every diagram.
struct Engine
{
    std::string name;
    std::function<bool(const Trial&)> applies;        ///< false: not a matter for this scene, and no word about it
    std::function<std::string(const Trial&)> why_not; ///< why it can't do the scene, "" where it can
    std::function<bool(const Trial&)> steps;          ///< its step changes the result
    std::function<Run(const Scene&, const Setting&)> start;
};

/// The whole simulator as people run it.
/// has_step  its resting integrator is asked for the setting's step; otherwise for the usual one
[[nodiscard]] Engine own_engine(bool has_step);

/// The same where bodies lean on each other, but none may sleep, as none may in the peers.
[[nodiscard]] Engine own_awake();

/// Its resting integrator alone.
[[nodiscard]] Engine own_steps();

/// The three steppers of chapter 1, with walls that turn a ball round once a step finds it in them.
[[nodiscard]] std::vector<Engine> steppers();

/// Box2D and Chipmunk as Debian builds them, with assertions: with the iterations that they come with and, where bodies
/// lean on each other, with four times as many. There, Siconos as well, with each of its two solvers; where it was not
/// installed it says so.
[[nodiscard]] std::vector<Engine> peers();

} // namespace flying::bench
