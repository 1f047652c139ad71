#include "numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace flying::bench {
namespace {

constexpr double k_step_hertz = 60.0;

/// One body round a centre, by Verlet's steps.
template <typename Real>
class Orbiting
{
public:
    Orbiting(const Scene& scene, double hertz) : hertz_(hertz), h_(static_cast<Real>(1.0 / hertz))
    {
        const BodyDef& body = scene.bodies.front();
        x_ = static_cast<Real>(body.position.x());
        y_ = static_cast<Real>(body.position.y());
        vx_ = static_cast<Real>(body.velocity.x());
        vy_ = static_cast<Real>(body.velocity.y());
        mu_ = static_cast<Real>(std::get<CentralField>(scene.world.field).mu);
        pull();
    }

    void advance(double time)
    {
        const Real half = h_ / 2;
        for (const long until = std::lround(time * hertz_); steps_ < until; ++steps_) {
            vx_ += half * ax_;
            vy_ += half * ay_;
            x_ += h_ * vx_;
            y_ += h_ * vy_;
            pull();
            vx_ += half * ax_;
            vy_ += half * ay_;
        }
    }

    [[nodiscard]] std::vector<BodyState> states() const { return {{Vec2(x_, y_), Vec2(vx_, vy_), 0.0, 0.0, 0.0}}; }
    [[nodiscard]] std::vector<Load> loads() const { return {}; }

private:
    void pull()
    {
        const Real square = x_ * x_ + y_ * y_;
        const Real factor = -mu_ / (square * std::sqrt(square));
        ax_ = factor * x_;
        ay_ = factor * y_;
    }

    double hertz_;
    Real h_;
    Real x_, y_, vx_, vy_, mu_;
    Real ax_ = 0, ay_ = 0;
    long steps_ = 0;
};

/// Elastic discs in a box without a field, from impact to impact: the root of each pair, the impulse, and a list of the
/// next impact of each disc.
template <typename Real>
class KernelGas
{
public:
    KernelGas(const Scene& scene, double)
    {
        low_x_ = static_cast<Real>(scene.world.box->min.x());
        low_y_ = static_cast<Real>(scene.world.box->min.y());
        high_x_ = static_cast<Real>(scene.world.box->max.x());
        high_y_ = static_cast<Real>(scene.world.box->max.y());
        for (const WeighedBody& body : weigh(scene)) {
            x_.push_back(static_cast<Real>(body.start.position.x()));
            y_.push_back(static_cast<Real>(body.start.position.y()));
            vx_.push_back(static_cast<Real>(body.start.velocity.x()));
            vy_.push_back(static_cast<Real>(body.start.velocity.y()));
            radius_.push_back(static_cast<Real>(body.radius));
            mass_.push_back(static_cast<Real>(body.mass));
        }
        next_.resize(x_.size());
        for (std::size_t a = 0; a < x_.size(); ++a) find_next(a);
    }

    void advance(double time)
    {
        const auto until = static_cast<Real>(time);
        for (;;) {
            const auto first = std::min_element(next_.begin(), next_.end(),
                                                [](const Event& a, const Event& b) { return a.time < b.time; });
            const Event event = *first;
            if (!(event.time <= until)) break;
            const auto a = static_cast<std::size_t>(first - next_.begin());
            fly(event.time - now_);
            now_ = event.time;
            if (event.other >= 0) collide(a, static_cast<std::size_t>(event.other));
            else reflect(a, event.other);

            // Find the next impact of the two, and of each disc that was to meet one of them
            const int self = static_cast<int>(a);
            find_next(a);
            if (event.other >= 0) find_next(static_cast<std::size_t>(event.other));
            for (std::size_t k = 0; k < x_.size(); ++k) {
                const bool is_of_these = k == a || static_cast<int>(k) == event.other;
                if (is_of_these || next_[k].other < 0) continue;
                if (next_[k].other == self || next_[k].other == event.other) find_next(k);
            }
        }
        fly(until - now_);
        now_ = until;
    }

