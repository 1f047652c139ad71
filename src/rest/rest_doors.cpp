#include <algorithm>
#include <cmath>

#include "rest/rest_engine.hpp"
#include "rest/rest_tolerance.hpp"

namespace flying {
namespace {


// What lets others share bodies with this integrator: steps of any length, a look ahead, and its memory.

/// [speeds of the pair] An approach this slow is rounding.
constexpr double k_no_approach = 0x1p-44;

/// [whole steps] A step this short tells nothing about accelerations.
constexpr double k_telling = 0x1p-20;


} // namespace


void RestEngine::step_by(double length, double end)
{
    const double whole = options_.step;
    if (length == whole) {
        step();
    } else {
        // Loads are remembered for a whole step, and only a whole one shows that nothing changes
        const bool sleeps = options_.sleeps;
        const bool tells = length > k_telling * whole;
        const std::vector<Vec2> pull = tells ? std::vector<Vec2>() : pull_;
        const std::vector<double> turn_pull = tells ? std::vector<double>() : turn_pull_;
        scale_loads_awake(length / whole);
        options_.step = length;
        options_.sleeps = false;
        step();
        options_.step = whole;
        options_.sleeps = sleeps;
        scale_loads_awake(whole / length);
        if (!tells) {
            pull_ = pull;
            turn_pull_ = turn_pull;
        }
    }
    start_ = end;
    steps_ = 0;
}

void RestEngine::scale_loads_awake(double factor)
{
    const auto is_awake = [&](int body) {
        return !bodies_[body].is_static && bodies_[body].is_active && !asleep_[body];
    };
    std::vector<int> pairs;
    for (int k = 0; k < static_cast<int>(pairs_.pairs().size()); ++k) {
        const RestPair& pair = pairs_.pairs()[k];
        if (is_awake(pair.a) || is_awake(pair.b)) pairs.push_back(k);
    }
    scale_loads(pairs, factor);
}

void RestEngine::set_time(double time)
{
    start_ = time;
    steps_ = 0;
}



void RestEngine::find_clear(double within, std::vector<char>& clear) const
{
    clear.assign(bodies_.size(), 0);
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const RestBody& body = bodies_[k];
        clear[order_[k]] = body.is_active && !body.is_static && !asleep_[k] ? 1 : 0;
    }
    for (const RestPair& pair : pairs_.pairs()) {
        char& clear_a = clear[order_[pair.a]];
        char& clear_b = clear[order_[pair.b]];
        if (!clear_a && !clear_b) continue;
        bool loaded = false;
        for (int k = 0; k < pair.count; ++k) loaded = loaded || pair.normal[k] > 0.0;
        if (loaded || !stays_apart(pair, within)) clear_a = clear_b = 0;
    }
}

/// No point of the pair closes for so long.
bool RestEngine::stays_apart(const RestPair& pair, double within) const
{
    const RestBody& a = bodies_[pair.a];
    const RestBody& b = bodies_[pair.b];
    const auto speed = [&](int index) {
        const BodyState& s = bodies_[index].state;
        return bodies_[index].is_static ? 0.0 : s.velocity.norm() + std::abs(s.spin) * radius_[index];
    };
    const auto pull = [&](int index) {
        const bool rests = bodies_[index].is_static || asleep_[index];
        return rests ? Vec2(Vec2::Zero()) : field_at(index, bodies_[index].state.position);
    };
    const double top = speed(pair.a) + speed(pair.b);
    const Vec2 fall = pull(pair.b) - pull(pair.a);
    const double touch = touch_gap(pair.a, pair.b);
    const double margin = within * (top + 0.5 * within * fall.norm()) + touch;

    // Look at the points that are near
    const ConvexPart& part_a = shapes_[pair.a].parts[pair.part_a];
    const ConvexPart& part_b = shapes_[pair.b].parts[pair.part_b];
    const Pose pose_a = pose_of(a.state);
    const Pose pose_b = pose_of(b.state);
    const double far = part_a.radius + part_b.radius + margin;
    const Vec2 way =
        (pose_b.position - pose_a.position) + (pose_b.rotation * part_b.centre - pose_a.rotation * part_a.centre);
    if (way.squaredNorm() > far * far) return true;
    const Manifold manifold = look(pair, pose_a, pose_b, margin);
    for (int k = 0; k < manifold.count; ++k) {
        const Contact& contact = manifold.contacts[k];
        const Vec2 velocity_a = velocity_at(a.state, contact.point - pose_a.position);
        const Vec2 velocity_b = velocity_at(b.state, contact.point - pose_b.position);
        double u = (velocity_b - velocity_a).dot(contact.normal);
        if (std::abs(u) <= k_no_approach * top) u = 0.0;
        const double f = fall.dot(contact.normal);
        if (contact.separation < -touch) return false;
        if (u >= 0.0 && f >= 0.0) continue;

        // The gap is least at the end, or where the approach ends before
        const double least_at = u < 0.0 && f > 0.0 ? std::min(within, -u / f) : within;
        if (!(contact.separation + least_at * (u + 0.5 * least_at * f) > touch)) return false;
    }
    return true;
}



RestEngine::Memory RestEngine::memory() const
{
    Memory memory{time(), order_, {}, {pairs_.pairs().begin(), pairs_.pairs().end()}, max_overlap_};
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        memory.bodies.push_back({bodies_[k].state, pull_[k], turn_pull_[k], reach_[k],
                                 asleep_[k] ? sleep_group_[k] : -1, bodies_[k].is_active, in_crowd_[k] != 0});
    }
    return memory;
}

void RestEngine::go_on_from(const Memory& memory)
{
    if (memory.order != order_) {
        std::vector<RestBody> bodies;
        for (const int place : place_) bodies.push_back(bodies_[place]);
        *this = RestEngine(std::move(bodies), options_, memory.time, memory.order);
    }
    set_time(memory.time);
    sleepers_ = -1;
    max_overlap_ = memory.max_overlap;
    pairs_.remember(memory.pairs);
    for (RestPair& pair : pairs_.pairs()) pair.memory = {}; // ways are counted from another beginning
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const Memory::Body& body = memory.bodies[k];
        bodies_[k].state = body.state;
        bodies_[k].is_active = body.is_active;
        pull_[k] = body.pull;
        turn_pull_[k] = body.turn_pull;
        reach_[k] = body.reach;
        sleep_group_[k] = body.sleep_group;
        in_crowd_[k] = body.in_crowd ? 1 : 0;
        asleep_[k] = still_[k] = body.sleep_group >= 0 ? 1 : 0;
        set_pose(static_cast<int>(k), pose_of(body.state));
        next_poses_[k] = poses_[k];
        if (bodies_[k].is_static) continue;
        Mover& mover = movers_[k];
        mover.v_x = body.state.velocity.x();
        mover.v_y = body.state.velocity.y();
        mover.spin = body.state.spin;
        before_[k] = mover;
    }
}


} // namespace flying
