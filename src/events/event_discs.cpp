#include <algorithm>
#include <cmath>

#include "events/event_engine.hpp"
#include "events/stage_timer.hpp"
#include "math/exact.hpp"
#include "math/tolerance.hpp"
#include "toi/discs.hpp"

namespace flying {
namespace {


/// Beyond this factor, two squares that were rounded a handful of times each are in the order of what they stand for.
constexpr double k_surely = 1.0 + 0x1p-48;


} // namespace


// Discs on straight paths, which most large scenes are made of: what any two bodies need, and no more. The numbers are the
// same, to the bit.

/// Let two discs strike each other that neither rub nor spin. False, and nothing done, where they are anything else.
bool EventEngine::strike_discs(const Event& event, int a, int b)
{
    if (!is_plain_ || rows_[a].kind != Kind::disc || rows_[b].kind != Kind::disc) return false;
    const StageTimer timer(options_.seconds, seconds_.impact);
    Row& row_a = rows_[a];
    Row& row_b = rows_[b];
    Sheet& sheet_a = sheets_[a];
    Sheet& sheet_b = sheets_[b];
    if (sheet_a.spin != 0.0 || sheet_b.spin != 0.0) return false;
    if (sheet_a.material.friction * sheet_b.material.friction != 0.0) return false;
    if (has_spun_out(a) || has_spun_out(b)) return false;


    // Bring them to the moment; leave to others what hardly moved, or does not quite touch
    const double t_a = event.time - row_a.time;
    const double t_b = event.time - row_b.time;
    if (!(row_a.velocity.norm() * t_a > tolerance::k_touch * row_a.radius) &&
        !(row_b.velocity.norm() * t_b > tolerance::k_touch * row_b.radius)) {
        return false;
    }
    const Vec2 position_a = row_a.position + t_a * row_a.velocity;
    const Vec2 position_b = row_b.position + t_b * row_b.velocity;
    const Vec2 b_to_a = position_a - position_b;
    const double distance = b_to_a.norm();
    const double gap = distance - (row_a.radius + row_b.radius);
    if (!(gap <= tolerance::k_touch * std::min(row_a.radius, row_b.radius)) || distance == 0.0) return false;



    // Push along the line of centres, which has no arms: nothing turns
    const Vec2 normal = -b_to_a / distance;
    const double approach = (row_b.velocity - row_a.velocity).dot(normal);
    if (!(approach < 0.0) || approach * approach == 0.0) return false;
    const double e = std::max(sheet_a.material.restitution, sheet_b.material.restitution);
    const double j = -(1.0 + e) * approach / (sheet_a.inertia.inv_mass + sheet_b.inertia.inv_mass);
    const Vec2 impulse = (j - j * excess_of_unit(normal.x(), normal.y())) * normal;
    const Vec2 velocity_a = row_a.velocity - sheet_a.inertia.inv_mass * impulse;
    const Vec2 velocity_b = row_b.velocity + sheet_b.inertia.inv_mass * impulse;
    if (!((velocity_b - velocity_a).dot(normal) >= 0.0)) return false;



    const auto write = [&](int body, const Vec2& position, const Vec2& velocity) {
        Row& row = rows_[body];
        const double inv_m = sheets_[body].inertia.inv_mass;
        energy_lost_ -= 0.5 * ((velocity - row.velocity).dot(velocity + row.velocity) / inv_m);
        row.position = position;
        row.velocity = velocity;
        row.time = event.time;
        sheets_[body].crowding = 0;
        forget(body);
    };
    write(a, position_a, velocity_a);
    write(b, position_b, velocity_b);
    max_overlap_ = std::max(max_overlap_, -gap);
    ++counts_.impacts;
    log_impact(event, a, b);
    return true;

}



/// The same as `predict_partners` for a disc that has just been struck where nothing falls: no body's note is younger than
/// its own, so that only the others are brought to its moment.
void EventEngine::predict_near(int body, int partner)
{
    int* const near = near_.data();
    const Cell& cell = grid_->cell_of(body);
    const int* const end = grid_->gather_near(cell, near);
    const auto count = static_cast<int>(end - near);
    const Row* const rows = rows_.data();
    const Row row = rows[body];


    // Keep those that come near enough, and those that need a closer look
    int* kept = near;
    for (const int* place = near; place != end; ++place) {
        const int q = *place;
        const Row& other = rows[q];
        const double t = row.time - other.time;
        const double offset_x = row.position.x() - (other.position.x() + t * other.velocity.x());
        const double offset_y = row.position.y() - (other.position.y() + t * other.velocity.y());
        const double rate_x = row.velocity.x() - other.velocity.x();
        const double rate_y = row.velocity.y() - other.velocity.y();
        const double reach = row.radius + other.radius;
        const double miss = offset_x * rate_y - offset_y * rate_x;
        const bool closes = offset_x * rate_x + offset_y * rate_y < 0.0;
        const bool passes = miss * miss > (rate_x * rate_x + rate_y * rate_y) * (reach * reach) * k_surely;
        const bool is_plain = (other.kind == Kind::disc) & (t >= 0.0);
        *kept = q;
        const bool is_other = (q != body) & (q != partner);
        kept += (((closes & !passes) | !is_plain) & is_other) ? 1 : 0;
    }

    for (const int* place = near; place != kept; ++place) {
        const Row& other = rows[*place];
        if (other.kind != Kind::disc || !(other.time <= row.time)) {
            predict_pair(body, *place);
            continue;
        }
        const double t = row.time - other.time;
        const Vec2 offset = row.position - (other.position + t * other.velocity);
        const double reach = row.radius + other.radius;
        const double wait = time_to_meet(offset, row.velocity - other.velocity, reach);
        if (wait != k_never) push_pair(row.time + wait, body, *place, Event::Kind::impact);
    }
    counts_.predictions += count - 1;
    counts_.far_pairs_skipped += body_count() - count;
    for (const int other : grid_->statics_near(cell)) predict_pair(body, other);
    for (const int other : everywhere_) predict_pair(body, other);
}


} // namespace flying
