#include "collide/seams.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/manifold.hpp"
#include "math/tolerance.hpp"

namespace flying {
namespace {

/// [sine] Surfaces whose directions differ by less go straight on, and a normal that leans over the neighbour by less
/// stands upright: a body that is thrown along it keeps its speed to the square of this.
constexpr double k_lean = 0x1p-26;
/// [sizes] Height of one surface over another that rounding explains, beside that of the coordinates: bodies that lean
/// on each other are held apart to within it.
constexpr double k_step = 0x1p-40;
/// [sizes] Gap between the ends of two surfaces that nothing of that size can sink into: the sine of the lean of a
/// normal on either end is half of it, and stays below `k_lean`.
constexpr double k_crack = 0x1p-26;
/// [sine] Faces whose normals differ by less lie on each other. The joint surface is the longer one of the two: what
/// stands on it stands along its normal.
constexpr double k_parallel = 0x1p-16;
/// [near] What has sunk deeper into a polygon than that share of what counts as near may lie anyhow in a notch, and
/// leaves it by the shortest way. What lies so much deeper below a joint surface than in the polygon is beside both
/// neighbours.
constexpr double k_sunk = 0x1p-5;

/// An edge of the neighbour, or the surface of a half-plane, as the polygon sees it.
struct Surface
{
    Vec2 start = Vec2::Zero();
    Vec2 tangent = Vec2::Zero();
    Vec2 normal = Vec2::Zero();
    double length = std::numeric_limits<double>::infinity(); // [m]
    bool has_start = true;
};

/// Seams of a polygon with one surface of a neighbour.
void add_seams_on(const Polygon& part, const Surface& surface, const SeamTolerance& tolerance, std::vector<Seam>& seams)
{
    for (int v = 0; v < static_cast<int>(part.vertices().size()); ++v) {
        const Vec2 from_start = part.vertices()[v] - surface.start;
        if (!(std::abs(surface.normal.dot(from_start)) <= tolerance.step) || part.is_reflex(v)) continue;
        const double along = surface.tangent.dot(from_start);
        if (surface.has_start && !(along >= -tolerance.crack && along <= surface.length + tolerance.crack)) continue;
        const bool goes_forward = !surface.has_start || along < surface.length - tolerance.crack;
        const bool goes_back = !surface.has_start || along > tolerance.crack;

        // An edge that runs down behind the surface, and looks the way that the surface goes, looks at the neighbour
        const int before = part.previous(v);
        for (const bool is_next : {false, true}) {
            const Edge& edge = part.edges()[is_next ? v : before];
            const Edge& open = part.edges()[is_next ? before : v];
            const Vec2 down = is_next ? edge.tangent : Vec2(-edge.tangent);
            const Vec2 away = is_next ? Vec2(-open.tangent) : open.tangent;
            const double looks = edge.normal.dot(surface.tangent);
            const bool goes_on = looks > k_lean ? goes_forward : looks < -k_lean && goes_back;
            if (!goes_on || !(down.dot(surface.normal) < -k_lean)) continue;
            const Vec2 onwards = looks > 0.0 ? surface.tangent : Vec2(-surface.tangent);
            // The open edge leads away from the neighbour, or up
            if (away.dot(surface.normal) <= k_lean && !(away.dot(onwards) < 0.0)) continue;
            const double rise = away.dot(surface.normal);
            const Seam::Bend bend = rise > k_lean    ? Seam::Bend::hollow
                                    : rise < -k_lean ? Seam::Bend::ridge
                                                     : Seam::Bend::none;
            seams.push_back(
                {v, is_next ? v : before, is_next ? before : v, onwards, surface.normal, tolerance.crack, bend, false});
        }
    }
}

/// The point of a body that is nearest to a corner, as far as a surface with this normal knows.
struct NearestPoint
{
    Vec2 point = Vec2::Zero();
    int vertex = 0;
};

[[nodiscard]] NearestPoint nearest_point(const Shape& body, const Pose& part_from_body, const Vec2& corner,
                                         const Vec2& normal)
{
    NearestPoint nearest;
    if (const auto* disc = std::get_if<Disc>(&body)) {
        nearest.point = part_from_body.position - disc->radius * normal;
        return nearest;
    }
    const Polygon& polygon = std::get<Polygon>(body);
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < static_cast<int>(polygon.vertices().size()); ++v) {
        const Vec2 vertex = part_from_body * polygon.vertices()[v];
        const double square = (vertex - corner).squaredNorm();
        if (square >= least) continue;
        least = square;
        nearest = {vertex, v};
    }
    return nearest;
}

/// The contacts of a polygon with another one along the normal of an edge that goes straight on over neighbours: of
/// what is over none of them.
[[nodiscard]] Manifold along_open_edge(const Polygon& part, const Pose& world_from_part, int edge,
                                       std::span<const Seam> seams, Owner owner, const Polygon& other,
                                       const Pose& world_from_other, double margin)
{
    const Pose part_from_other = relative_pose(world_from_part, world_from_other);
    const Vec2& start = part.vertices()[part.edges()[edge].from];
    Axis lowest{owner, edge, 0, std::numeric_limits<double>::infinity()};
    for (int v = 0; v < static_cast<int>(other.vertices().size()); ++v) {
        const Vec2 place = part_from_other * other.vertices()[v];
        const auto is_over = [&](const Seam& seam) {
            return seam.open == edge && seam.bend == Seam::Bend::none &&
                   (place - part.vertices()[seam.corner]).dot(seam.onwards) > seam.crack;
        };
        const double height = part.edges()[edge].normal.dot(place - start);
        if (height >= lowest.separation || std::any_of(seams.begin(), seams.end(), is_over)) continue;
        lowest.vertex = v;
        lowest.separation = height;
    }
    if (lowest.separation > margin) return {};
    if (owner == Owner::a)
        return make_manifold(part, world_from_part, other, world_from_other, part_from_other, lowest, margin);
    const Pose other_from_part = relative_pose(world_from_other, world_from_part);
    return make_manifold(other, world_from_other, part, world_from_part, other_from_part, lowest, margin);
}

} // namespace

