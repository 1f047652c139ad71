#include "literature/disc_gas.hpp"

#include <cmath>
#include <numbers>

#include "literature/equation_of_state.hpp"
#include "math/random.hpp"

namespace flying::gas {
namespace {

/// Two independent numbers of the normal distribution (Box, Muller 1958).
Vec2 normal_pair(Random& random)
{
    const double u = 1.0 - random.uniform();
    const double turn = 2.0 * std::numbers::pi * random.uniform();
    return std::sqrt(-2.0 * std::log(u)) * Vec2(std::cos(turn), std::sin(turn));
}

EventBody wall(const Vec2& normal, double offset)
{
    return {HalfPlane{normal, offset}, {}, {}, {1.0, 0.0}, true};
}

/// What one block counted in the bulk.
struct Block
{
    long collisions = 0;
    double transfer = 0.0; ///< sum of the normal speeds of the collisions
    double time = 0.0;
    double discs = 0.0; ///< in the bulk, summed over samples
    long samples = 0;
};

bool is_within(const Vec2& point, double low, double high)
{
    return point.x() > low && point.x() < high && point.y() > low && point.y() < high;
}

/// The expected size of one component of a vector that is uniform on a sphere in `dimensions`, over that of the normal
/// distribution with the same mean square. Speeds in a box of fixed energy lie on such a sphere.
double sphere_over_normal(double dimensions)
{
    return std::sqrt(0.5 * dimensions) *
           std::exp(std::lgamma(0.5 * dimensions) - std::lgamma(0.5 * (dimensions + 1.0)));
}

} // namespace

Gas make_gas(const BoxOptions& options)
{
    const int count = options.side * options.side;
    constexpr double k_walls_keep =
        0.5; // walls keep discs off: the box is wider by as much as the runs ask for [diameters]
    constexpr double k_square = 0.7; // side of a square
    const double area = options.squares ? k_square * k_square : 0.25 * std::numbers::pi;
    const double width = std::sqrt(count * area / options.packing) + k_walls_keep;
    const double pitch = width / options.side;
    Random random(options.seed);
    std::vector<EventBody> bodies;
    double energy = 0.0;
    for (int k = 0; k < count; ++k) {
        EventBody body{Disc{0.5}, {}, {1.0, 8.0}, {options.restitution, 0.0}, false};
        if (options.squares) {
            constexpr double h = 0.5 * k_square;
            body.shape = Polygon({{{-h, -h}, {h, -h}, {h, h}, {-h, h}}});
            body.inertia.inv_moment_of_inertia = 6.0 / (k_square * k_square);
            body.flyer.state.angle = random.uniform(-3.0, 3.0);
        }
        const double room = 0.4 * (pitch - 1.0);
        const double x = random.uniform(-room, room);
        const double y = random.uniform(-room, room);
        body.flyer.state.position = {(k % options.side + 0.5) * pitch + x, (k / options.side + 0.5) * pitch + y};
        body.flyer.state.velocity = normal_pair(random);
        if (options.equal_speeds) body.flyer.state.velocity.normalize();
        energy += 0.5 * body.flyer.state.velocity.squaredNorm();
        bodies.push_back(body);
    }
    for (EventBody& body : bodies) body.flyer.state.velocity *= std::sqrt(count / energy);
    bodies.push_back(wall({1.0, 0.0}, 0.0));
    bodies.push_back(wall({-1.0, 0.0}, -width));
    bodies.push_back(wall({0.0, 1.0}, 0.0));
    bodies.push_back(wall({0.0, -1.0}, -width));
    return {EventEngine(std::move(bodies), {}), count, width};
}

void mix(Gas& gas, double collisions_a_body)
{
    const long enough = gas.engine.counts().impacts + static_cast<long>(0.5 * collisions_a_body * gas.count);
    while (gas.engine.counts().impacts < enough) {
        if (gas.engine.advance(gas.engine.time() + 1.0, -1)) return;
    }
}

Mean mean_of(const std::vector<double>& blocks)
{
    const auto count = static_cast<double>(blocks.size());
    double sum = 0.0;
    for (const double block : blocks) sum += block;
    const double mean = sum / count;
    double squares = 0.0;
    for (const double block : blocks) squares += (block - mean) * (block - mean);
    return {mean, std::sqrt(squares / (count * (count - 1.0)))};
}

Figures measure(Gas& gas, double packing, double margin, int blocks, long collisions,
                const std::function<void(int)>& progress)
{
    constexpr double k_sample = 0.25; // between samples of the density: a disc goes a quarter of its size
    EventEngine& engine = gas.engine;
    const double low = margin;
    const double high = gas.width - margin;
    const double area = (high - low) * (high - low);
    std::vector<double> z_virial;
    std::vector<double> z_count;
    std::vector<double> rates;
    Figures figures;
    double packing_sum = 0.0;
    const double shortfall = closed_box_shortfall(packing, gas.count);
    const double sphere = sphere_over_normal(2.0 * gas.count);

    double next_sample = engine.time();
    for (int k = 0; k < blocks; ++k) {
        Block block;
        const double start = next_sample;
        const long enough = engine.counts().impacts + collisions;
        while (engine.counts().impacts < enough) {
            // To the next sample, one event after another
            next_sample += k_sample;
            long impacts = engine.counts().impacts;
            while (engine.time() < next_sample) {
                if (engine.advance(next_sample, 1)) return figures;
                if (engine.counts().impacts == impacts) continue;
                impacts = engine.counts().impacts;
                const Event& impact = engine.last_impacts().back();
                if (impact.b >= gas.count) continue;
                const BodyState a = engine.flyer(impact.a).state;
                const BodyState b = engine.flyer(impact.b).state;
                if (!is_within(0.5 * (a.position + b.position), low, high)) continue;
                ++block.collisions;
                block.transfer += std::abs((b.position - a.position).normalized().dot(b.velocity - a.velocity));
            }
            for (int disc = 0; disc < gas.count; ++disc) {
                const Flyer flyer = engine.flyer(disc);
                const Vec2 position = flyer.state.position + (next_sample - flyer.state.time) * flyer.state.velocity;
                if (is_within(position, low, high)) block.discs += 1.0;
            }
            ++block.samples;
        }
        block.time = next_sample - start;

        // Two discs of mass 1 that meet with normal speed g hand on g, over one diameter
        const double discs = block.discs / static_cast<double>(block.samples);
        const double found = discs / area * 0.25 * std::numbers::pi;
        const double along_slope = series(packing) - series(found);
        const double virial = block.transfer / (2.0 * block.time * discs);
        const double rate = 2.0 * static_cast<double>(block.collisions) / (block.time * discs);
        z_virial.push_back(1.0 + virial + along_slope + shortfall);
        z_count.push_back(1.0 + rate / sphere * 0.25 * std::sqrt(std::numbers::pi) + along_slope + shortfall);
        rates.push_back(rate / collision_rate(1.0 + virial));
        figures.collisions += block.collisions;
        packing_sum += found;
        if (progress) progress(k + 1);
    }
    double energy = 0.0;
    for (int disc = 0; disc < gas.count; ++disc) energy += 0.5 * engine.flyer(disc).state.velocity.squaredNorm();
    figures.energy_change = energy / gas.count - 1.0;
    figures.packing = packing_sum / blocks;
    figures.z_virial = mean_of(z_virial);
    figures.z_count = mean_of(z_count);
    figures.rate = mean_of(rates);
    return figures;
}

} // namespace flying::gas
