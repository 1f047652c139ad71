#include <algorithm>
#include <array>

#include "vertex_edge.hpp"
#include "live/pieces.hpp"
#include "scenes.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// Which pair (0 crate on a floor, 1 crate in a table, 2 diamond in a frame), place x, y and angle of the second body ->
/// number of vertices of the first, their x, y; the same of the second about its centre; then of each contact: point x,
/// y, normal x, y, separation.
Answer entered(std::span<const double> of)
{
    const int which = static_cast<int>(std::clamp(of[0], 0.0, 2.0));
    const Polygon still = which == 0 ? corner::box(10.0, 1.0) : which == 1 ? corner::table() : corner::frame();
    const Polygon held = which == 2 ? corner::diamond() : corner::box(2.0, 1.0);
    Answer answer;
    for (const Polygon* polygon : {&still, &held}) {
        const auto starts = polygon->ring_starts();
        answer.engine.push_back(static_cast<double>(starts.size() - 1));
        for (std::size_t ring = 0; ring + 1 < starts.size(); ++ring) {
            answer.engine.push_back(starts[ring + 1] - starts[ring]);
            for (int k = starts[ring]; k < starts[ring + 1]; ++k) {
                const Vec2 vertex = polygon->vertices()[static_cast<std::size_t>(k)];
                answer.engine.insert(answer.engine.end(), {vertex.x(), vertex.y()});
            }
        }
    }
    for (const Contact& contact : entered_contacts(still, Pose(), held, corner::at(of[1], of[2], of[3])))
        answer.engine.insert(answer.engine.end(), {contact.point.x(), contact.point.y(), contact.normal.x(),
                                                   contact.normal.y(), contact.separation});
    return answer;
}

constexpr std::array k_pieces{Piece{"entered", 4, entered}};

} // namespace

std::span<const Piece> pieces_of_corners() { return k_pieces; }

} // namespace flying::live