SeamTolerance seam_tolerance(double size, double reach)
{
    const double step = k_step * size + tolerance::coordinate_rounding(reach);
    return {step, step + k_crack * size};
}

void find_seams(const Polygon& part, const Pose& part_from_other, const Shape& other, std::span<const char> real,
                const SeamTolerance& tolerance, std::vector<Seam>& seams)
{
    Surface surface;
    if (const auto* wall = std::get_if<HalfPlane>(&other)) {
        surface.normal = part_from_other.rotation * wall->normal;
        surface.tangent = perp(surface.normal);
        surface.start = part_from_other * Vec2(wall->offset * wall->normal);
        surface.has_start = false;
        add_seams_on(part, surface, tolerance, seams);
        return;
    }
    const auto* polygon = std::get_if<Polygon>(&other);
    if (!polygon) return;
    for (std::size_t k = 0; k < polygon->edges().size(); ++k) {
        if (!real.empty() && !real[k]) continue;
        const Edge& edge = polygon->edges()[k];
        surface.start = part_from_other * polygon->vertices()[edge.from];
        surface.tangent = part_from_other.rotation * edge.tangent;
        surface.normal = part_from_other.rotation * edge.normal;
        surface.length = edge.length;
        add_seams_on(part, surface, tolerance, seams);
    }
}

bool is_of_surface(const Polygon& part, const Seam& seam, const Vec2& normal)
{
    if (!(normal.dot(seam.onwards) > k_lean)) return true;
    const Vec2& open = part.edges()[seam.open].normal;
    return seam.bend == Seam::Bend::hollow && (normal - open).cwiseAbs().maxCoeff() <= k_lean;
}

const Vec2& surface_normal(const Polygon& part, const Seam& seam)
{
    return seam.bend == Seam::Bend::ridge ? seam.outwards : part.edges()[seam.open].normal;
}

