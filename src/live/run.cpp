#include "live/run.hpp"

#include <cstdint>
#include <utility>
#include <variant>

#include "scene/fault.hpp"
#include "scene/read.hpp"

namespace flying {

LiveRun::LiveRun(std::string_view text, const WorldOptions& options) : options_(options)
{
    const Expected<Scene> scene = read_scene_text(text, "scene");
    if (!scene) {
        message_ = format_faults(scene.faults());
        return;
    }
    Expected<World> world = World::make(scene.value(), options);
    if (world) {
        world_.emplace(std::move(world).value());
    } else {
        message_ = format_faults(world.faults());
    }
}

LiveEnd LiveRun::advance(double time, int most)
{
    if (!message_.empty()) return LiveEnd::stopped;

    const std::int64_t before = world_->events();
    if (const std::optional<RunFailure> failure = world_->advance(time - origin_, most)) {
        message_ = failure->message;
        return LiveEnd::stopped;
    }

    // More events may wait at the very time at which the clock stands
    const bool has_room = world_->events() - before < most;
    return world_->time() >= time - origin_ && has_room ? LiveEnd::there : LiveEnd::on_the_way;
}

bool LiveRun::steer(int body, const Vec2& velocity)
{
    if (body < 0 || body >= world_->body_count() || world_->is_static(body)) return false;
    Scene scene = world_->scene();
    for (int k = 0; k < world_->body_count(); ++k) {
        const BodyState state = world_->state(k);
        BodyDef& def = scene.bodies[static_cast<std::size_t>(k)];
        def.position = state.position;
        def.angle = state.angle;
        if (def.is_static) continue;
        def.velocity = k == body ? velocity : state.velocity;
        def.spin = state.spin;
    }
    Expected<World> made = World::make(scene, options_);
    if (!made) return false;
    origin_ += world_->time();
    world_.emplace(std::move(made).value());
    return true;
}

std::string LiveRun::plan_lines()
{
    std::string lines;
    for (const Skip& skip : world_->report().plan.skips) {
        const char* kind = skip.kind == SkipClass::neutral ? "N" : skip.kind == SkipClass::ordered ? "O" : "A";
        lines += skip.name + "\t" + kind + "\t" + (skip.active ? "1" : "0") + "\t" + std::to_string(skip.saved) + "\t" +
                 skip.saved_unit + "\t" + skip.reason + "\n";
    }
    return lines;
}

const std::vector<double>& LiveRun::states()
{
    states_.clear();
    for (int body = 0; body < world_->body_count(); ++body) {
        const BodyState state = world_->state(body);
        states_.insert(states_.end(), {state.position.x(), state.position.y(), state.angle, state.velocity.x(),
                                       state.velocity.y(), state.spin});
    }
    return states_;
}

const std::vector<double>& LiveRun::outline(int body)
{
    outline_.clear();
    const Shape& shape = world_->shape(body);
    if (const auto* disc = std::get_if<Disc>(&shape)) outline_ = {0.0, disc->radius};
    if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        const std::span<const int> starts = polygon->ring_starts();
        for (std::size_t ring = 0; ring + 1 < starts.size(); ++ring) {
            outline_.push_back(starts[ring + 1] - starts[ring]);
            for (int k = starts[ring]; k < starts[ring + 1]; ++k) {
                const Vec2& vertex = polygon->vertices()[static_cast<std::size_t>(k)];
                outline_.insert(outline_.end(), {vertex.x(), vertex.y()});
            }
        }
    }
    return outline_;
}

const std::vector<double>& LiveRun::box()
{
    box_.clear();
    const std::optional<BoxDef>& box = world_->scene().world.box;
    if (box) box_ = {box->min.x(), box->min.y(), box->max.x(), box->max.y()};
    return box_;
}

} // namespace flying
