#include <algorithm>
#include <array>

#include "counts.hpp"
#include "crowd.hpp"
#include "live/pieces.hpp"

// What this chapter's page computes.

namespace flying::live {

namespace {

/// radius of the discs, number of the one that asks, then x, y of each -> side of a cell; how many pairs overlap by their
/// boxes, how many the plain way compares, the sweep, the grid; column and row of each disc; then the numbers of those
/// that the asking one looks at.
Answer cells(std::span<const double> of)
{
    const double radius = of[0];
    const int asking = static_cast<int>(of[1]);
    std::vector<BoxedBody> bodies;
    for (std::size_t k = 2; k + 1 < of.size(); k += 2) {
        const Vec2 x(of[k], of[k + 1]);
        const Vec2 reach(radius, radius);
        bodies.push_back({static_cast<int>(bodies.size()), false, {x - reach, x + reach}});
    }
    const int n = static_cast<int>(bodies.size());
    const Counts counts = count(bodies, radius);
    const Grid grid = filled_grid(bodies, radius);
    Answer answer{{grid.cell_size(), static_cast<double>(counts.overlapping), static_cast<double>(counts.all),
                   static_cast<double>(counts.sweep), static_cast<double>(counts.grid)},
                  {}};
    for (int k = 0; k < n; ++k) {
        const Cell& cell = grid.cell_of(k);
        answer.engine.insert(answer.engine.end(), {static_cast<double>(cell.column), static_cast<double>(cell.row)});
    }
    if (asking < 0 || asking >= n) return answer;
    grid.for_each_near(grid.cell_of(asking), [&](int other) {
        if (other != asking) answer.engine.push_back(other);
    });
    return answer;
}

/// discs, greatest speed, seconds -> for each step of 1/60 s: x, y of each disc where pairs are found by position, then
/// where they are found by velocity.
Answer rooms(std::span<const double> of)
{
    const int count = static_cast<int>(std::clamp(of[0], 1.0, 25.0));
    const int frames = static_cast<int>(std::clamp(60.0 * of[2], 1.0, 1800.0));
    Random random(97);
    Crowd left;
    for (int k = 0; k < count; ++k) {
        left.position.push_back(Vec2(1.3 + 2.3 * (k % 5), 1.3 + 2.3 * (k / 5)));
        left.velocity.push_back(of[1] * Vec2{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
    }
    Crowd right = left;
    Answer answer;
    for (int frame = 0; frame <= frames; ++frame) {
        for (const Crowd* crowd : {&left, &right})
            for (const Vec2& x : crowd->position) answer.engine.insert(answer.engine.end(), {x.x(), x.y()});
        for (int half = 0; half < 2; ++half) {
            left.step(Index::position, 1.0 / 120.0);
            right.step(Index::velocity, 1.0 / 120.0);
        }
    }
    return answer;
}

constexpr std::array k_pieces{Piece{"cells", 4, cells}, Piece{"rooms", 3, rooms}};

} // namespace

std::span<const Piece> pieces_of_pairs() { return k_pieces; }

} // namespace flying::live
