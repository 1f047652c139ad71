#include "reference_discs.hpp"

#include <algorithm>
#include <cmath>
#include <queue>

#include "weighed.hpp"

namespace flying::bench {
namespace {

using Real = long double;

struct Disc
{
    Real x, y, vx, vy; // at `time`
    Real time = 0;
    Real list_x = 0, list_y = 0; // where it was when its list was made
    Real radius, mass;
    unsigned pushes = 0;
    unsigned lists = 0;
    std::vector<int> near = {};
};

struct Happening
{
    enum Kind
    {
        pair,
        wall_x,
        wall_y,
        list
    };
    Real time;
    Kind kind;
    int a, b;
    unsigned pushes_a, pushes_b;
    bool operator<(const Happening& other) const { return time > other.time; }
};

class Gas
{
public:
    Gas(const Scene& scene, Real shift)
        : shift_(shift),
          low_x_(scene.world.box->min.x() + shift),
          low_y_(scene.world.box->min.y() + shift),
          high_x_(scene.world.box->max.x() + shift),
          high_y_(scene.world.box->max.y() + shift)
    {
        for (const WeighedBody& body : weigh(scene)) {
            const BodyState& s = body.start;
            discs_.push_back({s.position.x() + shift, s.position.y() + shift, s.velocity.x(), s.velocity.y(), 0, 0, 0,
                              body.radius, body.mass});
            margin_ = std::max<Real>(margin_, 2 * body.radius);
        }
        for (Disc& disc : discs_) {
            disc.list_x = disc.x;
            disc.list_y = disc.y;
        }
        for (int k = 0; k < static_cast<int>(discs_.size()); ++k) {
            make_list(k);
            foresee_alone(k);
        }
    }

    void run(Real until)
    {
        while (!queue_.empty() && queue_.top().time <= until) {
            const Happening next = queue_.top();
            queue_.pop();
            if (next.pushes_a != stamp(next.a, next.kind)) continue;
            if (next.b >= 0 && next.pushes_b != discs_[next.b].pushes) continue;
            happen(next);
        }
        for (Disc& disc : discs_) move(disc, until);
    }

    [[nodiscard]] std::vector<BodyState> states(double time) const
    {
        std::vector<BodyState> states;
        for (const Disc& disc : discs_) {
            states.push_back({Vec2(static_cast<double>(disc.x - shift_), static_cast<double>(disc.y - shift_)),
                              Vec2(static_cast<double>(disc.vx), static_cast<double>(disc.vy)), 0.0, 0.0, time});
        }
        return states;
    }

private:
    // A list counts as left only once; impacts are foreseen anew after each push, and so is leaving the list
    [[nodiscard]] unsigned stamp(int a, Happening::Kind kind) const
    {
        return kind == Happening::list ? discs_[a].pushes + discs_[a].lists : discs_[a].pushes;
    }

    static void move(Disc& disc, Real time)
    {
        disc.x += disc.vx * (time - disc.time);
        disc.y += disc.vy * (time - disc.time);
        disc.time = time;
    }

    void happen(const Happening& next)
    {
        Disc& a = discs_[next.a];
        move(a, next.time);
        if (next.kind == Happening::list) {
            a.list_x = a.x;
            a.list_y = a.y;
            ++a.lists;
            for (const int other : a.near) std::erase(discs_[other].near, next.a);
            a.near.clear();
            make_list(next.a);
            foresee_list(next.a);
            return;
        }
        if (next.kind == Happening::wall_x) a.vx = -a.vx;
        if (next.kind == Happening::wall_y) a.vy = -a.vy;
        if (next.kind == Happening::pair) {
            Disc& b = discs_[next.b];
            move(b, next.time);
            const Real dx = b.x - a.x;
            const Real dy = b.y - a.y;
            const Real approach = ((b.vx - a.vx) * dx + (b.vy - a.vy) * dy) / (dx * dx + dy * dy);
            const Real impulse = -2 * approach * a.mass * b.mass / (a.mass + b.mass);
            a.vx -= impulse / a.mass * dx;
            a.vy -= impulse / a.mass * dy;
            b.vx += impulse / b.mass * dx;
            b.vy += impulse / b.mass * dy;
            ++b.pushes;
        }
        ++a.pushes;
        foresee(next.a);
        if (next.b >= 0) foresee(next.b);
    }

