#include "play/run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "play/inside.hpp"
#include "world/make_room.hpp"

namespace flying {

namespace {

constexpr std::size_t k_most_moments = 400;
/// Numbers that all moments together may hold, about.
constexpr std::size_t k_most_bodies_held = 400000;
/// [bounding radii] What leaning and rounding may have brought since the scene was last made.
constexpr double k_slight = 0.05;
/// [bounding radii] Where bodies are moved on purpose.
constexpr double k_far = 1e6;

} // namespace

PlayRun::PlayRun(World world, std::shared_ptr<const Scene> scene, const WorldOptions& options)
    : world_(std::move(world)), first_(scene), scene_(std::move(scene)), options_(options)
{
    inertia_ = weigh_all(world_);
    moments_.push_back(moment());
}

Expected<PlayRun> PlayRun::start(Scene scene, const WorldOptions& options)
{
    Expected<World> world = World::make(scene, options);
    if (!world) return world.faults();
    return PlayRun(std::move(world).value(), std::make_shared<const Scene>(std::move(scene)), options);
}

PlayRun::Advance PlayRun::advance(double time, std::int64_t most)
{
    Advance done;
    const double target = time - origin_;
    const std::int64_t before = world_.events();
    done.failure = world_.advance(target, most);
    done.arrived = !done.failure && world_.time() >= target && world_.events() - before < most;
    return done;
}

PlayRun::Moment PlayRun::moment() const
{
    return {scene_, std::make_shared<const Snapshot>(world_.snapshot()), origin_, earlier_events_, earlier_collisions_, {}, std::numeric_limits<double>::infinity()};
}

void PlayRun::remember(double apart)
{
    if (!moments_.empty() && time() - moments_.back().time() < apart) return;
    moments_.push_back(moment());
    forget_some();
}

/// Drop every second of the older moments that no change needs, then the oldest; the first one stays.
void PlayRun::forget_some()
{
    const std::size_t bodies = std::max<std::size_t>(1, scene_->bodies.size());
    const std::size_t most = std::clamp<std::size_t>(k_most_bodies_held / bodies, 20, k_most_moments);
    if (moments_.size() <= most) return;
    std::deque<Moment> kept;
    const std::size_t recent = moments_.size() - most / 2;
    for (std::size_t k = 0; k < moments_.size(); ++k) {
        if (k == 0 || k >= recent || k % 2 == 0 || !moments_[k].undoes.empty()) kept.push_back(std::move(moments_[k]));
    }
    while (kept.size() > most) kept.erase(kept.begin() + 1);
    moments_ = std::move(kept);
}

Scene PlayRun::scene_now()
{
    // Within a step, bodies that lean are on interpolated ways, which may overlap
    if (const std::optional<double> end = world_.step_end()) (void)world_.advance(*end);

    Scene scene = world_.scene();
    for (int k = 0; k < world_.body_count(); ++k) {
        BodyDef& def = scene.bodies[static_cast<std::size_t>(k)];
        if (def.is_static) continue;
        const BodyState state = world_.state(k);
        def.position = state.position;
        def.angle = state.angle;
        def.velocity = state.velocity;
        def.spin = state.spin;
    }
    return scene;
}

Faults PlayRun::change(Scene scene, const std::string& label, Crowding crowding)
{
    Expected<World> made = World::make(scene, options_);
    if (!made) {
        Scene roomy = scene;
        if (make_room(roomy, crowding == Crowding::refuse ? k_slight : k_far)) {
            Expected<World> second = World::make(roomy, options_);
            if (second) scene = std::move(roomy);
            if (second) made = std::move(second);
        }
        if (!made) return made.faults();
    }

    // One stroke of the hand is one change
    if (stroke_ != label || stroke_.empty()) {
        if (moments_.empty() || moments_.back().time() != time() || !moments_.back().undoes.empty()) {
            moments_.push_back(moment());
        }
        moments_.back().undoes = label;
    }
    stroke_ = label;
    undone_.clear();
    moments_.back().holds_until = time();
    earlier_events_ += world_.events();
    earlier_collisions_ += world_.collisions();
    origin_ += world_.time();
    world_ = std::move(made).value();
    scene_ = std::make_shared<const Scene>(std::move(scene));
    inertia_ = weigh_all(world_);
    ++generation_;
    moments_.push_back(moment());
    forget_some();
    return {};
}

void PlayRun::restore(const Moment& moment)
{
    Expected<World> world = World::resume(*moment.scene, *moment.snapshot, options_);
    if (!world) return; // it ran before: there are no faults
    world_ = std::move(world).value();
    scene_ = moment.scene;
    origin_ = moment.origin;
    earlier_events_ = moment.events;
    earlier_collisions_ = moment.collisions;
    inertia_ = weigh_all(world_);
    ++generation_;
}

bool PlayRun::can_undo() const
{
    return std::any_of(moments_.begin(), moments_.end(), [](const Moment& m) { return !m.undoes.empty(); });
}

std::string PlayRun::undo()
{
    stroke_.clear();
    if (!can_undo()) return {};
    Undone undone;
    undone.followed.push_back(moment());
    while (moments_.back().undoes.empty()) {
        undone.followed.push_back(std::move(moments_.back()));
        moments_.pop_back();
    }
    std::reverse(undone.followed.begin(), undone.followed.end());
    undone.before = moments_.back();
    undone_.push_back(std::move(undone));
    const std::string label = std::exchange(moments_.back().undoes, {});
    moments_.back().holds_until = std::numeric_limits<double>::infinity();
    restore(moments_.back());
    return label;
}

std::string PlayRun::redo()
{
    stroke_.clear();
    if (undone_.empty()) return {};
    Undone undone = std::move(undone_.back());
    undone_.pop_back();

    // What has happened since the undo gives way to what was undone
    const double start = undone.before.time();
    while (!moments_.empty() && moments_.back().undoes.empty() && moments_.back().time() >= start) moments_.pop_back();
    const std::string label = undone.before.undoes;
    moments_.push_back(std::move(undone.before));
    for (Moment& moment : undone.followed) moments_.push_back(std::move(moment));
    restore(moments_.back());
    forget_some();
    return label;
}

void PlayRun::reset()
{
    stroke_.clear();
    undone_.clear();
    Expected<World> world = World::make(*first_, options_);
    if (!world) return; // it ran before
    world_ = std::move(world).value();
    scene_ = first_;
    origin_ = 0.0;
    earlier_events_ = earlier_collisions_ = 0;
    inertia_ = weigh_all(world_);
    ++generation_;
    moments_.clear();
    moments_.push_back(moment());
}

double PlayRun::rewind(double time)
{
    stroke_.clear();
    undone_.clear();
    while (moments_.size() > 1 && moments_.back().time() > time) moments_.pop_back();
    Moment& last = moments_.back();
    const double end = std::min(time, last.holds_until);
    last.undoes.clear(); // what followed has not happened yet
    last.holds_until = std::numeric_limits<double>::infinity();
    restore(last);
    return end;
}

bool PlayRun::go_back(double time)
{
    const double end = rewind(time);
    if (this->time() > time) return false;
    (void)advance(end, -1);
    return end == time;
}

double PlayRun::earliest() const
{
    return moments_.front().time();
}

} // namespace flying
