#pragma once

#include <algorithm>
#include <vector>

#include "events/body_rows.hpp"
#include "events/event_counts.hpp"
#include "events/event_options.hpp"
#include "events/foreseen.hpp"
#include "events/neighbours.hpp"
#include "events/static_surfaces.hpp"

namespace flying {

/// What a scene lets predictions do without.
struct PredictionRules
{
    PredictionRules() = default;
    PredictionRules(const EventEngineOptions& options, const BodyRows& bodies);

    bool falls = false;             ///< there is an acceleration
    bool searches_all = false;      ///< every pair takes the general search
    bool is_plain = false;          ///< movers are read from their rows, and fly straight
    bool puts_off = false;          ///< pairs are looked at no further than both will fly, as far as is known
    bool skips_static_pairs = true; ///< as in the options of the engine, like those that follow
    bool skips_far_features = true;
    bool skips_apart_rings = true;
    bool skips_far_vertices = true;
};

/// Which pairs are looked at, and when they meet: reads the bodies and what lies about them, and notes what it
/// foresees. Bodies are named by their rows.
class Predictor
{
public:
    /// What predictions read.
    struct Sight
    {
        const PredictionRules& rules;
        const BodyRows& bodies;
        const Neighbours& neighbours;
        const StaticSurfaces& surfaces;
    };
    /// near  workspace, with room for one more than all bodies
    Predictor(const Sight& sight, std::vector<int>& near, ForeseenEvents& foreseen, EventCounts& counts)
        : rules_(sight.rules),
          bodies_(sight.bodies),
          rows_(sight.bodies.data()),
          neighbours_(sight.neighbours),
          surfaces_(sight.surfaces),
          near_(near),
          foreseen_(foreseen),
          counts_(counts)
    {
    }

    /// When a body leaves its cell, as seen from a moment.  [s]
    void predict_cell(int body, double now);
    /// The next impact of a mover with every body that it may meet before either changes its cell.
    /// wants(other)  false for those that are looked at from the other side
    template <typename Wants>
    void predict_partners(int body, const Wants& wants);
    /// The same for a body that has just been struck by one with which it has been compared (-1 for none).
    void predict_struck(int body, int partner);
    /// The impact of two bodies, named in any order, as their flights are now.
    void predict_pair(int p, int q)
    {
        ++counts_.predictions;
        const bool both_fly = std::max(rows_[p].kind, rows_[q].kind) < BodyRows::Kind::is_static;
        if (both_fly && !rules_.searches_all) predict_movers(p, q);
        else predict_general(p, q, std::max(rows_[p].time, rows_[q].time), 0);
    }
    /// A pair whose look was foreseen for this moment.  [s]
    void look(int p, int q, double time) { predict_general(p, q, time, 1); }
    /// A pair that was put off.
    void look_later(int p, int q) { predict_general(p, q, std::max(rows_[p].time, rows_[q].time), 1); }
    /// All pairs of a static body with those that come after it.
    void predict_static(int body);

private:
    template <bool has_corners, bool falls>
    void predict_near(int body, int partner);
    void predict_movers(int a, int b);
    void predict_general(int p, int q, double from, int windows);

    PredictionRules rules_;
    const BodyRows& bodies_;
    const BodyRows::Row* rows_; // theirs
    const Neighbours& neighbours_;
    const StaticSurfaces& surfaces_;
    std::vector<int>& near_; // workspace: rows of those about one body
    ForeseenEvents& foreseen_;
    EventCounts& counts_;
};

template <typename Wants>
void Predictor::predict_partners(int body, const Wants& wants)
{
    const BodyRows::Row* const rows = rows_;
    const bool is_mover = rows[body].kind < BodyRows::Kind::is_static && !rules_.searches_all;
    int predicted = 0;
    const auto look = [&](int other) {
        if (other == body || !wants(other)) return;
        ++predicted;
        if (is_mover && rows[other].kind < BodyRows::Kind::is_static) predict_movers(body, other);
        else predict_general(body, other, std::max(rows[body].time, rows[other].time), 0);
    };
    if (neighbours_.has_cells()) {
        const Grid& cells = neighbours_.cells();
        cells.for_each_near(cells.cell_of(body), look);
        neighbours_.for_each_static(body, look);
        counts_.far_pairs_skipped += bodies_.count() - 1 - predicted;
    } else {
        for (int other = 0; other < bodies_.count(); ++other) look(other);
    }
    counts_.predictions += predicted;
}

} // namespace flying
