#include "response/several_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace flying {

namespace {

bool share_normal(const PointFrame& a, const PointFrame& b)
{
    const double sine = cross(a.normal.direction, b.normal.direction);
    const double cosine = a.normal.direction.dot(b.normal.direction);
    return cosine > 0.0 && std::abs(sine) <= tolerance::k_same_normal;
}

// Place along the tangent of `first`, from A's centre: r.t is -(r x n)
double place(const PointFrame& point)
{
    return -point.normal.arm_a;
}

} // namespace

std::vector<int> outermost(std::span<const PointFrame> points, std::span<const int> chosen)
{
    std::vector<int> kept;
    for (const int i : chosen) {
        // Find the ends of the row of points that share this normal; of points in one place the first counts
        int low = i;
        int high = i;
        int first = i;
        for (const int k : chosen) {
            if (!share_normal(points[i], points[k])) continue;
            if (place(points[k]) < place(points[low]) || (place(points[k]) == place(points[low]) && k < low)) low = k;
            if (place(points[k]) > place(points[high]) || (place(points[k]) == place(points[high]) && k < high))
                high = k;
            first = std::min(first, k);
        }
        const double reach = std::abs(place(points[i])) + std::abs(points[i].tangent.arm_a);
        const bool is_one = place(points[high]) - place(points[low]) <= tolerance::k_touch * reach;
        if (is_one ? i == first : i == low || i == high) kept.push_back(i);
    }
    return kept;
}

namespace {

// One edge of a point's friction cone: the normal and, against the slip along +t or -t, a share of the tangent
struct Edge
{
    PushLine line;
    int point;
    double lean; // q = lean * j: -mu, 0 or mu
};

std::vector<Edge> cone_edges(std::span<const PointFrame> points, double mu)
{
    std::vector<Edge> edges;
    edges.reserve(2 * points.size());
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        for (const double lean : {-mu, mu}) {
            const PushLine& n = points[i].normal;
            const PushLine& t = points[i].tangent;
            edges.push_back(
                {{n.direction + lean * t.direction, n.arm_a + lean * t.arm_a, n.arm_b + lean * t.arm_b}, i, lean});
            if (mu == 0.0) break;
        }
    }
    return edges;
}

using Three = std::array<double, 3>;
using Square = std::array<Three, 3>;

// x of A x = b for one, two or three unknowns, by Cramer's rule: swapping two unknowns swaps them in the answer, to the
// bit where there are two. Not finite where A is singular
Three solve(const Square& a, const Three& b, int size)
{
    if (size == 1) return {b[0] / a[0][0], 0.0, 0.0};
    if (size == 2) {
        const double det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        const double x = b[0] * a[1][1] - b[1] * a[0][1];
        const double y = b[1] * a[0][0] - b[0] * a[1][0];
        return {x / det, y / det, 0.0};
    }
    const auto determinant = [](const Square& m) {
        const double first = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]);
        const double second = m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]);
        const double third = m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
        return (first - second) + third;
    };
    const double det = determinant(a);
    Three x{};
    for (int column = 0; column < 3; ++column) {
        Square replaced = a;
        for (int row = 0; row < 3; ++row) replaced[row][column] = b[row];
        x[column] = determinant(replaced) / det;
    }
    return x;
}

// Up to three edges that may carry the whole compression
struct Trial
{
    std::array<int, 3> edge{0, 1, 2};
    int size = 0;
};

// The choice of as many edges that comes next in order; false after the last one
bool go_to_next(Trial& trial, int edges)
{
    int i = trial.size - 1;
    while (i >= 0 && trial.edge[i] == edges - (trial.size - i)) --i;
    if (i < 0) return false;
    ++trial.edge[i];
    for (int k = i + 1; k < trial.size; ++k) trial.edge[k] = trial.edge[k - 1] + 1;
    return true;
}

// What a trial came to
struct Outcome
{
    Trial trial;
    Three amount{};        // impulse along each edge [N s]
    double work = 0.0;     // of all impulses, negative [J]
    bool possible = false; // pushes only, ends every approach, friction against slip
};

