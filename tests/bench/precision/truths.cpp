#include "truths.hpp"

#include <algorithm>
#include <cmath>

namespace flying::bench {
namespace {

using Real = long double;

struct Rocking
{
    Real angle;
    Real spin;
};

} // namespace

double bounce_height(double h, double g, double e, double t)
{
    // The first fall is half a hop
    const Real first = std::sqrt(2 * static_cast<Real>(h) / g);
    const Real top_speed = first * g;
    if (t <= first) return static_cast<double>(h - static_cast<Real>(0.5) * g * t * t);
    Real since = t - first;
    Real speed = e * top_speed;
    if (e == 1.0) {
        since -= std::floor(since / (2 * first)) * 2 * first;
    } else {
        if (t >= end_of_bounces(h, g, e)) return 0.0;
        while (speed > 0 && since > 2 * speed / g) {
            since -= 2 * speed / g;
            speed *= e;
        }
    }
    return static_cast<double>(speed * since - static_cast<Real>(0.5) * g * since * since);
}

double end_of_bounces(double h, double g, double e)
{
    return std::sqrt(2.0 * h / g) * (1.0 + e) / (1.0 - e);
}

double folded(double x, double v, double t, double low, double high)
{
    const Real width = static_cast<Real>(high) - low;
    Real way = static_cast<Real>(x) - low + static_cast<Real>(v) * t;
    way -= std::floor(way / (2 * width)) * 2 * width;
    return static_cast<double>(low + (way <= width ? way : 2 * width - way));
}

Struck strike_floor(const Vec2& velocity, double spin, const Vec2& r, double m, double I, double e)
{
    const double approach = velocity.y() + spin * r.x();
    const double impulse = -(1.0 + e) * approach / (1.0 / m + r.x() * r.x() / I);
    return {velocity + Vec2(0.0, impulse / m), spin + r.x() * impulse / I};
}

Struck strike_floor_rough(const Vec2& velocity, double R, double e, double mu)
{
    // A disc: I = m R^2 / 2, so that a push at its rim changes the rim's velocity thrice as much as the centre's
    const double change = -(1.0 + e) * velocity.y();
    const double stops = std::abs(velocity.x()) / 3.0;
    const double along = -std::copysign(std::min(mu * change, stops), velocity.x());
    return {velocity + Vec2(along, change), 2.0 * along / R};
}

double slid(double g, double slope, double mu, double t)
{
    const double a = g * (std::sin(slope) - mu * std::cos(slope));
    return a > 0.0 ? 0.5 * a * t * t : 0.0;
}

Rolled slid_to_roll(double v0, double mu, double g, double R, double t)
{
    const double rolls_from = v0 / (3.0 * mu * g);
    const double slides = std::min(t, rolls_from);
    const double way = v0 * slides - 0.5 * mu * g * slides * slides;
    const double turned = mu * g * slides * slides / R;
    const double rolls = t - slides;
    return {way + 2.0 * v0 / 3.0 * rolls, -(turned + 2.0 * v0 / 3.0 * rolls / R)};
}

Parted parted(double M)
{
    // Velocities towards the wall are negative; the light ball stands between wall and heavy one
    Real heavy = -1;
    Real light = 0;
    Parted result;
    for (;;) {
        if (heavy < light) {
            const Real both = (M * heavy + light) / (static_cast<Real>(M) + 1);
            heavy = 2 * both - heavy;
            light = 2 * both - light;
        } else if (light < 0) {
            light = -light;
        } else {
            break;
        }
        ++result.collisions;
    }
    result.heavy = static_cast<double>(heavy);
    result.light = static_cast<double>(light);
    return result;
}

std::vector<double> row_places(const std::vector<double>& x, const std::vector<double>& v, double R, double low,
                               double high, double t)
{
    // Take the diameters out, and what is left are points between the walls
    std::vector<double> places;
    const auto n = static_cast<double>(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double point = x[k] - R * (2.0 * static_cast<double>(k) + 1.0);
        places.push_back(folded(point, v[k], t, low, high - 2.0 * R * n));
    }
    std::sort(places.begin(), places.end());
    for (std::size_t k = 0; k < x.size(); ++k) places[k] += R * (2.0 * static_cast<double>(k) + 1.0);
    return places;
}

std::vector<double> rocking(double b, double h, double g, double start, const std::vector<double>& times)
{
    const Real alpha = std::atan2(static_cast<Real>(b), static_cast<Real>(h));
    const Real square = 3 * static_cast<Real>(g) / (4 * std::hypot(static_cast<Real>(b), static_cast<Real>(h)));
    const Real sine = std::sin(alpha);
    const Real kept = 1 - static_cast<Real>(1.5) * sine * sine;
    Real side = start > 0 ? 1 : -1; // which corner it stands on
    const auto rate = [&](const Rocking& s) {
        return Rocking{s.spin, -side * square * std::sin(alpha - side * s.angle)};
    };
    const auto step = [&](const Rocking& s, Real d) {
        const auto moved = [&](const Rocking& k, Real f) {
            return Rocking{s.angle + f * k.angle, s.spin + f * k.spin};
        };
        const Rocking k1 = rate(s);
        const Rocking k2 = rate(moved(k1, d / 2));
        const Rocking k3 = rate(moved(k2, d / 2));
        const Rocking k4 = rate(moved(k3, d));
        return Rocking{s.angle + d / 6 * (k1.angle + 2 * k2.angle + 2 * k3.angle + k4.angle),
                       s.spin + d / 6 * (k1.spin + 2 * k2.spin + 2 * k3.spin + k4.spin)};
    };
    constexpr Real k_step = 1e-4L;
    Rocking now{start, 0};
    Real time = 0;
    std::vector<double> angles;
    for (const double until : times) {
        while (time < until) {
            Real d = std::min<Real>(k_step, until - time);
            Rocking next = step(now, d);
            if (side * next.angle < 0) {
                // Halve until the moment at which it stands upright
                Real low = 0;
                Real high = d;
                for (int k = 0; k < 80; ++k) {
                    const Real middle = (low + high) / 2;
                    (side * step(now, middle).angle < 0 ? high : low) = middle;
                }
                d = high;
                next = {0, kept * step(now, d).spin};
                side = -side;
            }
            now = next;
            time += d;
            if (d == 0) break;
        }
        angles.push_back(static_cast<double>(now.angle));
    }
    return angles;
}

} // namespace flying::bench
