#include "world/leaning.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "broadphase/box_cells.hpp"
#include "collide/touching.hpp"
#include "toi/gap_tolerance.hpp"
#include "world/hand_over.hpp"

namespace flying {
namespace {

/// [tolerances of touching] Hops that are no higher can't be told from contact.
constexpr double k_hop = 16.0;

/// How two bodies touch, if they do.
struct Hold
{
    bool stays = false;   ///< they touch, and no point comes or goes
    bool presses = false; ///< gravity pulls A into B at some point
};

/// Looks at pairs of bodies as they start.
class Starts
{
public:
    Starts(const EventEngine& engine, const Field& field) : engine_(engine), field_(field)
    {
        for (int k = 0; k < engine.body_count(); ++k) {
            radius_.push_back(bounding_radius(engine.shape(k)));
            flyer_.push_back(engine.flyer(k));
        }
    }

    [[nodiscard]] Hold hold(int a, int b)
    {
        const BodyState& state_a = flyer_[a].state;
        const BodyState& state_b = flyer_[b].state;
        const double size = std::min(radius_[a], radius_[b]);
        const double larger = std::isinf(radius_[a] + radius_[b]) ? size : std::max(radius_[a], radius_[b]);
        const double reach = std::max(state_a.position.norm(), state_b.position.norm());
        const double touch = gap_tolerance(size, larger, reach, 0.0, state_a.time).touch;
        find_touches(engine_.shape(a), pose_of(state_a), engine_.shape(b), pose_of(state_b), touch, touches_);
        const Vec2 gravity = acceleration_at(field_, state_a.position);
        Hold hold;
        hold.stays = !touches_.empty();
        for (const Touch& point : touches_) {
            const Vec2 velocity_a = state_a.velocity + cross(state_a.spin, point.r_a);
            const Vec2 velocity_b = state_b.velocity + cross(state_b.spin, point.r_b);
            const double u = point.normal.dot(velocity_b - velocity_a);
            hold.stays = hold.stays && u * u <= 2.0 * gravity.norm() * (k_hop * touch);
            hold.presses = hold.presses || gravity.dot(point.normal) > 0.0;
        }
        return hold;
    }

    [[nodiscard]] bool is_wall(int k) const { return std::holds_alternative<HalfPlane>(engine_.shape(k)); }
    /// Holds the body, with room for the tolerance of touching.
    [[nodiscard]] Aabb box(int k) const
    {
        const Vec2 reach = Vec2::Constant((1.0 + k_room) * radius_[k]);
        return {flyer_[k].state.position - reach, flyer_[k].state.position + reach};
    }

private:
    const EventEngine& engine_;
    Field field_;
    std::vector<double> radius_; // of bounding circles [m]
    std::vector<Flyer> flyer_;
    std::vector<Touch> touches_; // workspace
};

} // namespace

std::vector<int> find_leaning(const EventEngine& engine, const Field& field)
{
    // Where everything moves there is nothing to lean on
    bool any_static = false;
    for (int k = 0; k < engine.body_count(); ++k) any_static = any_static || engine.is_static(k);
    if (!any_static) return {};

    // Sort all into cells, but for the walls
    Starts starts(engine, field);
    std::vector<int> walls;
    std::vector<BoxCells::Entry> boxes;
    for (int k = 0; k < engine.body_count(); ++k) {
        if (starts.is_wall(k)) walls.push_back(k);
        else boxes.push_back({starts.box(k), k});
    }
    BoxCells cells;
    cells.sort(std::move(boxes));

    // Begin with those that lean on what never moves
    std::vector<char> leans(static_cast<std::size_t>(engine.body_count()), 0);
    std::vector<int> found;
    const auto note = [&](int k) {
        if (!leans[k]) found.push_back(k);
        leans[k] = 1;
    };
    const auto look = [&](int k, int support) {
        const Hold hold = starts.hold(k, support);
        if (hold.stays && hold.presses) note(k);
    };
    for (const BoxCells::Entry& entry : cells.entries()) {
        for (const int wall : walls) {
            if (!engine.is_static(entry.body) && !leans[entry.body]) look(entry.body, wall);
        }
        if (!engine.is_static(entry.body)) continue;
        cells.visit_all_at(entry.box, [&](const BoxCells::Entry& other) {
            if (!engine.is_static(other.body) && !leans[other.body]) look(other.body, entry.body);
            return true;
        });
    }

    // Go on to those that touch them
    for (std::size_t next = 0; next < found.size(); ++next) {
        const int k = found[next];
        cells.visit_all_at(starts.box(k), [&](const BoxCells::Entry& other) {
            const bool is_new = !engine.is_static(other.body) && !leans[other.body];
            if (is_new && starts.hold(k, other.body).stays) note(other.body);
            return true;
        });
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace flying
