#include "events/meeting.hpp"

#include <algorithm>
#include <cmath>

#include "toi/gap_tolerance.hpp"

namespace flying {
namespace {

void add_points(MeetingPoints& meeting)
{
    for (const Touch& touch : meeting.touches) {
        meeting.points.push_back({touch.r_a, touch.r_b, touch.normal});
        meeting.overlap = std::max(meeting.overlap, -touch.separation);
    }
}

/// Leaves of the touches with a static body those with its surface.
void mend_touches(const BodyRows& bodies, const StaticSurfaces& surfaces, int a, int b, std::vector<Touch>& touches)
{
    const bool a_is_static = bodies.never_moves(a);
    const int fixed = a_is_static ? a : b;
    const auto* polygon = std::get_if<Polygon>(&bodies.shape_of(fixed));
    if (!polygon) return;
    const Rotation world_from_fixed = bodies.pose(fixed).rotation;
    const double sign = a_is_static ? 1.0 : -1.0;
    std::erase_if(touches, [&](Touch& touch) {
        const Vec2 here = inverse(world_from_fixed) * (a_is_static ? touch.r_a : touch.r_b);
        const Vec2 normal = inverse(world_from_fixed) * Vec2(sign * touch.normal);
        for (const Seam& seam : surfaces.seams_of(bodies[fixed].id)) {
            if ((here - polygon->vertices()[seam.corner]).squaredNorm() > seam.crack * seam.crack) continue;
            // A corner of its own that a flat side lies on is none; one that a corner stands on has the surface's
            // normal
            const bool of_fixed =
                touch.feature.kind == (a_is_static ? FeatureKind::vertex_of_a : FeatureKind::vertex_of_b);
            const bool is_disc = !std::holds_alternative<Polygon>(bodies.shape_of(a_is_static ? b : a));
            if (of_fixed && !is_disc && seam.bend != Seam::Bend::ridge) return true;
            if (is_of_surface(*polygon, seam, normal)) continue;
            touch.normal = world_from_fixed * Vec2(sign * surface_normal(*polygon, seam));
        }
        return false;
    });
}

/// All points at which a body touches a static one and what lies beside that: none of them moves, and they are struck
/// as one body.
void touch_surface(const BodyRows& bodies, const StaticSurfaces& surfaces, int a, int b, double slack,
                   MeetingPoints& meeting)
{
    const bool a_is_static = bodies.never_moves(a);
    const int mover = a_is_static ? b : a;
    std::vector<int> surface{a_is_static ? a : b};
    for (std::size_t next = 0; next < surface.size(); ++next) {
        const int part = surface[next];
        const int first = a_is_static ? part : mover;
        const int second = a_is_static ? mover : part;
        if (next > 0) {
            find_touches(bodies.shape_of(first), bodies.pose(first), bodies.shape_of(second), bodies.pose(second),
                         slack, meeting.touches);
        }
        if (meeting.touches.empty()) continue;
        mend_touches(bodies, surfaces, first, second, meeting.touches);
        // Where the body touches it, impulses act on the one that was struck
        for (Touch& touch : meeting.touches) {
            if (next > 0) (a_is_static ? touch.r_a : touch.r_b) += bodies[part].position - bodies[surface[0]].position;
        }
        add_points(meeting);
        for (const int id : surfaces.beside(bodies[part].id)) {
            const int row = bodies.row_of(id);
            if (std::find(surface.begin(), surface.end(), row) == surface.end()) surface.push_back(row);
        }
    }
}

} // namespace

double touch_tolerance(const BodyRows& bodies, int a, int b, double time)
{
    const double radius_a = std::isinf(bodies[a].radius) ? bodies[b].radius : bodies[a].radius;
    const double radius_b = std::isinf(bodies[b].radius) ? bodies[a].radius : bodies[b].radius;
    const double reach = std::max(bodies[a].position.norm(), bodies[b].position.norm());
    return gap_tolerance(std::min(radius_a, radius_b), std::max(radius_a, radius_b), reach,
                         bodies.top_speed(a) + bodies.top_speed(b), time)
        .touch;
}

void find_meeting(const BodyRows& bodies, const StaticSurfaces& surfaces, int a, int b, double time,
                  MeetingPoints& meeting)
{
    Shape disc_a = Disc{};
    Shape disc_b = Disc{};
    const Shape& shape_a = bodies.shape_from_row(a, disc_a);
    const Shape& shape_b = bodies.shape_from_row(b, disc_b);
    const Pose pose_a = bodies.pose(a);
    const Pose pose_b = bodies.pose(b);

    constexpr double k_gather = 16.0; // the depth that a prediction accepts, and rounding on either side of it
    constexpr double k_widen = 16.0;
    constexpr int k_most_tries = 8;
    constexpr double k_flat = 0x1p-20; // [radii] corners that are open by less close with others, as in steps
    meeting.touch = touch_tolerance(bodies, a, b, time);
    double slack = k_gather * meeting.touch;
    // What comes down flat, but for a rounding, and doesn't rebound is stopped at all its corners
    const bool rebounds = combine(bodies.sheet(a).material, bodies.sheet(b).material).restitution > 0.0;
    if (!rebounds) slack = std::max(slack, k_flat * std::min(bodies[a].radius, bodies[b].radius));
    for (int k = 0; k < k_most_tries; ++k, slack *= k_widen) {
        find_touches(shape_a, pose_a, shape_b, pose_b, slack, meeting.touches);
        if (!meeting.touches.empty()) break;
    }

    meeting.points.clear();
    meeting.overlap = 0.0;
    const bool has_seams = !surfaces.seams_of(bodies[a].id).empty() || !surfaces.seams_of(bodies[b].id).empty();
    if (has_seams) touch_surface(bodies, surfaces, a, b, slack, meeting);
    else add_points(meeting);
}

} // namespace flying
