#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

/// A simulator of bouncing discs that needs nothing but a compiler.
namespace discs {

struct Disc
{
    double x, y;   // place [m]
    double vx, vy; // velocity [m/s]
    double r;      // radius [m]
    double m;      // mass [kg]
};

constexpr double k_never = std::numeric_limits<double>::infinity();

/// When two discs touch, from now on.  [s]
inline double when_meet(const Disc& a, const Disc& b)
{
    const double x = a.x - b.x, y = a.y - b.y;
    const double vx = a.vx - b.vx, vy = a.vy - b.vy;
    const double s = a.r + b.r;
    const double approach = -(x * vx + y * vy);
    if (approach <= 0.0) return k_never; // they part
    const double miss = std::abs(x * vy - y * vx);
    const double span = std::sqrt(vx * vx + vy * vy) * s;
    const double discriminant = (span - miss) * (span + miss);
    if (discriminant < 0.0) return k_never; // they pass
    const double outside = x * x + y * y - s * s;
    return std::max(0.0, outside / (approach + std::sqrt(discriminant)));
}

/// When a disc touches a wall along one axis of a room, which reaches from 0 to `width`.
inline double when_wall(double x, double v, double r, double width)
{
    if (v > 0.0) return std::max(0.0, (width - r - x) / v);
    return v < 0.0 ? std::max(0.0, (r - x) / v) : k_never;
}

/// Push two discs that touch, along the line of their centres.   e  restitution
inline void strike(Disc& a, Disc& b, double e)
{
    const double x = b.x - a.x, y = b.y - a.y;
    const double distance = std::sqrt(x * x + y * y);
    const double nx = x / distance, ny = y / distance;
    const double v_n = (b.vx - a.vx) * nx + (b.vy - a.vy) * ny;
    if (v_n >= 0.0) return; // a contact pushes, and never pulls
    const double j = -(1.0 + e) * v_n / (1.0 / a.m + 1.0 / b.m);
    a.vx -= j / a.m * nx, a.vy -= j / a.m * ny;
    b.vx += j / b.m * nx, b.vy += j / b.m * ny;
}

/// Discs between walls without loss. A room without end has an infinite width.
struct Room
{
    std::vector<Disc> discs;
    double width, height; // from 0 on [m]
    double e = 1.0;       // restitution of disc and disc
};

/// An impact to come: of disc `a` with disc `b`, or with a wall across x or across y.
enum Wall
{
    k_across_x = -1,
    k_across_y = -2
};

struct Impact
{
    double wait; // [s]
    int a, b;
};

/// Of all impacts that there may be, the first.
inline Impact first_impact(const Room& room)
{
    Impact first{k_never, -1, -1};
    const auto consider = [&](double wait, int a, int b) {
        if (wait < first.wait) first = {wait, a, b};
    };
    const int n = static_cast<int>(room.discs.size());
    for (int a = 0; a < n; ++a) {
        const Disc& d = room.discs[a];
        consider(when_wall(d.x, d.vx, d.r, room.width), a, k_across_x);
        consider(when_wall(d.y, d.vy, d.r, room.height), a, k_across_y);
        for (int b = a + 1; b < n; ++b) consider(when_meet(d, room.discs[b]), a, b);
    }
    return first;
}

/// All discs fly for a while.
inline void fly(Room& room, double time)
{
    for (Disc& d : room.discs) d.x += time * d.vx, d.y += time * d.vy;
}

/// What an impact does.
inline void happen(Room& room, const Impact& impact)
{
    Disc& a = room.discs[impact.a];
    if (impact.b == k_across_x) a.vx = -a.vx;
    else if (impact.b == k_across_y) a.vy = -a.vy;
    else strike(a, room.discs[impact.b], room.e);
}

/// From impact to impact, for some time [s]. Returns how many there were.
inline long run(Room& room, double time)
{
    for (long count = 0;; ++count) {
        const Impact next = first_impact(room);
        if (!(next.wait <= time)) {
            fly(room, time);
            return count;
        }
        fly(room, next.wait);
        happen(room, next);
        time -= next.wait;
    }
}

inline double energy(const Room& room)
{
    double sum = 0.0;
    for (const Disc& d : room.discs) sum += 0.5 * d.m * (d.vx * d.vx + d.vy * d.vy);
    return sum;
}

/// Nine discs on a lattice, small and large, each with a velocity of its own.
inline Room nine_discs()
{
    Room room{{}, 10.0, 10.0};
    for (int k = 0; k < 9; ++k) {
        const double r = 0.3 + 0.05 * k;
        room.discs.push_back({2.0 + 3.0 * (k % 3), 2.0 + 3.0 * (k / 3), 1.0 - 0.3 * k,
                              0.2 + 0.4 * (k % 4), r, r * r});
    }
    return room;
}

} // namespace discs
