#include "world/account.hpp"

#include <algorithm>
#include <cmath>

#include "broadphase/sweep.hpp"
#include "math/number_text.hpp"

namespace flying {
namespace {

[[nodiscard]] BodyReport report_body(const BodyView& body, const std::string& name)
{
    const auto inverse_or_zero = [](double x) { return x > 0.0 ? 1.0 / x : 0.0; };
    return {name, body.state, inverse_or_zero(body.inertia.inv_mass),
            inverse_or_zero(body.inertia.inv_moment_of_inertia)};
}

} // namespace

Account take_account(const std::vector<BodyView>& bodies, const Scene& scene)
{
    const Vec2 gravity = uniform_acceleration(scene.world.field);
    const auto* central = std::get_if<CentralField>(&scene.world.field);
    Account account;
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
        const BodyReport& body = account.bodies.emplace_back(report_body(bodies[k], scene.bodies[k].name));
        const BodyState& state = body.state;
        account.energy.kinetic += 0.5 * body.mass * state.velocity.squaredNorm();
        account.energy.kinetic += 0.5 * body.moment_of_inertia * (state.spin * state.spin);
        account.energy.potential -= body.mass * gravity.dot(state.position);
        if (central && body.mass > 0.0) {
            account.energy.potential -= body.mass * central->mu / (state.position - central->centre).norm();
        }
        account.momentum += body.mass * state.velocity;
        account.angular_momentum += body.mass * cross(state.position, state.velocity);
        account.angular_momentum += body.moment_of_inertia * state.spin;
    }
    return account;
}

double deepest_overlap(const std::vector<BodyView>& bodies, const std::vector<CollisionShape>& shapes)
{
    std::vector<Pose> poses;
    std::vector<BoxedBody> boxed;
    for (const BodyView& body : bodies) {
        poses.push_back(pose_of(body.state));
        boxed.push_back({static_cast<int>(boxed.size()), body.is_static, bounding_box(*body.shape, poses.back())});
    }
    Sweep sweep;
    sweep.line_up(boxed);
    double deepest = 0.0;
    sweep.for_each_pair([&](int a, int b) {
        deepest = std::max(deepest, -separation(shapes[a], poses[a], shapes[b], poses[b]));
        return true;
    });
    return deepest;
}

std::uint64_t final_hash(std::uint64_t log_hash, const std::vector<BodyReport>& bodies)
{
    Hash hash(log_hash);
    for (const BodyReport& body : bodies) {
        const BodyState& state = body.state;
        for (const double number : {state.position.x(), state.position.y(), state.velocity.x(), state.velocity.y(),
                                    state.angle, state.spin, state.time}) {
            hash.add(number);
        }
    }
    return hash.value();
}

Plan plan_with_savings(Plan plan, const EventCounts& counts, const RestEngine* rest)
{
    for (Skip& skip : plan.skips) {
        if (!skip.active) continue;
        if (skip.name == "grid") skip.saved = counts.far_pairs_skipped;
        if (skip.name == "static-pairs") skip.saved = counts.static_pairs_skipped;
        if (skip.name == "search") skip.saved = counts.predictions + counts.looks - counts.searches;
        if (rest && skip.name == "sleeping") skip.saved = rest->counts().asleep;
        if (rest && skip.name == "warm-start") skip.saved = rest->solve_counts().accepted;
        if (skip.name == "far-features") skip.saved = counts.far_features_skipped;
    }
    return plan;
}

std::vector<StageCost> stage_costs(const EventCounts& counts, const EventSeconds& seconds)
{
    return {{"predict", counts.predictions, seconds.predict},
            {"look again", counts.looks, seconds.look},
            {"impact", counts.impacts, seconds.impact},
            {"cell", counts.cells, seconds.cells},
            {"overtaken", counts.stale, 0.0}};
}

std::vector<StageCost> stage_costs(const RestCounts& counts, const RestSeconds& seconds)
{
    return {{"find pairs", counts.looks, seconds.pairs},
            {"collide", counts.manifolds, seconds.collide},
            {"solve", counts.islands, seconds.solve},
            {"move", counts.steps, seconds.move}};
}

