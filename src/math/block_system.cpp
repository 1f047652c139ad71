#include "math/block_system.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

namespace flying {
namespace {

/// So many bodies are eliminated as they come.
constexpr int k_few = 12;

/// target -= a b, a row at a time: four numbers that the processor handles as one
void subtract_product(Block& target, const Block& a, const Block& b)
{
    for (int i = 0; i < 3; ++i) {
        const double first = a.at[i][0];
        const double second = a.at[i][1];
        const double third = a.at[i][2];
        double row[4];
        for (int j = 0; j < 4; ++j) row[j] = (first * b.at[0][j] + second * b.at[1][j]) + third * b.at[2][j];
        for (int j = 0; j < 4; ++j) target.at[i][j] -= row[j];
    }
}

/// x -= a y
void subtract_product(double* x, const Block& a, const double* y)
{
    const double first = y[0];
    const double second = y[1];
    const double third = y[2];
    for (int i = 0; i < 3; ++i) x[i] -= (a.at[i][0] * first + a.at[i][1] * second) + a.at[i][2] * third;
}

/// x -= a^T y, of four numbers at once, as a row has
void subtract_transposed(double (&x)[4], const Block& a, const double* y)
{
    const double first = y[0];
    const double second = y[1];
    const double third = y[2];
    for (int j = 0; j < 4; ++j) x[j] -= (a.at[0][j] * first + a.at[1][j] * second) + a.at[2][j] * third;
}

/// Replaces a block by its factors: below the diagonal those of the elimination, on and above it what is left, and
/// beside each row one over its pivot. An explicit inverse would lose what rounding leaves of blocks that hold both
/// masses and stiff points.
[[nodiscard]] bool eliminate(Block& m)
{
    auto& at = m.at;
    if (!(std::abs(at[0][0]) > 0.0)) return false;
    at[0][3] = 1.0 / at[0][0];
    at[1][0] *= at[0][3];
    at[2][0] *= at[0][3];
    at[1][1] -= at[1][0] * at[0][1];
    at[1][2] -= at[1][0] * at[0][2];
    at[2][1] -= at[2][0] * at[0][1];
    at[2][2] -= at[2][0] * at[0][2];
    if (!(std::abs(at[1][1]) > 0.0)) return false;
    at[1][3] = 1.0 / at[1][1];
    at[2][1] *= at[1][3];
    at[2][2] -= at[2][1] * at[1][2];
    at[2][3] = 1.0 / at[2][2];
    return std::abs(at[2][2]) > 0.0;
}

/// a := a m^-1, with m eliminated.
void divide_right(Block& a, const Block& m)
{
    const auto& at = m.at;
    for (int i = 0; i < 3; ++i) {
        double* row = a.at[i];
        row[0] *= at[0][3];
        row[1] = (row[1] - row[0] * at[0][1]) * at[1][3];
        row[2] = ((row[2] - row[0] * at[0][2]) - row[1] * at[1][2]) * at[2][3];
        row[1] -= row[2] * at[2][1];
        row[0] = (row[0] - row[1] * at[1][0]) - row[2] * at[2][0];
    }
}

/// x := m^-1 x, with m eliminated.
void divide_left(const Block& m, double* x)
{
    const auto& at = m.at;
    x[1] -= at[1][0] * x[0];
    x[2] = (x[2] - at[2][0] * x[0]) - at[2][1] * x[1];
    x[2] *= at[2][3];
    x[1] = (x[1] - at[1][2] * x[2]) * at[1][3];
    x[0] = ((x[0] - at[0][1] * x[1]) - at[0][2] * x[2]) * at[0][3];
}

} // namespace

void BlockSystem::order(int count, std::span<const Edge> edges)
{
    rank_.resize(count);
    body_.resize(count);

    // A few bodies need no search
    if (count <= k_few) {
        for (int k = 0; k < count; ++k) rank_[k] = body_[k] = k;
        return;
    }

    // Eliminate first what has the fewest neighbours left (approximate minimum degree)
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(2 * edges.size() + count);
    for (int k = 0; k < count; ++k) entries.emplace_back(k, k, 1.0);
    for (const Edge& edge : edges) {
        entries.emplace_back(edge.first, edge.second, 1.0);
        entries.emplace_back(edge.second, edge.first, 1.0);
    }
    Eigen::SparseMatrix<double> pattern(count, count);
    pattern.setFromTriplets(entries.begin(), entries.end());
    Eigen::AMDOrdering<int>::PermutationType permutation;
    Eigen::AMDOrdering<int>()(pattern, permutation);
    for (int k = 0; k < count; ++k) {
        body_[k] = permutation.indices()[k];
        rank_[body_[k]] = k;
    }
}

void BlockSystem::fill_in(int count, std::span<const Edge> edges)
{
    // Start from what touches what
    if (static_cast<int>(columns_.size()) < count) columns_.resize(count);
    for (int k = 0; k < count; ++k) columns_[k].clear();
    for (const Edge& edge : edges) {
        const int low = std::min(rank_[edge.first], rank_[edge.second]);
        const int high = std::max(rank_[edge.first], rank_[edge.second]);
        columns_[low].push_back(high);
    }

    // Eliminating a body couples all its later neighbours: they join the column of the first of them
    start_.assign(1, 0);
    row_.clear();
    for (int k = 0; k < count; ++k) {
        std::vector<int>& column = columns_[k];
        std::sort(column.begin(), column.end());
        column.erase(std::unique(column.begin(), column.end()), column.end());
        row_.insert(row_.end(), column.begin(), column.end());
        start_.push_back(static_cast<int>(row_.size()));
        if (column.size() < 2) continue;
        std::vector<int>& heir = columns_[column.front()];
        heir.insert(heir.end(), column.begin() + 1, column.end());
    }
}

int BlockSystem::find(int column, int row) const
{
    const auto begin = row_.begin() + start_[column];
    return static_cast<int>(std::lower_bound(begin, row_.begin() + start_[column + 1], row) - row_.begin());
}

void BlockSystem::set_pattern(int count, std::span<const Edge> edges)
{
    // Where bodies touch as they did, all stands where it stood
    if (static_cast<std::size_t>(count) == diagonal_.size() &&
        std::equal(edges.begin(), edges.end(), edges_.begin(), edges_.end()))
        return;
    edges_.assign(edges.begin(), edges.end());
    order(count, edges);
    fill_in(count, edges);
    diagonal_.resize(count);
    lower_.resize(row_.size());
    upper_.resize(row_.size());
    work_.resize(3 * static_cast<std::size_t>(count));
    places_.clear();
    for (const Edge& edge : edges) {
        const int first = rank_[edge.first];
        const int second = rank_[edge.second];
        const int entry = find(std::min(first, second), std::max(first, second));
        // Block 2 i couples the later equation to the earlier unknown
        if (first > second) places_.push_back({2 * entry, 2 * entry + 1});
        else places_.push_back({2 * entry + 1, 2 * entry});
    }
}

void BlockSystem::clear()
{
    std::fill(diagonal_.begin(), diagonal_.end(), Block{});
    std::fill(lower_.begin(), lower_.end(), Block{});
    std::fill(upper_.begin(), upper_.end(), Block{});
}

bool BlockSystem::factorise()
{
    const int count = static_cast<int>(diagonal_.size());
    for (int k = 0; k < count; ++k) {
        if (!eliminate(diagonal_[k])) return false;
        for (int i = start_[k]; i < start_[k + 1]; ++i) divide_right(lower_[i], diagonal_[k]);
        for (int i = start_[k]; i < start_[k + 1]; ++i) {
            const int row = row_[i];
            subtract_product(diagonal_[row], lower_[i], upper_[i]);

            // Walk down this column and that of the row together: the first is part of the second
            int target = start_[row];
            for (int j = i + 1; j < start_[k + 1]; ++j) {
                while (row_[target] != row_[j]) ++target;
                subtract_product(upper_[target], lower_[i], upper_[j]);
                subtract_product(lower_[target], lower_[j], upper_[i]);
            }
        }
    }
    return true;
}

double BlockSystem::orientation() const
{
    bool is_negative = false;
    for (const Block& m : diagonal_) {
        for (int i = 0; i < 3; ++i) is_negative = is_negative != (m.at[i][i] < 0.0);
    }
    return is_negative ? -1.0 : 1.0;
}

/// Downwards: take off what those before have found.
void BlockSystem::go_down(std::span<const double> x)
{
    const int count = static_cast<int>(diagonal_.size());
    for (int k = 0; k < count; ++k) {
        for (int i = 0; i < 3; ++i) work_[3 * k + i] = x[3 * body_[k] + i];
    }
    for (int k = 0; k < count; ++k) {
        const double own[3] = {work_[3 * k], work_[3 * k + 1], work_[3 * k + 2]};
        for (int i = start_[k]; i < start_[k + 1]; ++i) subtract_product(&work_[3 * row_[i]], lower_[i], own);
    }
}

void BlockSystem::take_unknowns(std::span<double> x) const
{
    const int count = static_cast<int>(diagonal_.size());
    for (int k = 0; k < count; ++k) {
        for (int i = 0; i < 3; ++i) x[3 * body_[k] + i] = work_[3 * k + i];
    }
}

void BlockSystem::solve(std::span<double> x)
{
    go_down(x);
    // Upwards: take off what those after have found, and divide
    for (int k = static_cast<int>(diagonal_.size()) - 1; k >= 0; --k) {
        for (int i = start_[k]; i < start_[k + 1]; ++i) subtract_product(&work_[3 * k], upper_[i], &work_[3 * row_[i]]);
        divide_left(diagonal_[k], &work_[3 * k]);
    }
    take_unknowns(x);
}

void BlockSystem::solve_symmetric(std::span<double> x)
{
    go_down(x);
    // Upwards: divide, and take off what those after have found. A block above the diagonal is the eliminated one on
    // it times the transpose of the one below
    for (int k = static_cast<int>(diagonal_.size()) - 1; k >= 0; --k) {
        double own[4] = {work_[3 * k], work_[3 * k + 1], work_[3 * k + 2], 0.0};
        divide_left(diagonal_[k], own);
        for (int i = start_[k]; i < start_[k + 1]; ++i) subtract_transposed(own, lower_[i], &work_[3 * row_[i]]);
        std::copy(own, own + 3, &work_[3 * k]);
    }
    take_unknowns(x);
}

} // namespace flying
