// A simulator of bouncing discs that needs nothing but a compiler: g++ -O2 discs.cpp &&
// ./a.out
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace {

// [discs.disc]
struct Disc
{
    double x, y;   // place [m]
    double vx, vy; // velocity [m/s]
    double r;      // radius [m]
    double m;      // mass [kg]
};

constexpr double k_never = std::numeric_limits<double>::infinity();
constexpr double k_width = 10.0; // of a square room, from 0 on [m]
// [discs.disc]

// [discs.when]
/// When two discs touch.
double when_meet(const Disc& a, const Disc& b)
{
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double ux = b.vx - a.vx, uy = b.vy - a.vy;
    const double s = a.r + b.r;
    const double approach = -(dx * ux + dy * uy);
    const double outside = dx * dx + dy * dy - s * s;
    const double discriminant = approach * approach - (ux * ux + uy * uy) * outside;
    if (approach <= 0.0 || discriminant < 0.0) return k_never; // they part, or pass
    return outside / (approach + std::sqrt(discriminant));
}

/// When a disc touches a wall, along one axis.
double when_wall(double x, double v, double r)
{
    if (v > 0.0) return (k_width - r - x) / v;
    return v < 0.0 ? (r - x) / v : k_never;
}
// [discs.when]

// [discs.strike]
/// Exchange the impulse that parts the two as fast as they met.
void strike(Disc& a, Disc& b)
{
    const double distance = std::hypot(b.x - a.x, b.y - a.y);
    const double nx = (b.x - a.x) / distance, ny = (b.y - a.y) / distance;
    const double v_n = (b.vx - a.vx) * nx + (b.vy - a.vy) * ny; // negative: they approach
    const double j = -2.0 * v_n / (1.0 / a.m + 1.0 / b.m);
    a.vx -= j / a.m * nx, a.vy -= j / a.m * ny;
    b.vx += j / b.m * nx, b.vy += j / b.m * ny;
}
// [discs.strike]

double energy(const std::vector<Disc>& discs)
{
    double sum = 0.0;
    for (const Disc& d : discs) sum += 0.5 * d.m * (d.vx * d.vx + d.vy * d.vy);
    return sum;
}

// [discs.run]
/// From impact to impact, until `end`. Returns how many there were.
int run(std::vector<Disc>& discs, double end)
{
    const int n = static_cast<int>(discs.size());
    for (int count = 0;; ++count) {
        // Find the first thing that happens: disc i meets disc k, or a wall along x (k =
        // -1) or y (k = -2)
        double first = end;
        int i = -1, k = -1;
        const auto consider = [&](double time, int a, int b) {
            if (time < first) first = time, i = a, k = b;
        };
        for (int a = 0; a < n; ++a) {
            consider(when_wall(discs[a].x, discs[a].vx, discs[a].r), a, -1);
            consider(when_wall(discs[a].y, discs[a].vy, discs[a].r), a, -2);
            for (int b = a + 1; b < n; ++b) consider(when_meet(discs[a], discs[b]), a, b);
        }

        // Let all fly there, and do it
        for (Disc& d : discs) d.x += first * d.vx, d.y += first * d.vy;
        if (i < 0) return count;
        if (k == -1) discs[i].vx = -discs[i].vx;
        else if (k == -2) discs[i].vy = -discs[i].vy;
        else strike(discs[i], discs[k]);
        end -= first;
    }
}
// [discs.run]

} // namespace

// [discs.main]
int main()
{
    // Nine discs on a lattice, small and large, each with a velocity of its own
    std::vector<Disc> discs;
    for (int k = 0; k < 9; ++k) {
        const double r = 0.3 + 0.05 * k;
        discs.push_back({2.0 + 3.0 * (k % 3), 2.0 + 3.0 * (k / 3), 1.0 - 0.3 * k,
                         0.2 + 0.4 * (k % 4), r, r * r});
    }
    const double before = energy(discs);
    std::printf("  time   impacts     energy over that at the start, less 1\n");
    int impacts = 0;
    for (int t = 10; t <= 100; t += 30) {
        impacts += run(discs, t == 10 ? 10.0 : 30.0);
        std::printf("%4d s %9d %25.0e\n", t, impacts, energy(discs) / before - 1.0);
    }
}
// [discs.main]
