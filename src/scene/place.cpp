#include "scene/place.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace flying {

namespace {

/// [of the distance] Neighbours keep this much apart beyond touching, so that rounding makes no overlap of it.
constexpr double k_clearance = 1e-9;

constexpr int k_tries = 200; ///< for one disc at random

/// Rows of equal circles in a box.
struct Lattice
{
    double diameter = 0.0; ///< of the circles [m]
    bool staggered = false;
};

constexpr double k_row_of_staggered = 0.8660254037844387; ///< distance of staggered rows over the diameter, sqrt(3)/2

/// How many things of one size stand in a length, 0 ... 1e9.
int fits(double length, double size)
{
    if (!(length >= size)) return 0;
    return static_cast<int>(std::min(std::floor(length / size), 1e9));
}

struct Rows
{
    int count = 0;
    int even = 0; ///< circles in rows 0, 2, ...
    int odd = 0;  ///< circles in rows 1, 3, ...
    [[nodiscard]] double places() const
    {
        const int odd_rows = count / 2;
        return static_cast<double>(count - odd_rows) * even + static_cast<double>(odd_rows) * odd;
    }
};

Rows rows_of(const Vec2& size, const Lattice& lattice)
{
    const double d = lattice.diameter;
    Rows rows;
    rows.even = fits(size.x(), d);
    rows.odd = lattice.staggered ? fits(size.x() - 0.5 * d, d) : rows.even;
    const double pitch = lattice.staggered ? k_row_of_staggered * d : d;
    rows.count = size.y() >= d ? 1 + fits(size.y() - d, pitch) : 0;
    return rows;
}

/// The lattice of the widest circles, `narrowest` or wider, that has room for `count` of them.
std::optional<Lattice> widest_lattice(const Vec2& size, int count, double narrowest)
{
    std::optional<Lattice> best;
    for (const bool staggered : {true, false}) {
        const auto has_room = [&](double d) { return rows_of(size, {d, staggered}).places() >= count; };
        if (!has_room(narrowest)) continue;

        // Halve the interval between a diameter that fits and one that can't
        double fitting = narrowest;
        double too_wide = 2.0 * size.minCoeff();
        for (int k = 0; k < 60; ++k) {
            const double middle = 0.5 * (fitting + too_wide);
            (has_room(middle) ? fitting : too_wide) = middle;
        }
        if (!best || fitting > best->diameter) best = Lattice{fitting, staggered};
    }
    return best;
}

/// Centres of the lattice's circles, spread over the whole box.
std::vector<Vec2> lattice_places(const BoxDef& box, const Lattice& lattice)
{
    const Vec2 size = box.max - box.min;
    const double d = lattice.diameter;
    const Rows rows = rows_of(size, lattice);
    const double row_pitch = rows.count > 1 ? (size.y() - d) / (rows.count - 1) : 0.0;

    // Staggered rows of equal length need half a step more
    const double steps =
        lattice.staggered && rows.odd == rows.even && rows.count > 1 ? rows.even - 0.5 : rows.even - 1.0;
    const double pitch = steps > 0.0 ? (size.x() - d) / steps : 0.0;

    std::vector<Vec2> places;
    for (int row = 0; row < rows.count; ++row) {
        const bool odd = row % 2 == 1;
        const double start = odd && lattice.staggered ? 0.5 * pitch : 0.0;
        for (int k = 0; k < (odd ? rows.odd : rows.even); ++k) {
            const double x = box.min.x() + 0.5 * d + start + k * pitch;
            const double y = box.min.y() + 0.5 * d + row * row_pitch;
            places.push_back(Vec2(x, y));
        }
    }
    return places;
}

/// Discs that have their place, by cells of a grid at least as wide as the widest disc.
class PlacedDiscs
{
public:
    PlacedDiscs(const BoxDef& box, double widest, std::size_t count) : corner_(box.min)
    {
        const Vec2 size = box.max - box.min;
        const double fair = std::sqrt(size.x() * size.y() / static_cast<double>(count));
        cell_ = std::max(widest, fair);
        columns_ = std::clamp(fits(size.x(), cell_) + 1, 1, 100000);
        rows_ = std::clamp(fits(size.y(), cell_) + 1, 1, 100000);

        // In a box that is long and thin, one row of cells may be longer than all discs together: widen the cells
        while (static_cast<double>(columns_) * rows_ > 4.0 * static_cast<double>(count) + 64.0) {
            cell_ *= 2.0;
            columns_ = columns_ / 2 + 1;
            rows_ = rows_ / 2 + 1;
        }
        cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    }

