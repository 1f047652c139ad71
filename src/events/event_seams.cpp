#include <algorithm>
#include <utility>

#include "broadphase/box_cells.hpp"
#include "collide/separating_axis.hpp"
#include "events/event_engine.hpp"

namespace flying {


// Where surfaces of static bodies act as one (collide/seams.hpp).

void EventEngine::find_seams_of_statics()
{
    seams_.resize(rows_.size());
    beside_.resize(rows_.size());
    const auto add = [&](int one, int two) {
        const auto* polygon = std::get_if<Polygon>(&shape_of(one));
        if (!polygon) return;
        const bool is_wall = std::holds_alternative<HalfPlane>(shape_of(two));
        const double size = is_wall ? rows_[one].radius : std::min(rows_[one].radius, rows_[two].radius);
        const double reach = rows_[one].position.cwiseAbs().maxCoeff() + rows_[two].position.cwiseAbs().maxCoeff();
        std::vector<Seam>& seams = seams_[rows_[one].id];
        const std::size_t before = seams.size();
        find_seams(*polygon, relative_pose(pose(one), is_wall ? Pose{} : pose(two)), shape_of(two), {},
                   seam_tolerance(size, reach), seams);
        if (seams.size() == before) return;
        for (const auto& [from, to] : {std::pair(one, two), std::pair(two, one)}) {
            std::vector<int>& list = beside_[rows_[from].id];
            if (std::find(list.begin(), list.end(), rows_[to].id) == list.end()) list.push_back(rows_[to].id);
        }
    };
    constexpr double k_room = 0x1p-10; // [radii] about a box, against rounding
    std::vector<BoxCells::Entry> boxes;
    std::vector<int> walls;
    for (int k = 0; k < body_count(); ++k) {
        if (!never_moves(k)) continue;
        if (std::holds_alternative<HalfPlane>(shape_of(k))) {
            walls.push_back(k);
            continue;
        }
        const Aabb box = bounding_box(shape_of(k), pose(k));
        const Vec2 room = Vec2::Constant(k_room * rows_[k].radius);
        boxes.push_back({{box.min - room, box.max + room}, k});
    }
    for (const BoxCells::Entry& entry : boxes) {
        for (const int wall : walls) add(entry.body, wall);
    }
    BoxCells cells;
    cells.sort(std::move(boxes));
    cells.for_each_pair([&](const BoxCells::Entry& one, const BoxCells::Entry& two) {
        add(one.body, two.body);
        add(two.body, one.body);
    });
}



/// All points at which a body touches a static one and what lies beside that: none of them moves, and they are struck as
/// one body.
void EventEngine::touch_surface(int a, int b, double slack)
{
    const bool a_is_static = never_moves(a);
    const int mover = a_is_static ? b : a;
    std::vector<int> surface{a_is_static ? a : b};
    for (std::size_t next = 0; next < surface.size(); ++next) {
        const int part = surface[next];
        const int first = a_is_static ? part : mover;
        const int second = a_is_static ? mover : part;
        if (next > 0) find_touches(shape_of(first), pose(first), shape_of(second), pose(second), slack, touches_);
        if (touches_.empty()) continue;
        mend_touches(first, second);
        // Where the body touches it, impulses act on the one that was struck
        for (Touch& touch : touches_) {
            if (next > 0) (a_is_static ? touch.r_a : touch.r_b) += rows_[part].position - rows_[surface[0]].position;
        }
        add_points();
        for (const int id : beside_[rows_[part].id]) {
            const int row = row_of(id);
            if (std::find(surface.begin(), surface.end(), row) == surface.end()) surface.push_back(row);
        }
    }
}

/// Leaves of the touches with a static body those with its surface.
void EventEngine::mend_touches(int a, int b)
{
    const bool a_is_static = never_moves(a);
    const int fixed = a_is_static ? a : b;
    const auto* polygon = std::get_if<Polygon>(&shape_of(fixed));
    if (!polygon) return;
    const Rotation world_from_fixed = pose(fixed).rotation;
    const double sign = a_is_static ? 1.0 : -1.0;
    std::erase_if(touches_, [&](Touch& touch) {
        const Vec2 here = inverse(world_from_fixed) * (a_is_static ? touch.r_a : touch.r_b);
        const Vec2 normal = inverse(world_from_fixed) * Vec2(sign * touch.normal);
        for (const Seam& seam : seams_[rows_[fixed].id]) {
            if ((here - polygon->vertices()[seam.corner]).squaredNorm() > seam.crack * seam.crack) continue;
            // A corner of its own that a flat side lies on is none; one that a corner stands on has the surface's normal
            const bool of_fixed = touch.feature.kind == (a_is_static ? FeatureKind::vertex_of_a : FeatureKind::vertex_of_b);
            const bool is_disc = !std::holds_alternative<Polygon>(shape_of(a_is_static ? b : a));
            if (of_fixed && !is_disc && seam.bend != Seam::Bend::ridge) return true;
            if (is_of_surface(*polygon, seam, normal)) continue;
            touch.normal = world_from_fixed * Vec2(sign * surface_normal(*polygon, seam));
        }
        return false;
    });
}


} // namespace flying