// The speeds that a trial brings to zero: the normal one of each point, and the tangential one where both edges of a
// point are in use, which is to stick
std::array<const PushLine*, 3> stopped_lines(const Trial& trial, std::span<const Edge> edges,
                                             std::span<const PointFrame> points)
{
    std::array<const PushLine*, 3> lines{};
    for (int i = 0; i < trial.size; ++i) {
        const int point = edges[trial.edge[i]].point;
        const bool second = i > 0 && edges[trial.edge[i - 1]].point == point;
        lines[i] = second ? &points[point].tangent : &points[point].normal;
    }
    return lines;
}

PairMotion motion_after(const Trial& trial, const Three& amount, std::span<const Edge> edges, const PairMotion& motion,
                        const PairInertia& inertia)
{
    PairPush push;
    for (int i = 0; i < trial.size; ++i) push.add(edges[trial.edge[i]].line, amount[i]);
    return pushed(motion, push, inertia);
}

Outcome try_edges(const Trial& trial, std::span<const Edge> edges, std::span<const PointFrame> points,
                  const PairMotion& motion, const PairInertia& inertia, double rounding)
{
    // Find the amounts that stop the chosen lines
    const std::array<const PushLine*, 3> lines = stopped_lines(trial, edges, points);
    Square response{};
    Three speed{};
    for (int i = 0; i < trial.size; ++i) {
        speed[i] = -speed_along(*lines[i], motion);
        for (int k = 0; k < trial.size; ++k) response[i][k] = coupling(*lines[i], edges[trial.edge[k]].line, inertia);
    }
    Outcome outcome{trial};
    outcome.amount = solve(response, speed, trial.size);

    // Take off the rounding of the first answer by a second one
    const PairMotion nearly = motion_after(trial, outcome.amount, edges, motion, inertia);
    Three left{};
    for (int i = 0; i < trial.size; ++i) left[i] = -speed_along(*lines[i], nearly);
    const Three more = solve(response, left, trial.size);
    for (int i = 0; i < trial.size; ++i) outcome.amount[i] += more[i];

    // Contact pushes only
    for (int i = 0; i < trial.size; ++i)
        if (!(outcome.amount[i] >= 0.0)) return outcome;

    // No point may be left approaching, and friction along an edge must be against the slip that is left
    const PairMotion after = motion_after(trial, outcome.amount, edges, motion, inertia);
    for (const PointFrame& point : points)
        if (!(speed_along(point.normal, after) >= -rounding)) return outcome;
    for (int i = 0; i < trial.size; ++i) {
        const Edge& edge = edges[trial.edge[i]];
        const PointFrame& point = points[edge.point];
        if (!(std::abs(speed_along(*lines[i], after)) <= rounding)) return outcome;
        const bool both = (i > 0 && edges[trial.edge[i - 1]].point == edge.point) ||
                          (i + 1 < trial.size && edges[trial.edge[i + 1]].point == edge.point);
        if (!both && edge.lean * speed_along(point.tangent, after) > std::abs(edge.lean) * rounding) return outcome;
    }

    // Impulse times the mean of the speeds before and after is work
    for (int i = 0; i < trial.size; ++i) {
        const PushLine& line = edges[trial.edge[i]].line;
        outcome.work += 0.5 * (outcome.amount[i] * (speed_along(line, motion) + speed_along(line, after)));
    }
    outcome.possible = true;
    return outcome;
}

// Impulses at each point
struct Impulses
{
    std::vector<double> normal;  // [N s]
    std::vector<double> tangent; // [N s]
    bool found = false;
};