    [[nodiscard]] std::vector<BodyState> states() const
    {
        std::vector<BodyState> states;
        for (std::size_t k = 0; k < x_.size(); ++k)
            states.push_back({Vec2(x_[k], y_[k]), Vec2(vx_[k], vy_[k]), 0.0, 0.0, now_});
        return states;
    }
    [[nodiscard]] std::vector<Load> loads() const { return {}; }

private:
    static constexpr int k_wall_x = -1;
    static constexpr int k_wall_y = -2;
    struct Event
    {
        Real time = std::numeric_limits<Real>::infinity();
        int other = k_wall_x; ///< a disc, or which pair of walls
    };

    void fly(Real dt)
    {
        for (std::size_t k = 0; k < x_.size(); ++k) {
            x_[k] += dt * vx_[k];
            y_[k] += dt * vy_[k];
        }
    }

    /// How long until two discs touch: the smaller root, in the form that subtracts nothing that is nearly equal.
    [[nodiscard]] Real time_to_touch(std::size_t a, std::size_t b) const
    {
        const Real dx = x_[b] - x_[a];
        const Real dy = y_[b] - y_[a];
        const Real ux = vx_[b] - vx_[a];
        const Real uy = vy_[b] - vy_[a];
        const Real approach = dx * ux + dy * uy;
        if (approach >= 0) return std::numeric_limits<Real>::infinity();
        const Real reach = radius_[a] + radius_[b];
        const Real gap = dx * dx + dy * dy - reach * reach;
        if (gap <= 0) return 0;
        const Real discriminant = approach * approach - (ux * ux + uy * uy) * gap;
        if (discriminant < 0) return std::numeric_limits<Real>::infinity();
        return gap / (std::sqrt(discriminant) - approach);
    }

    void find_next(std::size_t a)
    {
        Event best;
        const auto offer = [&](Real wait, int other) {
            const Real time = now_ + std::max(wait, Real(0));
            if (time < best.time) best = {time, other};
        };
        if (vx_[a] != 0) offer(((vx_[a] > 0 ? high_x_ - radius_[a] : low_x_ + radius_[a]) - x_[a]) / vx_[a], k_wall_x);
        if (vy_[a] != 0) offer(((vy_[a] > 0 ? high_y_ - radius_[a] : low_y_ + radius_[a]) - y_[a]) / vy_[a], k_wall_y);
        for (std::size_t b = 0; b < x_.size(); ++b) {
            if (b != a) offer(time_to_touch(a, b), static_cast<int>(b));
        }
        next_[a] = best;

        // The other learns of it where that comes before what it knows
        if (best.other >= 0 && best.time < next_[static_cast<std::size_t>(best.other)].time)
            next_[static_cast<std::size_t>(best.other)] = {best.time, static_cast<int>(a)};
    }

    void collide(std::size_t a, std::size_t b)
    {
        Real nx = x_[b] - x_[a];
        Real ny = y_[b] - y_[a];
        const Real length = std::sqrt(nx * nx + ny * ny);
        nx /= length;
        ny /= length;
        const Real v_n = (vx_[b] - vx_[a]) * nx + (vy_[b] - vy_[a]) * ny;
        if (v_n >= 0) return;
        const Real j = -2 * v_n * mass_[a] * mass_[b] / (mass_[a] + mass_[b]);
        vx_[a] -= j / mass_[a] * nx;
        vy_[a] -= j / mass_[a] * ny;
        vx_[b] += j / mass_[b] * nx;
        vy_[b] += j / mass_[b] * ny;
    }

    void reflect(std::size_t a, int wall) { (wall == k_wall_x ? vx_ : vy_)[a] *= -1; }

