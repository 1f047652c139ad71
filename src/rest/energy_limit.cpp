#include "rest/energy_limit.hpp"

#include <algorithm>
#include <cmath>

#include "rest/rest_tolerance.hpp"
#include "rest/step_field.hpp"

namespace flying {
namespace {

/// All but discs that no impulse has turned, as smooth ones: such a spin has no part in what the island gains. If it
/// counted, gains would hide in the rounding of its energy, and it would pay for them.
[[nodiscard]] bool is_turned(const RestData& data, int member)
{
    return data.bodies.turning[member] > 0.0 || data.motion.now[member].spin != data.motion.before[member].spin;
}

/// Kinetic energy, of what is not turned without its spin's.  [J]
[[nodiscard]] double energy_in_play(const RestData& data, int member, const Mover& mover)
{
    Mover without_spin = mover;
    if (!is_turned(data, member)) without_spin.spin = 0.0;
    return kinetic_energy(without_spin);
}

} // namespace

EnergyGain gain_of(const RestData& data, const Island& island)
{
    EnergyGain gain;
    for (const int member : island.members) {
        const Mover& old = data.motion.before[member];
        const Mover& now = data.motion.now[member];
        const double before = energy_in_play(data, member, old);
        const double after = energy_in_play(data, member, now);
        const double work = work_of_field(data, member) / now.inv_mass;
        gain.gained += (after - before) - work;
        const Vec2& field = data.motion.field[member];
        const double through_field = field.cwiseProduct(data.motion.shift[member]).cwiseAbs().sum();
        const double in_a_step =
            (data.motion.span * field).squaredNorm(); // the solve's rounding is in proportion to it
        gain.scale += after + before + (through_field + in_a_step) / now.inv_mass;
    }
    return gain;
}

double kinetic_energy(const Mover& m)
{
    return 0.5 * ((m.v_x * m.v_x + m.v_y * m.v_y) / m.inv_mass + m.spin * m.spin / m.inv_moment);
}

double kinetic_energy(const Island& island, std::span<const Mover> movers)
{
    double sum = 0.0;
    for (const int member : island.members) sum += kinetic_energy(movers[member]);
    return sum;
}

bool is_all_but_still(const RestData& data, int body, const Mover& mover)
{
    const double lift = data.motion.field_size[body] * data.bodies.radius[body] / mover.inv_mass; // [J]
    return kinetic_energy(mover) <= rest_tolerance::k_rounding * lift;
}

double neutral_share(const RestData& data, const Island& island, std::span<const Mover> before,
                     std::span<const Mover> after, Way way)
{
    const double time = way == Way::none ? 0.0 : data.motion.span;
    const double mean = way == Way::end_velocity ? 0.0 : 0.5;
    // [rest.heaps.share]
    // With a share s of the impulses the energy grows by  square s^2 + linear s + constant
    double square = 0.0;   // [J]
    double linear = 0.0;   // [J]
    double constant = 0.0; // [J]
    double scale = 0.0;    // [J]
    for (const int member : island.members) {
        const Mover& old = before[member];
        const Mover& now = after[member];
        const Vec2 velocity(old.v_x, old.v_y);
        const Vec2 fall = time * data.motion.field[member];
        const Vec2 change = Vec2(now.v_x, now.v_y) - velocity - fall;
        const double spin = now.spin - old.spin;
        square += 0.5 * (change.squaredNorm() / now.inv_mass + spin * spin / now.inv_moment);
        linear += (velocity + mean * fall).dot(change) / now.inv_mass + old.spin * spin / now.inv_moment;
        constant -= (0.5 - mean) * fall.squaredNorm() / now.inv_mass;
        scale += (velocity.squaredNorm() + fall.squaredNorm()) / now.inv_mass + old.spin * old.spin / now.inv_moment;
    }
    if (!(std::abs(square + linear + constant) > rest_tolerance::k_rounding * scale)) return 1.0;
    const double root = std::sqrt(linear * linear - 4.0 * square * constant);
    return linear > 0.0 ? -2.0 * constant / (linear + root) : (root - linear) / (2.0 * square);
    // [rest.heaps.share]
}

void take_share(const RestData& data, const Island& island, std::span<const Mover> before, std::span<Mover> after,
                Way way, double share)
{
    const double time = way == Way::none ? 0.0 : data.motion.span;
    for (const int member : island.members) {
        const Mover& old = before[member];
        Mover& now = after[member];
        const Vec2 free = Vec2(old.v_x, old.v_y) + time * data.motion.field[member];
        now.v_x = free.x() + share * (now.v_x - free.x());
        now.v_y = free.y() + share * (now.v_y - free.y());
        now.spin = old.spin + share * (now.spin - old.spin);
    }
}

void count_elastic_loss(RestData& data, const Island& island)
{
    if (!is_lossless(island)) return;
    data.counts.elastic_ended += island.ended;
    const EnergyGain gain = gain_of(data, island);
    if (gain.gained < -rest_tolerance::k_rounding * gain.scale) data.counts.elastic_braked -= gain.gained;
}

namespace {

/// A motion of an island as one rigid body.
struct RigidMotion
{
    Vec2 centre = Vec2::Zero();   ///< [m]
    Vec2 velocity = Vec2::Zero(); ///< of the centre [m/s]
    double spin = 0.0;            ///< [rad/s]

