#include "rest/slip_ends.hpp"

#include <algorithm>
#include <cmath>

#include "rest/contact_forces.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {

void SlipEnds::part(RestData& data, Island& island)
{
    const double still = rest_tolerance::k_still * field_speed(data, island);
    const double dt = data.motion.span;
    double left = dt;
    if (field_speed(data, island) == 0.0 || !any_slip_ended(island, data.motion.before, data.motion.now, still)) return;
    start_.resize(data.motion.now.size());
    for (const int member : island.members) start_[member] = data.motion.before[member];
    for (int part = 0; part < rest_tolerance::k_quick_rounds; ++part) {
        // Find a time short enough for all slips to last; from there each goes on evenly to its end
        double time = left;
        int halvings = 0;
        for (; halvings < rest_tolerance::k_quick_rounds; ++halvings) {
            time *= 0.5;
            scale_impulses(island, 0.5);
            find_impulses(data, island, start_, time);
            if (!any_slip_ended(island, start_, data.motion.now, still)) break;
        }
        if (halvings == rest_tolerance::k_quick_rounds) {
            // It ends at once
            scale_impulses(island, left / time);
            find_impulses(data, island, start_, left);
            break;
        }
        double end = left;
        for (const ContactPoint& c : island.points) {
            if (!(c.normal > 0.0) || c.friction == 0.0) continue;
            const double slip = tangent_speed(c, start_[c.a], start_[c.b]);
            const double after = tangent_speed(c, data.motion.now[c.a], data.motion.now[c.b]);
            if (std::abs(slip) > still && std::abs(after) < std::abs(slip))
                end = std::min(end, time * (slip / (slip - after)));
        }
        scale_impulses(island, end / time);
        find_impulses(data, island, start_, end);
        add_part(data, island, end);
        left -= end;
        if (!(left > 0x1p-40 * dt)) break;
        scale_impulses(island, left / end);
        find_impulses(data, island, start_, left);
        if (!any_slip_ended(island, start_, data.motion.now, still)) break;
    }
    if (left > 0.0) {
        // The rest of the step, and the mean force as if it had lasted for all of it
        add_part(data, island, left);
        scale_impulses(island, dt / left);
    }
    for (const int member : island.members)
        data.motion.add_mean_way(member, data.motion.before[member], data.motion.now[member], -dt);
}

void SlipEnds::add_part(RestData& data, const Island& island, double time)
{
    for (const int member : island.members) {
        data.motion.add_mean_way(member, start_[member], data.motion.now[member], time);
        start_[member] = data.motion.now[member];
    }
}

} // namespace flying
