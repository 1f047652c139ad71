#include "world/world.hpp"

#include <algorithm>
#include <cmath>

#include "broadphase/grid.hpp"
#include "collide/separation.hpp"
#include "events/event_engine.hpp"
#include "mass/polygon.hpp"
#include "rest/rest_engine.hpp"
#include "world/account.hpp"
#include "world/checks.hpp"
#include "world/leaning.hpp"
#include "world/make_shape.hpp"

namespace flying {
namespace {

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

/// The same bodies for the resting integrator, as they are at a moment.
[[nodiscard]] std::vector<RestBody> bodies_at_rest(const EventEngine& engine, const std::vector<Material>& materials,
                                                   double time)
{
    std::vector<RestBody> bodies;
    for (int k = 0; k < engine.body_count(); ++k) {
        const Flyer flyer = engine.flyer(k);
        const BodyState state = state_at(flyer, time);
        bodies.push_back({engine.shape(k), state, engine.inertia(k), materials[static_cast<std::size_t>(k)],
                          flyer.acceleration, engine.is_static(k), true});
    }
    return bodies;
}

} // namespace

/// What the integrators need to go on with the same bits, beside the bodies' flights.
struct EngineMemory
{
    EventEngine::Resume events;
    std::optional<RestEngine::Memory> rest; ///< where the resting integrator alone was at work
    std::optional<Hybrid::Memory> hybrid;   ///< where both were
    bool has_begun = false;                 ///< who leans from the start has been handed over
};

/// What a world is made of.
struct World::Parts
{
    Scene scene;
    WorldOptions options;
    Plan plan;
    EventEngine engine;
    std::vector<Material> materials;    ///< of the scene's bodies and the walls
    std::vector<CollisionShape> shapes; ///< of the same, for measuring overlap
    std::vector<char> is_static;        ///< of the same
    std::optional<RestEngine> rest{};   ///< moves all bodies where it is there
    std::optional<Hybrid> hybrid{};     ///< moves, with the event engine, from the first hand-over on
    double clock = 0.0;                 ///< the moment last asked for, while one of these does [s]
    std::vector<Handover> handovers{};
    EnergyLedger ledger{};              ///< of the hand-overs, and before this world was resumed
    double (*seconds)() = nullptr;
    double initial_total = 0.0;
    double max_overlap = 0.0;        ///< measured at reports
    std::int64_t earlier_events = 0; ///< before this world was resumed
    std::int64_t earlier_collisions = 0;
    bool failed = false;
    bool has_begun = false; ///< who leans from the start has been handed over

