#pragma once

#include <vector>

#include "steppers.hpp"

/// Bodies that pull one another, moved by steps.
namespace flying::steps {

// [many.pull]
struct Puller
{
    Moving motion;
    double mu; ///< how strongly it pulls others: in proportion to its mass [m^3/s^2]
};

/// What all the others do to one of them.   [m/s^2]
[[nodiscard]] inline Vec2 pull_on(std::size_t one, const std::vector<Puller>& bodies)
{
    Vec2 a = Vec2::Zero();
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        if (k == one) continue;
        const Vec2 way = bodies[k].motion.x - bodies[one].motion.x;
        const double r = way.norm();
        a += (bodies[k].mu / (r * r * r)) * way;
    }
    return a;
}
// [many.pull]

// [many.wrong]
/// WRONG: a body later in the list is pulled by bodies that have moved already.
inline void step_in_place(std::vector<Puller>& bodies, double h)
{
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        Moving& b = bodies[k].motion;
        b.v += h * pull_on(k, bodies);
        b.x += h * b.v;
    }
}
// [many.wrong]

// [many.right]
/// First ask all, then move all.
inline void step_together(std::vector<Puller>& bodies, double h)
{
    std::vector<Vec2> pulls;
    for (std::size_t k = 0; k < bodies.size(); ++k) pulls.push_back(pull_on(k, bodies));
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        Moving& b = bodies[k].motion;
        b.v += h * pulls[k];
        b.x += h * b.v;
    }
}
// [many.right]

} // namespace flying::steps
