#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "rest/contact_point.hpp"

/// What looks right, and throws heaps into the air.
namespace flying::test {

/// One sweep in which all points look at the same velocities, and then push.
inline void sweep_at_once(std::span<ContactPoint> points, std::span<Mover> movers)
{
    std::vector<double> more;
    for (const ContactPoint& c : points) {
        const double u = normal_speed(c, movers[c.a], movers[c.b]);
        more.push_back(std::max(0.0, c.normal - c.normal_mass * u) - c.normal);
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        points[k].normal += more[k];
        push(points[k], more[k], 0.0, movers[points[k].a], movers[points[k].b]);
    }
}

/// A body of 1 kg over so many points of the floor, all below its centre, which has
/// fallen for a step.  [m/s]
struct OnPoints
{
    std::vector<Mover> movers;
    std::vector<ContactPoint> points;
};

inline OnPoints on_points(int count, double fall)
{
    OnPoints body;
    body.movers = {{}, {0.0, -fall, 0.0, 1.0, 1.0}};
    for (int k = 0; k < count; ++k) {
        ContactPoint c;
        c.b = 1;
        c.n_y = 1.0;
        c.normal_mass = c.tangent_mass = 1.0;
        body.points.push_back(c);
    }
    return body;
}

} // namespace flying::test
