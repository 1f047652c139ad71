#include "events/static_surfaces.hpp"

#include <algorithm>
#include <utility>

#include "broadphase/box_cells.hpp"

namespace flying {

StaticSurfaces::StaticSurfaces(const BodyRows& bodies)
    : seams_(static_cast<std::size_t>(bodies.count())), beside_(static_cast<std::size_t>(bodies.count()))
{
    constexpr double k_room = 0x1p-10; // [radii] about a box, against rounding
    std::vector<BoxCells::Entry> boxes;
    std::vector<int> walls;
    for (int k = 0; k < bodies.count(); ++k) {
        if (!bodies.never_moves(k)) continue;
        if (std::holds_alternative<HalfPlane>(bodies.shape_of(k))) {
            walls.push_back(k);
            continue;
        }
        const Aabb box = bounding_box(bodies.shape_of(k), bodies.pose(k));
        const Vec2 room = Vec2::Constant(k_room * bodies[k].radius);
        boxes.push_back({{box.min - room, box.max + room}, k});
    }
    for (const BoxCells::Entry& entry : boxes) {
        for (const int wall : walls) add(bodies, entry.body, wall);
    }
    BoxCells cells;
    cells.sort(std::move(boxes));
    cells.for_each_pair([&](const BoxCells::Entry& one, const BoxCells::Entry& two) {
        add(bodies, one.body, two.body);
        add(bodies, two.body, one.body);
    });
    name_surfaces();
}

void StaticSurfaces::name_surfaces()
{
    surface_.assign(beside_.size(), -1);
    std::vector<int> found;
    for (int first = 0; first < static_cast<int>(beside_.size()); ++first) {
        if (surface_[first] >= 0) continue;
        found.assign(1, first);
        while (!found.empty()) {
            const int id = found.back();
            found.pop_back();
            surface_[id] = first;
            for (const int other : beside_[id]) {
                if (surface_[other] < 0) found.push_back(other);
            }
        }
    }
}

/// The seams of one body with another, both named by their rows.
void StaticSurfaces::add(const BodyRows& bodies, int one, int two)
{
    const auto* polygon = std::get_if<Polygon>(&bodies.shape_of(one));
    if (!polygon) return;
    const BodyRows::Row& first = bodies[one];
    const BodyRows::Row& second = bodies[two];
    const bool is_wall = std::holds_alternative<HalfPlane>(bodies.shape_of(two));
    const double size = is_wall ? first.radius : std::min(first.radius, second.radius);
    const double reach = first.position.cwiseAbs().maxCoeff() + second.position.cwiseAbs().maxCoeff();
    std::vector<Seam>& seams = seams_[first.id];
    const std::size_t before = seams.size();
    find_seams(*polygon, relative_pose(bodies.pose(one), is_wall ? Pose{} : bodies.pose(two)), bodies.shape_of(two), {},
               seam_tolerance(size, reach), seams);
    if (seams.size() == before) return;
    for (const auto& [from, to] : {std::pair(first.id, second.id), std::pair(second.id, first.id)}) {
        std::vector<int>& list = beside_[from];
        if (std::find(list.begin(), list.end(), to) == list.end()) list.push_back(to);
    }
}

} // namespace flying