    [[nodiscard]] bool is_free(const Vec2& centre, double radius) const
    {
        const int column = column_of(centre.x());
        const int row = row_of(centre.y());
        for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r) {
            for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c) {
                for (const Placed& other : cells_[index_of(c, r)]) {
                    const double apart = (radius + other.radius) * (1.0 + k_clearance);
                    if ((centre - other.centre).squaredNorm() < apart * apart) return false;
                }
            }
        }
        return true;
    }

    void add(const Vec2& centre, double radius)
    {
        cells_[index_of(column_of(centre.x()), row_of(centre.y()))].push_back({centre, radius});
    }

private:
    struct Placed
    {
        Vec2 centre;
        double radius;
    };

    [[nodiscard]] int column_of(double x) const { return std::min(fits(x - corner_.x(), cell_), columns_ - 1); }
    [[nodiscard]] int row_of(double y) const { return std::min(fits(y - corner_.y(), cell_), rows_ - 1); }
    [[nodiscard]] std::size_t index_of(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    Vec2 corner_;
    double cell_ = 1.0;
    int columns_ = 1;
    int rows_ = 1;
    std::vector<std::vector<Placed>> cells_;
};

std::optional<std::vector<Vec2>> place_at_random(Random& random, const BoxDef& box, const std::vector<double>& radii)
{
    // The largest first: the small ones find room between them
    std::vector<std::size_t> order(radii.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return radii[a] > radii[b]; });

    PlacedDiscs placed(box, 2.0 * radii[order.front()] * (1.0 + k_clearance), radii.size());
    std::vector<Vec2> places(radii.size(), Vec2::Zero());
    for (const std::size_t disc : order) {
        const double margin = radii[disc] * (1.0 + k_clearance);
        bool found = false;
        for (int k = 0; k < k_tries && !found; ++k) {
            const double x = random.uniform(box.min.x() + margin, box.max.x() - margin);
            const double y = random.uniform(box.min.y() + margin, box.max.y() - margin);
            places[disc] = Vec2(x, y);
            found = placed.is_free(places[disc], radii[disc]);
        }
        if (!found) return std::nullopt;
        placed.add(places[disc], radii[disc]);
    }
    return places;
}

std::optional<std::vector<Vec2>> place_on_lattice(Random& random, const BoxDef& box, const std::vector<double>& radii)
{
    const double widest = 2.0 * *std::max_element(radii.begin(), radii.end());
    const double narrowest = widest * (1.0 + 4.0 * k_clearance);
    const int count = static_cast<int>(radii.size());
    const std::optional<Lattice> lattice = widest_lattice(box.max - box.min, count, narrowest);
    if (!lattice) return std::nullopt;

    // Draw as many of the places as there are discs
    std::vector<Vec2> places = lattice_places(box, *lattice);
    for (int k = 0; k < count; ++k) {
        const int other = k + random.below(static_cast<int>(places.size()) - k);
        std::swap(places[static_cast<std::size_t>(k)], places[static_cast<std::size_t>(other)]);
    }
    places.resize(radii.size());

    // Shake each disc within the circle that is its own
    for (std::size_t k = 0; k < places.size(); ++k) {
        const double room = 0.5 * (lattice->diameter - 2.0 * radii[k] * (1.0 + 2.0 * k_clearance));
        places[k] += room * random_in_disc(random);
    }
    return places;
}

} // namespace

Vec2 random_in_disc(Random& random)
{
    // A try fails once in 4.7: a hundred in a row will not
    for (int k = 0; k < 100; ++k) {
        const double x = random.uniform(-1.0, 1.0);
        const double y = random.uniform(-1.0, 1.0);
        if (x * x + y * y < 1.0) return Vec2(x, y);
    }
    return Vec2::Zero();
}

Vec2 random_direction(Random& random)
{
    // Points near the middle are left out, where the grid of random numbers shows
    for (int k = 0; k < 100; ++k) {
        const Vec2 point = random_in_disc(random);
        const double length = std::sqrt(point.x() * point.x() + point.y() * point.y());
        if (length > 0x1p-10) return point / length;
    }
    return Vec2(1.0, 0.0);
}

double random_normal(Random& random)
{
    double sum = -6.0;
    for (int k = 0; k < 12; ++k) sum += random.uniform();
    return sum;
}

std::optional<std::vector<Vec2>> place_apart(Random& random, const BoxDef& box, const std::vector<double>& radii)
{
    if (radii.empty()) return std::vector<Vec2>{};

    // Neither way can help a disc that is wider than the box
    const double widest = 2.0 * *std::max_element(radii.begin(), radii.end()) * (1.0 + 2.0 * k_clearance);
    if (!((box.max - box.min).minCoeff() >= widest)) return std::nullopt;

    if (std::optional<std::vector<Vec2>> places = place_at_random(random, box, radii)) return places;
    return place_on_lattice(random, box, radii);
}

} // namespace flying