    std::vector<Real> x_, y_, vx_, vy_, radius_, mass_;
    std::vector<Event> next_;
    Real low_x_, low_y_, high_x_, high_y_;
    Real now_ = 0;
};

/// Boxes that stand on each other: in each step, sweeps over the contacts find the impulses that stop gravity. Each
/// step begins without knowledge of the last.
template <typename Real>
class Stack
{
public:
    Stack(const Scene& scene, double hertz) : sweeps_(std::max(1L, std::lround(hertz / k_step_hertz)))
    {
        for (const WeighedBody& body : weigh(scene)) inv_mass_.push_back(static_cast<Real>(1.0 / body.mass));
        impulse_.resize(inv_mass_.size());
        v_.resize(inv_mass_.size());
        pull_ = static_cast<Real>(uniform_acceleration(scene.world.field).y() / k_step_hertz);
        start_ = weigh(scene);
    }

    void advance(double time)
    {
        for (const long until = std::lround(time * k_step_hertz); steps_ < until; ++steps_) {
            std::fill(impulse_.begin(), impulse_.end(), Real(0));
            std::fill(v_.begin(), v_.end(), pull_);
            for (long k = 0; k < sweeps_; ++k) sweep();
        }
    }

    [[nodiscard]] std::vector<BodyState> states() const
    {
        std::vector<BodyState> states;
        for (const WeighedBody& body : start_) states.push_back(body.start);
        return states;
    }
    [[nodiscard]] std::vector<Load> loads() const
    {
        std::vector<Load> loads;
        for (int k = 0; k < static_cast<int>(impulse_.size()); ++k)
            loads.push_back({k - 1, k, static_cast<double>(impulse_[k]) * k_step_hertz});
        return loads;
    }

private:
    /// Contact k lies under box k: on the floor, or on the box below.
    void sweep()
    {
        for (std::size_t k = 0; k < impulse_.size(); ++k) {
            const Real below = k > 0 ? v_[k - 1] : Real(0);
            const Real inv_below = k > 0 ? inv_mass_[k - 1] : Real(0);
            const Real before = impulse_[k];
            impulse_[k] = std::max(before - (v_[k] - below) / (inv_mass_[k] + inv_below), Real(0));
            v_[k] += (impulse_[k] - before) * inv_mass_[k];
            if (k > 0) v_[k - 1] -= (impulse_[k] - before) * inv_below;
        }
    }

    long sweeps_;
    std::vector<WeighedBody> start_;
    std::vector<Real> inv_mass_, impulse_, v_;
    Real pull_;
    long steps_ = 0;
};

/// One of the kernels as an engine of one trial.
template <typename Kernel>
Engine engine(const std::string& name, const std::string& trial, bool steps)
{
    return {name, [trial](const Trial& one) { return one.name == trial; }, [](const Trial&) { return std::string(); },
            [steps](const Trial&) { return steps; },
            [](const Scene& scene, const Setting& setting) {
                const auto kernel = std::make_shared<Kernel>(scene, setting.hertz);
                Run run;
                run.advance = [=](double time) { kernel->advance(time); };
                run.states = [=] { return kernel->states(); };
                run.loads = [=] { return kernel->loads(); };
                return run;
            }};
}

/// A trial of the book under another name; only this of its measures.
TrialMaker renamed(const std::string& name, const std::string& from, std::size_t measure)
{
    return {name, [=](Coarseness) {
                for (const TrialMaker& maker : trial_makers()) {
                    if (maker.name != from) continue;
                    Trial trial = maker.make(Coarseness::quick);
                    trial.name = name;
                    trial.measures = {trial.measures.at(measure)};
                    trial.rests = false;
                    return trial;
                }
                return Trial{};
            }};
}

} // namespace

std::vector<TrialMaker> number_trials()
{
    return {renamed("numbers-orbit", "kepler", 0), renamed("numbers-gas", "discs-0.1", 0),
            renamed("numbers-stack", "stack-10", 1)};
}

std::vector<Engine> number_engines()
{
    return {engine<Orbiting<double>>("doubles", "numbers-orbit", true),
            engine<Orbiting<float>>("floats", "numbers-orbit", true),
            engine<KernelGas<double>>("doubles", "numbers-gas", false),
            engine<KernelGas<float>>("floats", "numbers-gas", false),
            engine<Stack<double>>("doubles", "numbers-stack", true),
            engine<Stack<float>>("floats", "numbers-stack", true)};
}

} // namespace flying::bench