RestAccount rest_account(const RestCounts& counts, const SolveCounts& solves)
{
    RestAccount account;
    account.islands = counts.islands;
    account.solved = solves.accepted + solves.solved;
    account.swept = solves.swept;
    account.unsolved = solves.unsolved;
    account.parts = counts.parts;
    account.projected = counts.projected;
    account.limited = counts.limited;
    account.energy_limited = counts.energy_limited;
    account.elastic_ended = counts.elastic_ended;
    account.elastic_braked = counts.elastic_braked;
    return account;
}

std::vector<std::string> warnings_of(const RestAccount& rest, double energy)
{
    constexpr double k_kept = 1e-9; // of the energy, where nothing may take any
    const double lost = rest.elastic_ended + rest.elastic_braked;
    if (!(lost > k_kept * energy)) return {};
    const auto joules = [](double work) { return rounded_text(work, 3) + " J"; }; // as people quote it
    return {joules(lost) + " lost at e = 1 without friction: " + joules(rest.elastic_ended) +
            " by impacts at one moment that did not end, " + joules(rest.elastic_braked) +
            " by gaps that closed within a step; bodies that touch bounce more often than a step can follow"};
}

Handover describe(const Hybrid::Change& change, const Scene& scene)
{
    using Why = Hybrid::Change::Why;
    Handover handover;
    handover.time = change.why == Why::settled ? change.bounces_end : change.time;
    handover.ends_bounces = change.why == Why::settled;
    for (const int body : change.bodies) {
        if (body < static_cast<int>(scene.bodies.size())) handover.bodies.push_back(body);
    }
    switch (change.why) {
    case Why::crowded:
        handover.reason = describe({EventFailure::Kind::crowded, handover.time, change.a, change.b}, scene).message;
        break;
    case Why::settled:
        handover.reason = describe({EventFailure::Kind::settled, handover.time, change.a, change.b}, scene).message;
        break;
    case Why::stays:
        handover.reason = describe({EventFailure::Kind::stays, handover.time, change.a, change.b}, scene).message;
        break;
    case Why::unresolved:
        handover.reason = describe({EventFailure::Kind::unresolved, handover.time, change.a, change.b}, scene).message;
        break;
    case Why::leaning: handover.reason = "they lean on something from the start"; break;
    case Why::near: handover.reason = "within a step they may meet bodies that lean on others"; break;
    case Why::free: handover.reason = "they bear no load, and will touch nothing for two steps"; break;
    }
    handover.to = change.why == Why::free ? Handover::To::events : Handover::To::rest;
    handover.energy_before = change.energy_before;
    handover.energy_after = change.energy_after;
    handover.energy_change = change.energy_after - change.energy_before;
    return handover;
}

RunFailure describe(const EventFailure& failure, const Scene& scene)
{
    RunFailure described;
    described.time = failure.time;
    for (const int body : {failure.a, failure.b}) {
        if (body < static_cast<int>(scene.bodies.size())) described.bodies.push_back(body);
    }
    const std::string pair = quoted_label(scene, failure.a) + " and " + quoted_label(scene, failure.b);
    const std::string when = " at t = " + number_text(failure.time) + " s";
    switch (failure.kind) {
    case EventFailure::Kind::crowded:
        described.message = "impacts of " + pair + " crowd together without end" + when;
        break;
    case EventFailure::Kind::settled:
        described.message = "bounces of " + pair + " die away" + when;
        break;
    case EventFailure::Kind::stays:
        described.message = "an impact leaves " + pair + " on each other" + when;
        break;
    case EventFailure::Kind::unresolved:
        described.message = "an impact of " + pair + when + " could not be resolved: some of its points still approach";
        break;
    case EventFailure::Kind::spun_out:
        described.message = "one of " + pair + " has turned through more than 2^53 rad" + when +
                            ": its angle has lost its meaning";
        break;
    }
    return described;
}

} // namespace flying
