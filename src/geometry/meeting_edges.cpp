#include "geometry/meeting_edges.hpp"

#include <algorithm>

#include "math/orientation.hpp"

namespace flying {

namespace {

/// How two edges meet that share no vertex of their ring, and whose boxes overlap.
Meeting meeting_of_strangers(const GivenEdge& e, const GivenEdge& f)
{
    // Neither has both ends of the other on one side
    const int fa = orientation(e.a, e.b, f.a);
    const int fb = orientation(e.a, e.b, f.b);
    if (fa * fb > 0) return Meeting::none;
    const int ea = orientation(f.a, f.b, e.a);
    const int eb = orientation(f.a, f.b, e.b);
    if (ea * eb > 0) return Meeting::none;

    // On one line, edges whose boxes overlap share a point
    return fa * fb < 0 && ea * eb < 0 ? Meeting::cross : Meeting::touch;
}

/// Whether the edge after `e` runs back along it.
Meeting meeting_of_neighbours(const GivenEdge& e, const GivenEdge& next)
{
    if (orientation(e.a, e.b, next.b) != 0) return Meeting::none;
    const bool back = e.a.x() != e.b.x() ? (e.a.x() > e.b.x()) == (next.b.x() > e.b.x())
                                         : (e.a.y() > e.b.y()) == (next.b.y() > e.b.y());
    return back ? Meeting::touch : Meeting::none;
}

Meeting meeting_of(const GivenEdge& e, const GivenEdge& f)
{
    if (e.ring == f.ring && e.to == f.from) return meeting_of_neighbours(e, f);
    if (e.ring == f.ring && f.to == e.from) return meeting_of_neighbours(f, e);
    return meeting_of_strangers(e, f);
}

void note(Partner& partner, std::size_t edge, Meeting meeting)
{
    if (partner.count == 0 || edge < partner.edge) {
        partner.edge = edge;
        partner.meeting = meeting;
    }
    ++partner.count;
}

} // namespace

std::vector<Partner> meeting_edges(const std::vector<GivenEdge>& edges)
{
    // Sort by the left end
    std::vector<std::size_t> order(edges.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    const auto left = [&](std::size_t k) { return std::min(edges[k].a.x(), edges[k].b.x()); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t e, std::size_t f) { return left(e) < left(f); });

    // Sweep to the right, and compare each edge with those that are not yet left behind
    std::vector<Partner> partners(edges.size());
    std::vector<std::size_t> open;
    for (const std::size_t now : order) {
        const GivenEdge& e = edges[now];
        std::size_t kept = 0;
        for (const std::size_t other : open) {
            const GivenEdge& f = edges[other];
            if (std::max(f.a.x(), f.b.x()) < left(now)) continue;
            open[kept++] = other;
            if (std::max(f.a.y(), f.b.y()) < std::min(e.a.y(), e.b.y())) continue;
            if (std::max(e.a.y(), e.b.y()) < std::min(f.a.y(), f.b.y())) continue;
            const Meeting meeting = meeting_of(e, f);
            if (meeting != Meeting::none) note(partners[std::min(now, other)], std::max(now, other), meeting);
        }
        open.resize(kept);
        open.push_back(now);
    }
    return partners;
}

} // namespace flying