// The impulses that end the approach; none where no trial succeeds.
//
// The motion of one body relative to another has three dimensions, so three edges of the friction cones span every push
// that all of them together can give. Where several choices do equally well, their mean is as good and takes no
// point before another
Impulses compression(std::span<const PointFrame> points, const PairMotion& motion, const PairInertia& inertia,
                     double mu, double rounding)
{
    const std::vector<Edge> edges = cone_edges(points, mu);
    Impulses sum{std::vector<double>(points.size(), 0.0), std::vector<double>(points.size(), 0.0), false};
    const int edge_count = static_cast<int>(edges.size());
    std::vector<Outcome> possible;
    for (int size = 1; size <= std::min(3, edge_count); ++size) {
        // Find the most work that any choice of this size does against the approach
        possible.clear();
        double least_work = 0.0;
        Trial trial;
        trial.size = size;
        do {
            const Outcome outcome = try_edges(trial, edges, points, motion, inertia, rounding);
            if (!outcome.possible) continue;
            possible.push_back(outcome);
            least_work = std::min(least_work, outcome.work);
        } while (go_to_next(trial, edge_count));

        // Take the mean of those that do as much
        double count = 0.0;
        for (const Outcome& outcome : possible) {
            if (outcome.work > (1.0 - tolerance::k_same_work) * least_work) continue;
            count += 1.0;
            for (int k = 0; k < size; ++k) {
                const Edge& edge = edges[outcome.trial.edge[k]];
                sum.normal[edge.point] += outcome.amount[k];
                sum.tangent[edge.point] += edge.lean * outcome.amount[k];
            }
        }
        if (count == 0.0) continue;
        for (double& j : sum.normal) j /= count;
        for (double& q : sum.tangent) q /= count;
        sum.found = true;
        break;
    }
    return sum;
}

// Where rounding lets no choice of three succeed, push the points in turn, without friction, half of what each
// asks for: slower, safe, and the next round goes on from there
Impulses cautious_push(std::span<const PointFrame> points, const PairMotion& motion, const PairInertia& inertia)
{
    const double share = 1.0 / static_cast<double>(points.size());
    Impulses impulses{{}, std::vector<double>(points.size(), 0.0), false};
    for (const PointFrame& point : points) {
        const double v_n = speed_along(point.normal, motion);
        const double w_n = inverse_mass(point.normal, inertia);
        impulses.normal.push_back(v_n < 0.0 && w_n > 0.0 ? -share * v_n / w_n : 0.0);
    }
    return impulses;
}

} // namespace

PairPush push_at_several(std::span<const PointFrame> points, const PairMotion& motion, const PairInertia& inertia,
                         const Material& material, double speed, Rebound rebound)
{
    // Find the impulses of compression: with friction, else without it
    const double rounding = tolerance::k_approach * speed;
    Impulses p = compression(points, motion, inertia, material.friction, rounding);
    if (!p.found && material.friction > 0.0) p = compression(points, motion, inertia, 0.0, rounding);
    const bool rebounds = p.found && rebound == Rebound::by_restitution;

    // Normals that nearly oppose each other ask for large impulses, and these leave more rounding: allow it, without
    // rebound. The next round takes it off
    for (double allowed = 0x1p10; !p.found && allowed <= 0x1p30; allowed *= 0x1p10)
        p = compression(points, motion, inertia, 0.0, allowed * rounding);
    if (!p.found) p = cautious_push(points, motion, inertia);

    // Give back along the normals
    const double gain = rebounds ? 1.0 + material.restitution : 1.0;
    PairPush push;
    for (std::size_t i = 0; i < points.size(); ++i) push.add(points[i].normal, gain * p.normal[i]);

    // Find the part of the friction that loses most energy: less stops less, more would turn the slip round
    const PairMotion smooth = pushed(motion, push, inertia);
    double work = 0.0;
    PairPush rough;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double q = gain * p.tangent[i];
        work += q * speed_along(points[i].tangent, smooth);
        rough.add(points[i].tangent, q);
    }
    if (!(work < 0.0)) return push;
    const double stiffness = inertia.inv_mass() * rough.impulse.dot(rough.impulse) +
                             (inertia.a.inv_moment_of_inertia * (rough.moment_a * rough.moment_a) +
                              inertia.b.inv_moment_of_inertia * (rough.moment_b * rough.moment_b));
    const double part = std::min(1.0, -work / stiffness);
    push.impulse += part * rough.impulse;
    push.moment_a += part * rough.moment_a;
    push.moment_b += part * rough.moment_b;
    return push;
}

} // namespace flying