void mend_at_seams(const Polygon& part, const Pose& world_from_part, std::span<const Seam> seams, Owner owner,
                   const Shape& other, const Pose& world_from_other, double near, double margin, Manifold& manifold)
{
    const Rotation part_from_world = inverse(world_from_part.rotation);
    const double sign = owner == Owner::a ? 1.0 : -1.0;

    // What lies on the joint surface, or would be struck by a corner that is none, as that surface's normal sees it;
    // neighbours that may part have none that is sharp enough
    const auto place_on_part = [&](const Contact& contact, const Vec2& normal) {
        const Vec2 middle = part_from_world * Vec2(contact.point - world_from_part.position);
        return Vec2(middle - 0.5 * contact.separation * normal);
    };
    if (const auto* polygon = std::get_if<Polygon>(&other); polygon && manifold.count > 0) {
        const Vec2 normal = part_from_world * Vec2(sign * manifold.contacts[0].normal);
        for (const Seam& seam : seams) {
            if (seam.is_loose || seam.bend != Seam::Bend::none) continue;
            const auto is_at_corner = [&](const Contact& contact) {
                const Vec2 way = place_on_part(contact, normal) - part.vertices()[seam.corner];
                return way.squaredNorm() <= seam.crack * seam.crack;
            };
            const double tilt = (part.edges()[seam.open].normal - normal).cwiseAbs().maxCoeff();
            const bool lies_on_it = tilt > 0.0 && tilt <= k_parallel;
            const bool is_struck_by_corner =
                !is_of_surface(part, seam, normal) &&
                std::any_of(manifold.contacts, manifold.contacts + manifold.count, is_at_corner);
            if (!lies_on_it && !is_struck_by_corner) continue;
            manifold =
                along_open_edge(part, world_from_part, seam.open, seams, owner, *polygon, world_from_other, margin);
            break;
        }
    }

    const auto mend = [&](Contact& contact) {
        const Vec2 normal = part_from_world * Vec2(sign * contact.normal);
        const Vec2 here = place_on_part(contact, normal);
        for (const Seam& seam : seams) {
            const Vec2& corner = part.vertices()[seam.corner];
            const double square = (here - corner).squaredNorm();
            const bool is_inside = seam.bend == Seam::Bend::hollow || seam.bend == Seam::Bend::buried;
            if (is_inside && contact.separation < -k_sunk * near) continue;
            if (seam.bend == Seam::Bend::buried) {
                if (square <= near * near) return false;
                continue;
            }
            const bool is_hidden = square <= near * near && !is_of_surface(part, seam, normal);
            const bool is_no_corner =
                square <= seam.crack * seam.crack && seam.bend != Seam::Bend::ridge && !seam.is_loose;
            if (!is_hidden && !is_no_corner) continue;

            const Vec2& instead = surface_normal(part, seam);
            const Pose part_from_other = relative_pose(world_from_part, world_from_other);
            const NearestPoint nearest = nearest_point(other, part_from_other, corner, instead);
            const Vec2 from_corner = nearest.point - corner;
            // Where the inside of an edge lies on the corner, the neighbour that is loose gives way
            const Vec2 there = here + contact.separation * normal;
            if (seam.is_loose && std::holds_alternative<Polygon>(other) &&
                (nearest.point - there).squaredNorm() > near * near)
                continue;
            // What lies below the surface, and not in the polygon, is beside both, not on them
            const double height = instead.dot(from_corner);
            if (height < std::min(contact.separation, 0.0) - k_sunk * near) continue;
            const double over = from_corner.dot(seam.onwards);
            if (over > seam.crack && seam.bend != Seam::Bend::hollow) return false;
            if (over < -seam.crack && seam.bend == Seam::Bend::none && is_no_corner && manifold.count > 1) return false;
            contact.separation = height;
            contact.normal = world_from_part.rotation * Vec2(sign * instead);
            contact.point = world_from_part * Vec2(nearest.point - 0.5 * contact.separation * instead);
            contact.feature = feature_number({owner == Owner::a ? Owner::b : Owner::a, nearest.vertex, seam.open});
            return contact.separation <= margin;
        }
        return true;
    };

    int kept = 0;
    for (int k = 0; k < manifold.count; ++k) {
        Contact contact = manifold.contacts[k];
        const bool is_known = mend(contact) && !(kept == 1 && manifold.contacts[0].feature == contact.feature);
        if (is_known) manifold.contacts[kept++] = contact;
    }
    manifold.count = kept;
}

} // namespace flying
