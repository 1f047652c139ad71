#include "world/world.hpp"

#include <algorithm>
#include <cmath>

#include "broadphase/grid.hpp"
#include "collide/separation.hpp"
#include "mass/polygon.hpp"
#include "math/number_text.hpp"
#include "world/account.hpp"
#include "world/checks.hpp"
#include "world/hybrid.hpp"
#include "world/make_shape.hpp"
#include "world/memory.hpp"

namespace flying {
namespace {

/// [steps] Impacts that follow each other so soon, where there is next to no room, aren't followed for long: a few
/// dozen such bodies would take more than a second of computing for one of motion.
constexpr double k_shortest_bounce = 0x1p-8;

/// The box as four static half-planes, their normals inwards.
[[nodiscard]] std::vector<EventBody> make_walls(const WorldDef& world)
{
    const Material material{world.restitution, world.friction};
    std::vector<EventBody> walls;
    if (!world.box) return walls;
    const auto add = [&](const Vec2& normal, double offset) {
        walls.push_back({HalfPlane{normal, offset}, {}, {}, material, true});
    };
    add({1.0, 0.0}, world.box->min.x());
    add({-1.0, 0.0}, -world.box->max.x());
    add({0.0, 1.0}, world.box->min.y());
    add({0.0, -1.0}, -world.box->max.y());
    return walls;
}

/// The solid core of a central field, a static disc; none where it has none.
[[nodiscard]] std::optional<EventBody> make_core(const WorldDef& world)
{
    const auto* central = std::get_if<CentralField>(&world.field);
    if (!central || central->radius == 0.0) return std::nullopt;
    EventBody core{Disc{central->radius}, {}, {}, {world.restitution, world.friction}, true};
    core.flyer.state.position = central->centre;
    return core;
}

/// A body of a valid scene, ready to fly.
[[nodiscard]] EventBody make_body(const BodyDef& def, const WorldDef& world)
{
    EventBody body{make_shape(def.shape).value(), {}, {}, {}, def.is_static};
    body.material = {def.restitution.value_or(world.restitution), def.friction.value_or(world.friction)};
    body.flyer.state = {def.position, def.velocity, def.angle, def.spin, 0.0};
    if (def.is_static) return body;

    // Weigh it; a given mass spreads evenly
    const MassProperties at_unit_density = mass_of(body.shape, 1.0);
    const double density = def.mass ? *def.mass / at_unit_density.mass : def.density.value_or(1.0);
    const double mass = def.mass ? *def.mass : at_unit_density.mass * density;
    body.inertia = {1.0 / mass, 1.0 / (at_unit_density.moment_of_inertia * density)};
    body.flyer.acceleration = uniform_acceleration(world.field);
    body.flyer.central = std::get_if<CentralField>(&world.field);
    return body;
}

} // namespace

/// What a world is made of.
struct World::Parts
{
    Scene scene;
    Plan plan;
    Hybrid hybrid;
    std::vector<CollisionShape> shapes; ///< of the scene's bodies, the walls and the core, for measuring overlap
    std::vector<Handover> handovers{};
    EnergyLedger ledger{};              ///< of the hand-overs, and before this world was resumed
    double initial_total = 0.0;
    double max_overlap = 0.0;           ///< measured at reports
    std::int64_t earlier_events = 0;    ///< before this world was resumed
    std::int64_t earlier_collisions = 0;
    bool failed = false;