    /// Its velocity at a place.  [m/s]
    [[nodiscard]] Vec2 at(const Vec2& place) const { return velocity + cross(spin, Vec2(place - centre)); }
};

/// The motion of an island as one rigid body that no contact with something static resists. Slowing an island down
/// relative to that changes no momentum that is its own.
/// velocities  of all bodies, of which it is made
[[nodiscard]] RigidMotion free_motion(const RestData& data, const Island& island, std::span<const Mover> velocities)
{
    RigidMotion rigid;
    double mass = 0.0;
    for (const int member : island.members) {
        const Mover& now = velocities[member];
        mass += 1.0 / now.inv_mass;
        rigid.centre += data.bodies.list[member].state.position / now.inv_mass;
        rigid.velocity += Vec2(now.v_x, now.v_y) / now.inv_mass;
    }
    rigid.centre /= mass;
    rigid.velocity /= mass;

    const StaticHold hold = static_hold(data, island.points);
    rigid.velocity = hold.leaves(rigid.velocity);
    if (hold.directions > 0) return rigid;
    double moment = 0.0;
    double turning = 0.0;
    for (const int member : island.members) {
        const Mover& now = velocities[member];
        const Vec2 r = data.bodies.list[member].state.position - rigid.centre;
        turning += cross(r, Vec2(Vec2(now.v_x, now.v_y) - rigid.velocity)) / now.inv_mass;
        moment += r.squaredNorm() / now.inv_mass;
        if (!is_turned(data, member)) continue;
        turning += now.spin / now.inv_moment;
        moment += 1.0 / now.inv_moment;
    }
    if (moment > 0.0) rigid.spin = turning / moment;
    return rigid;
}

/// The motion by which an island as one rigid body gets from where it was to where it will be.
[[nodiscard]] RigidMotion free_way(const RestData& data, const Island& island)
{
    const RigidMotion after = free_motion(data, island, data.motion.now);
    if (!island.is_exact) return after;
    const RigidMotion before = free_motion(data, island, data.motion.before);
    return {after.centre, 0.5 * (before.velocity + after.velocity), 0.5 * (before.spin + after.spin)};
}

/// Energy of an island's motion relative to a rigid one.
struct RelativeEnergy
{
    double own = 0.0;   ///< [J]
    double mixed = 0.0; ///< what changes with the relative motion beside its own energy [J]
};

[[nodiscard]] RelativeEnergy relative_energy(const RestData& data, const Island& island, const RigidMotion& rigid,
                                             std::span<const Mover> velocities)
{
    RelativeEnergy energy;
    for (const int member : island.members) {
        const Mover& now = velocities[member];
        const Vec2 common = rigid.at(data.bodies.list[member].state.position);
        const Vec2 own = Vec2(now.v_x, now.v_y) - common;
        const double spin = is_turned(data, member) ? now.spin - rigid.spin : 0.0;
        energy.own += 0.5 * (own.squaredNorm() / now.inv_mass + spin * spin / now.inv_moment);
        energy.mixed += common.dot(own) / now.inv_mass + rigid.spin * spin / now.inv_moment;
    }
    return energy;
}

/// Takes energy out of an island's motion relative to a rigid one, as much as there is. What remains to be taken.  [J]
[[nodiscard]] double slow_down(RestData& data, const Island& island, const RigidMotion& rigid, double by)
{
    const auto [energy, mixed] = relative_energy(data, island, rigid, data.motion.now);
    // [rest.energy.share]
    // With a share s of the relative motion its energy is  energy s^2 + mixed s
    const double left = energy + mixed - by;
    const double root = mixed * mixed + 4.0 * energy * left;
    const double share =
        energy > 0.0 && root > 0.0 ? std::clamp((std::sqrt(root) - mixed) / (2.0 * energy), 0.0, 1.0) : 0.0;
    // [rest.energy.share]
    for (const int member : island.members) {
        Mover& now = data.motion.now[member];
        const Vec2 common = rigid.at(data.bodies.list[member].state.position);
        now.v_x = common.x() + share * (now.v_x - common.x());
        now.v_y = common.y() + share * (now.v_y - common.y());
        if (is_turned(data, member)) now.spin = rigid.spin + share * (now.spin - rigid.spin);
    }
    return by - ((energy + mixed) - (energy * share + mixed) * share);
}

/// Takes energy out of the rise of an island's bodies relative to a way that it goes as one rigid body, as much as
/// there is. What remains to be taken.  [J]
///
/// by  what is to be taken [J]
[[nodiscard]] double rise_less(RestData& data, const Island& island, const RigidMotion& rigid, double by)
{
    const auto way_of = [&](int member) {
        return Vec2(data.motion.span * rigid.at(data.bodies.list[member].state.position));
    };
    double lift = 0.0;
    for (const int member : island.members) {
        const Vec2 own = data.motion.shift[member] - way_of(member);
        lift -= data.motion.field[member].dot(own) / data.motion.now[member].inv_mass;
    }
    if (!(lift > 0.0)) return by; // they fall, and to fall less would be a gain
    const double part = by < lift ? 1.0 - by / lift : 0.0;
    for (const int member : island.members) {
        const Vec2 common = way_of(member);
        const double turn = data.motion.span * rigid.spin;
        data.motion.shift[member] = common + part * (data.motion.shift[member] - common);
        data.motion.turn[member] = turn + part * (data.motion.turn[member] - turn);
    }
    return by - std::min(by, lift);
}

} // namespace

double energy_to_spare(const RestData& data, const Island& island, std::span<const Mover> velocities)
{
    const RigidMotion rigid = free_motion(data, island, velocities);
    const RelativeEnergy relative = relative_energy(data, island, rigid, velocities);
    return relative.own + relative.mixed;
}

void limit_energy(RestData& data, const Island& island)
{
    EnergyGain gain = gain_of(data, island);
    // What only a heap's rounding explains, a few bodies would gain in each of the many parts of a step
    const double rounding =
        std::min(rest_tolerance::k_rounding, rest_tolerance::k_residual * island.member_count()) * gain.scale;
    if (gain.gained <= rounding) return;
    ++data.counts.limited;
    data.counts.energy_limited += gain.gained;
    const RigidMotion rigid = free_motion(data, island, data.motion.now);
    // A centre takes up momentum, as all does that is static
    const bool is_held = data.options.centre || static_hold(data, island.points).directions > 0;
    // Round a centre the field's work isn't in proportion to the way, so that it takes more than one round
    for (int round = 0; round < rest_tolerance::k_quick_rounds && gain.gained > rounding; ++round) {
        double left = slow_down(data, island, rigid, gain.gained);
        if (left > rounding) left = rise_less(data, island, free_way(data, island), left);
        // What slides along something static has its friction, too, to hold it
        if (left > rounding && is_held) left = rise_less(data, island, RigidMotion{}, left);
        if (left > rounding && is_held) (void)slow_down(data, island, RigidMotion{}, left);
        gain = gain_of(data, island);
    }
}

} // namespace flying
