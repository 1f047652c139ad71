#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "world/world.hpp"

namespace flying {

/// How far a run got.
enum class LiveEnd
{
    there,      ///< at the time that was asked for
    on_the_way, ///< as far as the bound on the work let it: ask again
    stopped     ///< it can't go on, and `message` says why
};

/// A scene in motion as a page drives it: text in, plain numbers out, every failure a sentence. What it hands out stays
/// where it is until the same is asked again.
class LiveRun
{
public:
    /// text  a scene as `read_scene_text` takes it; where it is none, the run is not ready and its message has all faults
    LiveRun(std::string_view text, const WorldOptions& options);

    /// The scene was fit to run. All that follows, but the message, may be asked only then.
    [[nodiscard]] bool is_ready() const { return world_.has_value(); }

    /// What is wrong with the scene, a line for each fault, or why the run stopped; empty where all is well.
    [[nodiscard]] const std::string& message() const { return message_; }

    /// Move on to `time`, but handle no more than about `most` events or steps, so that the page stays awake.
    /// time  earlier ones do nothing [s]
    /// most  >= 1
    [[nodiscard]] LiveEnd advance(double time, int most);

    /// Give a body another velocity and go on from there: a new run of the scene with its bodies as they are now. Counts
    /// and the hash start anew. False, and nothing is changed, for a static body, and where bodies rest on each other so
    /// closely that the scene of this moment can't be started.
    [[nodiscard]] bool steer(int body, const Vec2& velocity);

    /// What the plan skips and how much it saved, a line for each skip.
    [[nodiscard]] std::string plan_lines();

    /// Six numbers for each body of the scene at the run's time: x, y [m], angle [rad], velocity along x and y [m/s],
    /// spin [rad/s].
    [[nodiscard]] const std::vector<double>& states();

    /// How a body looks about its centre of mass [m]. Of a polygon, for each ring: the number of its vertices, then
    /// their x and y. Of a disc: 0, then its radius.
    [[nodiscard]] const std::vector<double>& outline(int body);

    /// The box around the scene: left, bottom, right, top [m]; empty where there is none.
    [[nodiscard]] const std::vector<double>& box();

    /// Of the run, whatever was steered.  [s]
    [[nodiscard]] double time() const { return origin_ + world_->time(); }

    [[nodiscard]] World& world() { return *world_; }
    [[nodiscard]] const World& world() const { return *world_; }

private:
    WorldOptions options_;
    double origin_ = 0.0; ///< time at which the world's clock was 0 [s]
    std::optional<World> world_;
    std::string message_;
    std::vector<double> states_;
    std::vector<double> outline_;
    std::vector<double> box_;
};

} // namespace flying