    [[nodiscard]] std::vector<BodyView> view();
    void note_handovers();
    [[nodiscard]] EnergyLedger whole_ledger() const;
};

World::World(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Expected<World> World::make(const Scene& scene, const WorldOptions& options)
{
    Expected<World> world = set_up(scene, options);
    if (!world) return world;
    Parts& parts = *world.value().parts_;
    parts.hybrid.begin();
    parts.note_handovers();
    return world;
}

/// Everything in its place, and no body handed over yet.
Expected<World> World::set_up(const Scene& scene, const WorldOptions& options)
{
    Faults faults = validate(scene);
    if (!(options.step > 0.0) || !std::isfinite(options.step)) {
        faults.push_back({"step", number_text(options.step), "a positive number of seconds"});
    }
    if (!faults.empty()) return faults;

    // Line up the scene's bodies, then the walls, then the core
    std::vector<EventBody> bodies;
    for (const BodyDef& def : scene.bodies) bodies.push_back(make_body(def, scene.world));
    for (EventBody& wall : make_walls(scene.world)) bodies.push_back(std::move(wall));
    if (std::optional<EventBody> core = make_core(scene.world)) bodies.push_back(std::move(*core));
    std::vector<CollisionShape> shapes;
    std::vector<Material> materials;
    for (const EventBody& body : bodies) {
        shapes.push_back(make_collision_shape(body.shape));
        materials.push_back(body.material);
    }

    // Do only what this scene needs
    const Plan plan = make_plan(scene, options.without);
    // [world.make.options]
    EventEngineOptions engine_options;
    engine_options.pair_finder = plan.pair_finder;
    engine_options.skips_static_pairs = plan.skips_static_pairs;
    engine_options.skips_far_features = plan.skips_far_features;
    engine_options.skips_search = plan.skips_search;
    engine_options.skips_absent_field = plan.skips_absent_field;
    engine_options.skips_apart_rings = plan.skips_apart_rings;
    engine_options.skips_far_vertices = plan.skips_far_vertices;
    if (options.engine == EngineChoice::automatic) {
        engine_options.ends_bounces = true;
        engine_options.shortest_bounce = k_shortest_bounce * options.step;
    }
    const Hybrid::Setting setting{options.engine, options.step, scene.world.field, plan.sleeps, plan.warm_starts};
    // [world.make.options]
    Hybrid hybrid(EventEngine(std::move(bodies), engine_options), std::move(materials), setting);

    World world(std::make_unique<Parts>(Parts{scene, plan, std::move(hybrid), std::move(shapes)}));
    world.parts_->initial_total = take_account(world.parts_->view(), scene).energy.total();
    return world;
}

Expected<World> World::resume(const Scene& scene, const Snapshot& snapshot, const WorldOptions& options)
{
    Expected<World> made = set_up(scene, options);
    if (!made) return made;
    World world = std::move(made).value();
    Parts& parts = *world.parts_;
    const auto count = static_cast<std::size_t>(parts.hybrid.flying().body_count());
    if (snapshot.bodies.size() != scene.bodies.size() || !snapshot.engines ||
        snapshot.engines->hybrid.movers.size() != count) {
        return Fault{"snapshot", std::to_string(snapshot.bodies.size()) + " bodies",
                     std::to_string(scene.bodies.size()) + " bodies, those of the scene"};
    }
    parts.hybrid.go_on_from(snapshot.engines->hybrid, snapshot.bodies, snapshot.time);
    parts.earlier_events = snapshot.events;
    parts.earlier_collisions = snapshot.collisions;
    parts.initial_total = snapshot.initial_total;
    parts.handovers = snapshot.handovers;
    parts.ledger = snapshot.ledger;
    parts.max_overlap = snapshot.max_overlap;
    return world;
}

// [world.resume.snapshot]
Snapshot World::snapshot() const
{
    const Parts& parts = *parts_;
    Snapshot snapshot;
    snapshot.time = time();
    for (int k = 0; k < body_count(); ++k) snapshot.bodies.push_back(parts.hybrid.flying().flyer(k).state);
    snapshot.events = events();
    snapshot.collisions = collisions();
    snapshot.max_overlap = parts.max_overlap;
    snapshot.initial_total = parts.initial_total;
    snapshot.engines = std::make_shared<const EngineMemory>(EngineMemory{parts.hybrid.memory()});
    snapshot.handovers = parts.handovers;
    snapshot.ledger = parts.ledger;
    return snapshot;
}
// [world.resume.snapshot]

/// Put what the integrators did with each other into the words of the scene.
void World::Parts::note_handovers()
{
    for (const Hybrid::Change& change : hybrid.fetch_changes()) {
        handovers.push_back(describe(change, scene));
        ledger.handovers += handovers.back().energy_change;
    }
}

EnergyLedger World::Parts::whole_ledger() const
{
    EnergyLedger whole = ledger;
    whole.impacts -= hybrid.flying().energy_lost();
    whole.steps += hybrid.energy_of_steps();
    whole.handovers += hybrid.energy_of_blows();
    return whole;
}

std::optional<RunFailure> World::advance(double time, std::int64_t max_events)
{
    Parts& parts = *parts_;
    if (parts.failed) return std::nullopt;
    const std::optional<EventFailure> failure = parts.hybrid.advance(time, max_events);
    parts.note_handovers();
    if (!failure) return std::nullopt;
    parts.failed = true;
    return describe(*failure, parts.scene);
}

double World::time() const { return parts_->hybrid.clock(); }
int World::body_count() const { return static_cast<int>(parts_->scene.bodies.size()); }
BodyState World::state(int index) const { return parts_->hybrid.state(index); }
World::Mover World::mover(int index) const { return parts_->hybrid.mover(index); }
std::optional<double> World::step_end() const { return parts_->hybrid.step_end(); }

std::vector<BodyView> World::Parts::view()
{
    std::vector<BodyView> bodies;
    const EventEngine& engine = hybrid.flying();
    for (int k = 0; k < engine.body_count(); ++k) {
        bodies.push_back({hybrid.state(k), engine.inertia(k), &engine.shape(k), hybrid.mover(k) == BodyMover::none});
    }
    return bodies;
}

const Shape& World::shape(int index) const { return parts_->hybrid.flying().shape(index); }
bool World::is_static(int index) const { return mover(index) == Mover::none; }
const Scene& World::scene() const { return parts_->scene; }
const std::vector<Handover>& World::handovers() const { return parts_->handovers; }

std::int64_t World::events() const
{
    const RestEngine* rest = parts_->hybrid.resting();
    return parts_->earlier_events + parts_->hybrid.flying().counts().events + (rest ? rest->counts().steps : 0);
}

std::int64_t World::collisions() const
{
    const RestEngine* rest = parts_->hybrid.resting();
    return parts_->earlier_collisions + parts_->hybrid.flying().counts().impacts + (rest ? rest->counts().impacts : 0);
}

std::uint64_t World::log_hash() const { return parts_->hybrid.flying().log_hash(); }

void World::set_stopwatch(double (*seconds)()) { parts_->hybrid.set_stopwatch(seconds); }

Report World::report()
{
    Parts& parts = *parts_;
    std::vector<BodyView> bodies = parts.view();
    const Account account = take_account(bodies, parts.scene);
    const EventEngine& flying = parts.hybrid.flying();
    // Between the ends of a step the ways of those that lean are interpolated: their overlap is measured at the ends
    for (int k = 0; k < flying.body_count(); ++k) bodies[k].is_static = bodies[k].is_static || parts.hybrid.is_within_step(k);
    parts.max_overlap = std::max({parts.max_overlap, flying.max_overlap(), deepest_overlap(bodies, parts.shapes)});
    const RestEngine* rest = parts.hybrid.resting();
    if (rest) parts.max_overlap = std::max(parts.max_overlap, rest->max_overlap());

    Report report;
    report.time = time();
    const bool only_rest = parts.hybrid.setting().policy == EngineChoice::rest;
    report.engine = only_rest ? "rest" : rest ? "events and rest" : "events";
    report.events = events();
    report.collisions = collisions();
    report.handovers = parts.handovers;
    report.energy = account.energy;
    report.initial_total = parts.initial_total;
    report.ledger = parts.whole_ledger();
    report.momentum = account.momentum;
    report.angular_momentum = account.angular_momentum;
    report.max_overlap = parts.max_overlap;
    report.bodies = account.bodies;
    report.hash = final_hash(flying.log_hash(), report.bodies);
    report.plan = plan_with_savings(parts.plan, flying.counts(), rest);
    report.stages = stage_costs(flying.counts(), flying.seconds());
    if (rest) {
        const std::vector<StageCost> more = stage_costs(rest->counts(), rest->seconds());
        report.stages.insert(report.stages.end(), more.begin(), more.end());
        report.stages.push_back({"hand over", rest->counts().steps, parts.hybrid.seconds_between_steps()});
        report.rest = rest_account(rest->counts(), rest->solve_counts());
        const double energy = std::max(std::abs(report.initial_total), report.energy.kinetic);
        report.warnings = warnings_of(*report.rest, energy);
    }
    return report;
}

} // namespace flying
