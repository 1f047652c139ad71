#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weighed.hpp"

namespace flying::bench {

/// A force that one body bears from another along the normal between them.
struct Load
{
    int below = 0; ///< the body of the lower number; -1 for the box's walls
    int above = 0;
    double force = 0.0; ///< >= 0 [N]
};

/// All bodies at one moment of a run.
struct Look
{
    double time = 0.0; ///< [s]
    std::vector<BodyState> states;
};

/// What is known of a run once it has ended: the looks that a trial asks for, and the loads at the end.
struct Story
{
    std::vector<Look> looks;
    std::vector<Load> loads;
    bool knows_loads = false; ///< the engine tells them
};

/// One way of being wrong. Of a story that it can't measure it says nothing.
struct Measure
{
    std::string name; ///< with its unit, as an axis has it
    std::function<std::optional<double>(const Story&)> of;
};

/// A scene whose truth is known, and how far from it an engine is said to be. The first measure is the diagram's error.
struct Trial
{
    std::string name;
    std::string title;
    std::string why;   ///< why that error
    std::string truth; ///< what it is measured against
    Scene scene;
    double until = 1.0;        ///< [s]
    std::vector<double> looks; ///< ascending moments up to `until`, multiples of 1/60 s [s]
    std::vector<Measure> measures;
    double patience = 1.0; ///< a run of this may take so many times as long as one of the others
    bool rests = false;    ///< bodies lean on each other, so that this engine's step counts as well
    bool asks_loads = false;
    bool is_own = false; ///< the truth is this engine's own run of the same scene elsewhere
};

enum class Coarseness
{
    full,
    quick ///< fewer bodies where there are many
};

/// What it takes to make a trial: some ask for a long truth.
struct TrialMaker
{
    std::string name;
    std::function<Trial(Coarseness)> make;
};

/// All trials, in the order of the book.
[[nodiscard]] std::vector<TrialMaker> trial_makers();
/// The parts of that list, each in a file of its own.
[[nodiscard]] std::vector<TrialMaker> flight_trials();
[[nodiscard]] std::vector<TrialMaker> impact_trials();
[[nodiscard]] std::vector<TrialMaker> gas_trials();
[[nodiscard]] std::vector<TrialMaker> rest_trials();

/// Where a body really is.
struct Place
{
    Vec2 position = Vec2::Zero(); ///< [m]
    std::optional<double> angle;  ///< where it counts [rad]
};

/// Over all looks the largest distance of each body that moves from the truth, an angle counted as the way of a point
/// of the rim; of these the median. truth  place of body number `body` at a moment
[[nodiscard]] Measure median_distance(const Scene& scene, std::function<Place(int body, double time)> truth);

/// How much the energy has changed from the first look to the last, as a share of its first value.
[[nodiscard]] Measure energy_drift(const Scene& scene);

/// How much more energy than at any earlier look there ever was, as a share of all that was there at first.
[[nodiscard]] Measure energy_gain(const Scene& scene);

/// Deepest overlap over all looks, walls included.
[[nodiscard]] Measure deepest_overlap(const Scene& scene);

/// Largest distance that any body has gone from its first place, at the last look.
[[nodiscard]] Measure largest_shift();

/// Looks every `every` seconds up to `until`, the start included.
[[nodiscard]] std::vector<double> looks_every(double every, double until);

} // namespace flying::bench
