#pragma once

#include <span>
#include <vector>

namespace flying {

/// A 3 x 3 matrix, row by row; the fourth number of each row is zero.
struct Block
{
    double at[3][4] = {};
};

/// block += factor p q^T
inline void add_product(Block& block, double factor, const double* p, const double* q)
{
    for (int i = 0; i < 3; ++i) {
        const double row = factor * p[i];
        for (int j = 0; j < 3; ++j) block.at[i][j] += row * q[j];
    }
}

/// Six numbers, three for each body of a pair: what the two feel of a push, or what it sees of their motion.
struct PairRow
{
    double a[3];
    double b[3];
};

/// Square systems of equations whose unknowns come in threes, one three for each of some bodies, and whose blocks
/// couple only those bodies that touch. Factorised without pivoting between blocks (the blocks on the diagonal hold the
/// masses and dominate), in an order that keeps the factors sparse.
///
/// Call `set_pattern` once for the bodies, then `clear`, fill `diagonal`, `add`, `factorise`, `solve`.
class BlockSystem
{
public:
    /// count  bodies
    /// edges  pairs of bodies that touch; repeated ones allowed
    struct Edge
    {
        int first = 0;
        int second = 0;
        bool operator==(const Edge&) const = default;
    };
    void set_pattern(int count, std::span<const Edge> edges);

    /// Blocks that a pair of bodies adds to: of the equations of `first` on `second`, and the other way round.
    struct Place
    {
        int first_second = 0; ///< index for `block`
        int second_first = 0; ///< index for `block`
    };
    /// Where edge number k of `set_pattern` stands.
    [[nodiscard]] const Place& place(int edge) const { return places_[edge]; }

    void clear();
    [[nodiscard]] Block& diagonal(int body) { return diagonal_[rank_[body]]; }
    [[nodiscard]] Block& block(int index) { return (index % 2 == 0 ? lower_ : upper_)[index / 2]; }
    /// Adds factor times what a pair feels by what it sees to its four blocks, or to the one that there is.
    /// pair  a body that is no unknown, as one that doesn't move, is below 0
    /// edge  the pair's number among those of `set_pattern`; below 0 where one of the two is no unknown
    void add(const Edge& pair, int edge, double factor, const PairRow& felt, const PairRow& seen);

    /// False where a block on the diagonal is singular.
    [[nodiscard]] bool factorise();

    /// Replaces right-hand sides, three numbers for each body, by the unknowns.
    void solve(std::span<double> x);
    /// The same where each block is the transpose of the one across the diagonal: half of them need not be read.
    void solve_symmetric(std::span<double> x);

    /// Sign of the determinant of what was factorised: 1 or -1.
    [[nodiscard]] double orientation() const;

    /// Blocks beside the diagonal, fill included: the measure of the work.
    [[nodiscard]] std::size_t size() const { return row_.size(); }

private:
    void order(int count, std::span<const Edge> edges);
    void fill_in(int count, std::span<const Edge> edges);
    [[nodiscard]] int find(int column, int row) const;

    void go_down(std::span<const double> x);
    void take_unknowns(std::span<double> x) const;

    // Everything below is in order of elimination. Column k holds rows row_[start_[k]] ... , sorted; block i of
    // `lower_` is (row_[i], k), and that of `upper_` is (k, row_[i])
    std::vector<Edge> edges_;
    std::vector<int> rank_;
    std::vector<int> body_;
    std::vector<int> start_;
    std::vector<int> row_;
    std::vector<Block> diagonal_;
    std::vector<Block> lower_;
    std::vector<Block> upper_;
    std::vector<Place> places_;
    std::vector<double> work_;
    std::vector<std::vector<int>> columns_; // workspace of the symbolic part
};

inline void BlockSystem::add(const Edge& pair, int edge, double factor, const PairRow& felt, const PairRow& seen)
{
    if (pair.first >= 0) add_product(diagonal(pair.first), factor, felt.a, seen.a);
    if (pair.second >= 0) add_product(diagonal(pair.second), factor, felt.b, seen.b);
    if (edge < 0) return;
    add_product(block(places_[edge].first_second), factor, felt.a, seen.b);
    add_product(block(places_[edge].second_first), factor, felt.b, seen.a);
}

} // namespace flying
