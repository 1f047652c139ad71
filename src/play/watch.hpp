#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "motion/body.hpp"
#include "play/inside.hpp"
#include "play/look.hpp"
#include "world/plan.hpp"

namespace flying {

class PlayRun;

/// An impact as it happened.
struct SeenImpact
{
    double seen = 0.0;          ///< on the stage's own clock [s]
    Vec2 point = Vec2::Zero();  ///< [m]
    Vec2 push = Vec2::Zero();   ///< impulse on one of the two [N s]
};

/// One point in the strips.
struct Sample
{
    double time = 0.0; ///< of the run [s]
    double kinetic = 0.0;
    double potential = 0.0;
    Vec2 momentum = Vec2::Zero();
};

/// What the last frames cost, each by itself.
class FrameCosts
{
public:
    void add(double cost);
    /// The cost that this share of frames doesn't exceed; 0 before the first.  share  0 ... 1  [s]
    [[nodiscard]] double quantile(double share) const;

private:
    std::deque<double> costs_;
};

/// What is kept of the past for layers that show it. Nothing is gathered for layers that are off.
struct Watch
{
    std::deque<SeenImpact> impacts;
    std::vector<std::deque<Vec2>> trails; ///< of each body, oldest first [m]
    double trails_grew = -1.0;            ///< when they got their last points, on the stage's own clock [s]
    std::deque<Sample> samples;
    std::deque<double> frames; ///< moments of the last frames, on the stage's own clock [s]
    FrameCosts simulating;
    FrameCosts drawing;
    FrameCosts intervals;      ///< from frame to frame
    Plan plan;                 ///< with what it saved, as it was last asked for
    double plan_asked = -1.0;  ///< on the stage's own clock [s]

    Inside inside;
    int inside_of = -1;        ///< generation of the run that `inside` belongs to
    std::vector<LeaningContact> contacts;
    std::vector<NextImpact> next;
    int next_of = -1;          ///< generation of the run that `next` belongs to
    double next_asked = -1.0;  ///< on the stage's own clock [s]
    double next_took = 0.0;    ///< to find `next` [s]
    double next_within = 0.0;  ///< how far ahead the last search looked [s]

    // What impacts are told from
    std::int64_t known_collisions = 0;
    std::vector<BodyState> flights; ///< of each body, as the last impact or the frame's start left it
};

/// How many impacts are kept, for how long, and how long the strips are.
inline constexpr std::size_t k_most_impacts = 400;
inline constexpr double k_impact_fades = 0.5;  ///< [s]
inline constexpr double k_strip_length = 12.0; ///< [s]

/// Before a frame's events: note how bodies fly.
void begin_watch(Watch& watch, const PlayRun& run);
/// After each event: take down the impact, where it was one.
void watch_event(Watch& watch, const PlayRun& run, double now);
/// After a frame.
void watch_frame(Watch& watch, PlayRun& run, const Look& look, double now);
/// What the layers show of the present moment.
void watch_present(Watch& watch, const PlayRun& run, const Look& look, double now);

/// Energy and momentum of all bodies that move.
[[nodiscard]] Sample sample_of(const PlayRun& run);

} // namespace flying
