#include "events/predictor.hpp"

#include <algorithm>

#include "events/cell_exit.hpp"
#include "toi/discs.hpp"
#include "toi/predict.hpp"

namespace flying {
namespace {

/// Beyond this factor, two squares that were rounded a handful of times each are in the order of what they stand for.
constexpr double k_surely = 1.0 + 0x1p-48;

[[nodiscard]] bool any_polygon_moves(const BodyRows& bodies)
{
    for (int row = 0; row < bodies.count(); ++row) {
        if (bodies[row].kind == BodyRows::Kind::polygon) return true;
    }
    return false;
}

} // namespace

PredictionRules::PredictionRules(const EventEngineOptions& options, const BodyRows& bodies)
    : falls(bodies.acceleration() != Vec2::Zero() || !options.skips_absent_field),
      searches_all(bodies.is_central() || !options.skips_search),
      is_plain(!falls && !searches_all),
      puts_off(!searches_all && any_polygon_moves(bodies)),
      skips_static_pairs(options.skips_static_pairs),
      skips_far_features(options.skips_far_features),
      skips_apart_rings(options.skips_apart_rings),
      skips_far_vertices(options.skips_far_vertices)
{
}

void Predictor::predict_cell(int body, double now)
{
    if (!neighbours_.has_cells()) return;
    const BodyRows::Row& row = rows_[body];
    const Grid& grid = neighbours_.cells();
    const Cell& cell = grid.cell_of(body);
    const CellExit exit = rules_.falls
                              ? next_cell_exit(bodies_.flyer_of(body), cell, grid.cell_size(), now)
                              : straight_exit(row.position, row.velocity, row.time, cell, grid.cell_size(), now);
    if (exit.time != k_never) foreseen_.note_cell(exit.time, row, exit.side);
}

void Predictor::predict_struck(int body, int partner)
{
    const bool is_disc = rows_[body].kind == BodyRows::Kind::disc;
    if (!neighbours_.has_cells() || rules_.searches_all || !(is_disc || rules_.skips_far_features)) {
        predict_partners(body, [&](int other) { return other != partner; });
    } else if (rules_.falls) {
        is_disc ? predict_near<false, true>(body, partner) : predict_near<true, true>(body, partner);
    } else {
        is_disc ? predict_near<false, false>(body, partner) : predict_near<true, false>(body, partner);
    }
}

void Predictor::predict_static(int body)
{
    // Two static bodies never meet; with the skip off, look all the same
    for (int other = body + 1; other < bodies_.count(); ++other) {
        if (!bodies_.is_fixed(other)) continue;
        if (rules_.skips_static_pairs) ++counts_.static_pairs_skipped;
        else predict_pair(body, other);
    }
}

/// Two bodies under one acceleration: discs meet when their circles do; others are looked at when their bounding
/// circles do. The same numbers as `predict`, straight from the rows: in every product both signs turn with the order
/// of the two.
void Predictor::predict_movers(int a, int b)
{
    const BodyRows::Row& row_a = rows_[a];
    const BodyRows::Row& row_b = rows_[b];
    const double start = std::max(row_a.time, row_b.time);
    const double t_a = start - row_a.time;
    const double t_b = start - row_b.time;
    Vec2 offset = (row_a.position + t_a * row_a.velocity) - (row_b.position + t_b * row_b.velocity);
    Vec2 rate = row_a.velocity - row_b.velocity;
    if (rules_.falls) {
        const Vec2& g = bodies_.acceleration();
        offset = position_after(row_a.position, row_a.velocity, g, t_a) -
                 position_after(row_b.position, row_b.velocity, g, t_b);
        rate = (row_a.velocity + t_a * g) - (row_b.velocity + t_b * g);
    }
    const double reach = row_a.radius + row_b.radius;

    // [events.predict_movers.kinds]
    double time = k_never;
    auto kind = Event::Kind::impact;
    if (row_a.kind == BodyRows::Kind::disc && row_b.kind == BodyRows::Kind::disc) {
        time = start + time_to_meet(offset, rate, reach);
    } else if (rules_.skips_far_features) {
        // [events.predict_movers.circles]
        const double radius = bounding_reach(reach);
        const bool parts = offset.dot(rate) >= 0.0 && offset.squaredNorm() > radius * radius; // seen without a root
        const Passage passage = parts ? Passage{} : passage_through_circle(offset, rate, radius);
        if (!(passage.leave > 0.0)) {
            ++counts_.far_features_skipped;
            return;
        }
        if (passage.enter <= 0.0) {
            predict_general(a, b, start, 1); // the circles meet already
            return;
        }
        time = start + passage.enter;
        kind = Event::Kind::look;
        // [events.predict_movers.circles]
    } else {
        predict_general(a, b, start, 1);
        return;
    }
    if (time != k_never) foreseen_.note_pair(time, row_a, row_b, kind);
    // [events.predict_movers.kinds]
}

/// The same as `predict_partners` for a body that has just been struck: no body's note is younger than its own, so that
/// only the others are brought to its moment.
/// has_corners  the body has: it is looked at more closely with all that its circle overlaps
/// falls        so do all that move
template <bool has_corners, bool falls>
void Predictor::predict_near(int body, int partner)
{
    using Kind = BodyRows::Kind;
    int* const near = near_.data();
    const int* const end = neighbours_.gather_movers(body, near);
    const auto count = static_cast<int>(end - near);
    const BodyRows::Row* const rows = rows_;
    const BodyRows::Row row = rows[body];
    const Vec2& g = bodies_.acceleration();

    // Bring another to the moment of this one
    const auto position_of = [&](const BodyRows::Row& other, double t) -> Vec2 {
        if (falls) return position_after(other.position, other.velocity, g, t);
        return other.position + t * other.velocity;
    };
    const auto velocity_of = [&](const BodyRows::Row& other, double t) -> Vec2 {
        return falls ? Vec2(other.velocity + t * g) : other.velocity;
    };

    // Keep those that come near enough, and those that need a closer look
    int* kept = near;
    for (const int* place = near; place != end; ++place) {
        const int q = *place;
        const BodyRows::Row& other = rows[q];
        const double t = row.time - other.time;
        const Vec2 offset = row.position - position_of(other, t);
        const Vec2 rate = row.velocity - velocity_of(other, t);
        const double both = row.radius + other.radius;
        const double reach = has_corners ? bounding_reach(both) : both;
        const double miss = cross(offset, rate);
        const bool overlaps = has_corners && offset.squaredNorm() <= (reach * reach) * k_surely;
        const bool closes = offset.dot(rate) < 0.0;
        const bool passes = miss * miss > rate.squaredNorm() * (reach * reach) * k_surely;
        const bool is_plain = (has_corners ? other.kind < Kind::is_static : other.kind == Kind::disc) & (t >= 0.0);
        const bool is_other = (q != body) & (q != partner);
        *kept = q;
        kept += (((closes & !passes) | overlaps | !is_plain) & is_other) ? 1 : 0;
    }
    const int others = count - (partner >= 0 ? 2 : 1); // without the two that met
    counts_.predictions += others;
    counts_.far_pairs_skipped += bodies_.count() - 1 - others;
    if (has_corners) counts_.far_features_skipped += others - (kept - near);

    for (const int* place = near; place != kept; ++place) {
        const BodyRows::Row& other = rows[*place];
        if (!(other.kind < Kind::is_static)) {
            predict_general(body, *place, std::max(row.time, other.time), 0);
        } else if (has_corners || other.kind != Kind::disc || !(other.time <= row.time)) {
            predict_movers(body, *place);
        } else {
            const double t = row.time - other.time;
            const Vec2 offset = row.position - position_of(other, t);
            const double wait = time_to_meet(offset, row.velocity - velocity_of(other, t), row.radius + other.radius);
            if (wait != k_never) foreseen_.note_pair(row.time + wait, row, other, Event::Kind::impact);
        }
    }
    neighbours_.for_each_static(body, [&](int other) { predict_pair(body, other); });
}

/// Any two bodies, looked at through no more than so many windows: what happens later may never come to be, for one of
/// them may be struck before.
void Predictor::predict_general(int p, int q, double from, int windows)
{
    if (!bodies_.can_meet(p, q)) return;
    const bool in_order = rows_[p].id < rows_[q].id;
    const int a = in_order ? p : q;
    const int b = in_order ? q : p;
    PredictOptions options;
    options.windows = windows;
    if (rules_.puts_off) {
        const double end = std::min(foreseen_.end_of_flight(bodies_, p), foreseen_.end_of_flight(bodies_, q));
        if (end < k_never) options.horizon = next_after(end_of_moment(end));
    }
    options.skips_far_features = rules_.skips_far_features;
    options.skips_apart_rings = rules_.skips_apart_rings;
    options.skips_far_vertices = rules_.skips_far_vertices;
    options.seams_a = surfaces_.seams_of(rows_[a].id);
    options.seams_b = surfaces_.seams_of(rows_[b].id);
    ++counts_.searches;
    const Prediction prediction =
        predict(bodies_.shape_of(a), bodies_.flyer_of(a), bodies_.shape_of(b), bodies_.flyer_of(b), from, options);
    if (prediction.kind == Prediction::Kind::never) {
        ++counts_.far_features_skipped;
        return;
    }
    if (rules_.puts_off && prediction.kind == Prediction::Kind::impact) {
        foreseen_.note_impact(bodies_, prediction.time, a, b);
        return;
    }
    const auto kind = prediction.kind == Prediction::Kind::impact    ? Event::Kind::impact
                      : prediction.kind == Prediction::Kind::put_off ? Event::Kind::later
                                                                     : Event::Kind::look;
    foreseen_.note_pair(prediction.time, rows_[a], rows_[b], kind);
}

} // namespace flying