    // All whose lists were made near enough to meet this one before either leaves its own
    void make_list(int a)
    {
        Disc& disc = discs_[a];
        for (int b = 0; b < static_cast<int>(discs_.size()); ++b) {
            Disc& other = discs_[b];
            const Real reach = disc.radius + other.radius + margin_;
            const Real dx = disc.list_x - other.list_x;
            const Real dy = disc.list_y - other.list_y;
            if (a == b || dx * dx + dy * dy > reach * reach) continue;
            if (std::find(disc.near.begin(), disc.near.end(), b) != disc.near.end()) continue;
            disc.near.push_back(b);
            other.near.push_back(a);
            foresee_pair(a, b);
        }
    }

    void foresee(int a)
    {
        foresee_alone(a);
        for (const int b : discs_[a].near) foresee_pair(a, b);
    }

    void foresee_alone(int a)
    {
        const Disc& disc = discs_[a];
        const auto wall = [&](Real x, Real v, Real low, Real high, Happening::Kind kind) {
            if (v == 0) return;
            const Real room = v > 0 ? high - disc.radius - x : x - disc.radius - low;
            const Real time = disc.time + std::max<Real>(room, 0) / std::abs(v);
            queue_.push({time, kind, a, -1, disc.pushes, 0});
        };
        wall(disc.x, disc.vx, low_x_, high_x_, Happening::wall_x);
        wall(disc.y, disc.vy, low_y_, high_y_, Happening::wall_y);
        foresee_list(a);
    }

    // When the disc will have gone half the margin from where its list was made
    void foresee_list(int a)
    {
        const Disc& disc = discs_[a];
        const Real x = disc.x - disc.list_x;
        const Real y = disc.y - disc.list_y;
        const Real v2 = disc.vx * disc.vx + disc.vy * disc.vy;
        if (v2 == 0) return;
        const Real b = x * disc.vx + y * disc.vy;
        const Real c = std::max<Real>(margin_ * margin_ / 4 - x * x - y * y, 0);
        const Real time = disc.time + (std::sqrt(b * b + v2 * c) - b) / v2;
        queue_.push({time, Happening::list, a, -1, disc.pushes + disc.lists, 0});
    }

    void foresee_pair(int i, int j)
    {
        const Disc& a = discs_[i];
        const Disc& b = discs_[j];
        const Real start = std::max(a.time, b.time);
        const Real x = b.x + b.vx * (start - b.time) - a.x - a.vx * (start - a.time);
        const Real y = b.y + b.vy * (start - b.time) - a.y - a.vy * (start - a.time);
        const Real vx = b.vx - a.vx;
        const Real vy = b.vy - a.vy;
        const Real half_b = x * vx + y * vy;
        if (half_b >= 0) return;
        const Real reach = a.radius + b.radius;
        const Real c = x * x + y * y - reach * reach;
        const Real under_root = half_b * half_b - (vx * vx + vy * vy) * c;
        if (under_root < 0) return;
        const Real time = start + std::max<Real>(c / (std::sqrt(under_root) - half_b), 0);
        queue_.push({time, Happening::pair, i, j, a.pushes, b.pushes});
    }

    Real shift_;
    Real low_x_, low_y_, high_x_, high_y_;
    Real margin_ = 0;
    std::vector<Disc> discs_;
    std::priority_queue<Happening> queue_;
};

} // namespace

std::vector<BodyState> reference_discs(const Scene& scene, double time, double shift)
{
    Gas gas(scene, shift);
    gas.run(time);
    return gas.states(time);
}

bool has_reference(const Scene& scene)
{
    const WorldDef& world = scene.world;
    if (!world.box || !std::holds_alternative<NoField>(world.field)) return false;
    if (world.restitution != 1.0 || world.friction != 0.0) return false;
    return std::all_of(scene.bodies.begin(), scene.bodies.end(), [](const BodyDef& body) {
        return std::holds_alternative<DiscDef>(body.shape) && !body.is_static && !body.restitution && !body.friction;
    });
}

} // namespace flying::bench