    void begin();
    void start_rest(double time);
    void start_hybrid();
    [[nodiscard]] BodyState state(int body) const;
    [[nodiscard]] std::vector<BodyView> view() const;
    [[nodiscard]] RunFailure fail(const EventFailure& failure);
    [[nodiscard]] std::optional<RunFailure> advance_hybrid(double time, std::int64_t most);
    void advance_rest(double time, std::int64_t most);
    void note_handovers();
    [[nodiscard]] EnergyLedger whole_ledger() const;
};

World::World(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

// [world.make]
Expected<World> World::make(const Scene& scene, const WorldOptions& options)
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
    std::vector<char> is_static;
    for (const EventBody& body : bodies) {
        is_static.push_back(body.is_static ? 1 : 0);
        shapes.push_back(make_collision_shape(body.shape));
        materials.push_back(body.material);
    }

    // Do only what this scene needs
    const Plan plan = make_plan(scene, options.without);
    EventEngineOptions engine_options;
    engine_options.pair_finder = plan.pair_finder;
    engine_options.skips_static_pairs = plan.skips_static_pairs;
    engine_options.skips_far_features = plan.skips_far_features;
    engine_options.skips_search = plan.skips_search;
    engine_options.skips_absent_field = plan.skips_absent_field;
    engine_options.skips_apart_rings = plan.skips_apart_rings;
    engine_options.skips_far_vertices = plan.skips_far_vertices;
    engine_options.ends_bounces = options.engine == EngineChoice::automatic;
    EventEngine engine(std::move(bodies), engine_options);

    World world(std::make_unique<Parts>(
        Parts{scene, options, plan, std::move(engine), std::move(materials), std::move(shapes), std::move(is_static)}));
    world.parts_->initial_total = take_account(world.parts_->view(), scene).energy.total();
    if (options.engine == EngineChoice::rest) world.parts_->start_rest(0.0);
    return world;
}
// [world.make]

// [world.resume]
Expected<World> World::resume(const Scene& scene, const Snapshot& snapshot, const WorldOptions& options)
{
    Expected<World> made = make(scene, options);
    if (!made) return made;
    World world = std::move(made).value();
    Parts& parts = *world.parts_;
    const auto count = static_cast<std::size_t>(parts.engine.body_count());
    if (snapshot.bodies.size() != scene.bodies.size() || !snapshot.engines ||
        snapshot.engines->events.crowding.size() != count) {
        return Fault{"snapshot", std::to_string(snapshot.bodies.size()) + " bodies",
                     std::to_string(scene.bodies.size()) + " bodies, those of the scene"};
    }
    const EngineMemory& memory = *snapshot.engines;
    parts.engine.go_on_from(memory.events, snapshot.bodies);
    parts.earlier_events = snapshot.events;
    parts.earlier_collisions = snapshot.collisions;
    parts.initial_total = snapshot.initial_total;
    parts.handovers = snapshot.handovers;
    parts.ledger = snapshot.ledger;
    parts.max_overlap = snapshot.max_overlap;
    parts.clock = snapshot.time;
    parts.has_begun = memory.has_begun;
    if (memory.rest) {
        parts.start_rest(0.0);
        parts.rest->go_on_from(*memory.rest);
        parts.clock = snapshot.time;
    }
    if (memory.hybrid) {
        parts.start_hybrid();
        parts.hybrid->go_on_from(parts.engine, *memory.hybrid);
    }
    return world;
}

Snapshot World::snapshot() const
{
    const Parts& parts = *parts_;
    Snapshot snapshot;
    snapshot.time = time();
    for (int k = 0; k < body_count(); ++k) snapshot.bodies.push_back(parts.engine.flyer(k).state);
    snapshot.events = events();
    snapshot.collisions = collisions();
    snapshot.max_overlap = parts.max_overlap;
    snapshot.initial_total = parts.initial_total;
    EngineMemory memory{parts.engine.resume(), {}, {}, parts.has_begun};
    if (parts.rest) memory.rest = parts.rest->memory();
    if (parts.hybrid) memory.hybrid = parts.hybrid->memory();
    snapshot.engines = std::make_shared<const EngineMemory>(std::move(memory));
    snapshot.handovers = parts.handovers;
    snapshot.ledger = parts.ledger;
    return snapshot;
}
// [world.resume]

// [world.hand-over]
void World::Parts::start_rest(double time)
{
    RestOptions rest_options;
    rest_options.step = options.step;
    if (const auto* central = std::get_if<CentralField>(&scene.world.field)) rest_options.centre = *central;
    rest_options.seconds = seconds;
    rest.emplace(bodies_at_rest(engine, materials, time), rest_options, time);
    clock = time;
}

void World::Parts::start_hybrid()
{
    hybrid.emplace(engine, materials, is_static,
                   Hybrid::Setting{options.step, scene.world.field, seconds});
}

/// Give to the resting integrator who leans on something from the start, if the user left the choice to us.
void World::Parts::begin()
{
    has_begun = true;
    const Field& field = scene.world.field;
    const bool is_central = std::holds_alternative<CentralField>(field);
    const bool any_field = is_central || uniform_acceleration(field) != Vec2::Zero();
    if (options.engine != EngineChoice::automatic || !any_field) return;
    const std::vector<int> leaning = find_leaning(engine, field);
    if (leaning.empty()) return;
    start_hybrid();
    clock = engine.time();
    hybrid->take_leaning(engine, leaning);
}

RunFailure World::Parts::fail(const EventFailure& failure)
{
    failed = true;
    clock = failure.time;
    return describe(failure, scene);
}

/// Put what the integrators did with each other into the words of the scene.
void World::Parts::note_handovers()
{
    for (const Hybrid::Change& change : hybrid->fetch_changes()) {
        handovers.push_back(describe(change, scene));
        ledger.handovers += handovers.back().energy_change;
    }
}

EnergyLedger World::Parts::whole_ledger() const
{
    EnergyLedger whole = ledger;
    whole.impacts -= engine.energy_lost();
    if (hybrid) {
        whole.steps += hybrid->energy_of_steps();
        whole.handovers += hybrid->energy_of_blows();
    }
    return whole;
}
// [world.hand-over]

// [world.advance]
std::optional<RunFailure> World::advance(double time, std::int64_t max_events)
{
    Parts& parts = *parts_;
    if (parts.failed) return std::nullopt;
    if (parts.rest) {
        parts.advance_rest(time, max_events);
        return std::nullopt;
    }
    if (!parts.has_begun) parts.begin();
    if (!parts.hybrid) {
        const std::optional<EventFailure> failure = parts.engine.advance(time, max_events);
        if (!failure) return std::nullopt;

        // Give to the resting integrator what crowds, if the user left the choice to us
        const bool may = parts.options.engine == EngineChoice::automatic;
        if (!may || !Hybrid::takes(*failure)) return parts.fail(*failure);
        parts.start_hybrid();
        parts.clock = failure->time;
        parts.hybrid->take(parts.engine, *failure);
    }
    return parts.advance_hybrid(time, max_events);
}

std::optional<RunFailure> World::Parts::advance_hybrid(double time, std::int64_t most)
{
    const std::optional<EventFailure> failure = hybrid->advance(engine, time, most);
    note_handovers();
    if (failure) return fail(*failure);
    clock = std::max(clock, most < 0 ? time : std::min(time, engine.time()));
    return std::nullopt;
}

void World::Parts::advance_rest(double time, std::int64_t most)
{
    // A step that ends at `time` but for rounding belongs to it
    const double whole = time + 1e-9 * options.step;
    for (std::int64_t made = 0; rest->time() + options.step <= whole; ++made) {
        if (made == most) {
            clock = rest->time();
            return;
        }
        rest->step();
    }
    clock = std::max(clock, time);
}
// [world.advance]

double World::time() const { return parts_->rest || parts_->hybrid ? parts_->clock : parts_->engine.time(); }
int World::body_count() const { return static_cast<int>(parts_->scene.bodies.size()); }
BodyState World::state(int index) const { return parts_->state(index); }

BodyState World::Parts::state(int body) const
{
    if (rest) return rest->state(body);
    if (hybrid) return hybrid->state(engine, body, clock);
    return state_at(engine.flyer(body), engine.time());
}

World::Mover World::mover(int index) const
{
    const Parts& parts = *parts_;
    if (is_static(index)) return Mover::nobody;
    if (parts.rest) return parts.rest->is_asleep(index) ? Mover::asleep : Mover::rest;
    if (!parts.hybrid) return Mover::events;
    return parts.hybrid->leans(index) ? Mover::rest : parts.hybrid->lies(index) ? Mover::asleep : Mover::events;
}

std::vector<BodyView> World::Parts::view() const
{
    std::vector<BodyView> bodies;
    for (int k = 0; k < engine.body_count(); ++k) {
        bodies.push_back({state(k), engine.inertia(k), &engine.shape(k), is_static[k] != 0});
    }
    return bodies;
}

const Shape& World::shape(int index) const { return parts_->engine.shape(index); }
bool World::is_static(int index) const { return parts_->is_static[static_cast<std::size_t>(index)] != 0; }
const Scene& World::scene() const { return parts_->scene; }
const std::vector<Handover>& World::handovers() const { return parts_->handovers; }

std::int64_t World::events() const
{
    const RestEngine* rest = parts_->rest ? &*parts_->rest : parts_->hybrid ? &parts_->hybrid->rest() : nullptr;
    return parts_->earlier_events + parts_->engine.counts().events + (rest ? rest->counts().steps : 0);
}

std::int64_t World::collisions() const
{
    const RestEngine* rest = parts_->rest ? &*parts_->rest : parts_->hybrid ? &parts_->hybrid->rest() : nullptr;
    return parts_->earlier_collisions + parts_->engine.counts().impacts + (rest ? rest->counts().impacts : 0);
}

std::uint64_t World::log_hash() const { return parts_->engine.log_hash(); }

void World::set_stopwatch(double (*seconds)())
{
    parts_->seconds = seconds;
    parts_->engine.set_clock(seconds);
    if (parts_->rest) parts_->rest->set_clock(seconds);
    if (parts_->hybrid) parts_->hybrid->set_clock(seconds);
}

// [world.report]
Report World::report()
{
    Parts& parts = *parts_;
    const std::vector<BodyView> bodies = parts.view();
    const Account account = take_account(bodies, parts.scene);
    parts.max_overlap = std::max({parts.max_overlap, parts.engine.max_overlap(), deepest_overlap(bodies, parts.shapes)});
    const RestEngine* rest = parts.rest ? &*parts.rest : parts.hybrid ? &parts.hybrid->rest() : nullptr;
    if (rest) parts.max_overlap = std::max(parts.max_overlap, rest->max_overlap());

    Report report;
    report.time = time();
    const bool only_rest = parts.options.engine == EngineChoice::rest;
    report.engine = only_rest ? "rest" : parts.hybrid ? "events and rest" : "events";
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
    report.hash = final_hash(parts.engine.log_hash(), report.bodies);
    report.plan = plan_with_savings(parts.plan, parts.engine.counts());
    report.stages = stage_costs(parts.engine.counts(), parts.engine.seconds());
    if (rest) {
        const std::vector<StageCost> more = stage_costs(rest->counts(), rest->seconds());
        report.stages.insert(report.stages.end(), more.begin(), more.end());
    }
    return report;
}
// [world.report]

} // namespace flying
