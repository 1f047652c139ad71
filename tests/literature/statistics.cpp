#include "literature/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "literature/equation_of_state.hpp"

namespace flying::gas {

void Bins::add(double number)
{
    const auto bins = static_cast<double>(counts_.size());
    counts_[static_cast<std::size_t>(std::clamp(std::floor(number * bins), 0.0, bins - 1.0))] += 1.0;
    total_ += 1.0;
}

double Bins::chi_square() const
{
    const double expected = total_ / static_cast<double>(counts_.size());
    double sum = 0.0;
    for (const double count : counts_) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

Equipartition share_of_spin(const BoxOptions& options, int samples)
{
    constexpr int k_bins = 20;
    constexpr int k_blocks = 20;
    Gas gas = make_gas(options);
    const double moment = 1.0 / gas.engine.inertia(0).inv_moment_of_inertia;
    const auto energies = [&](double& turning) {
        turning = 0.0;
        double all = 0.0;
        for (int k = 0; k < gas.count; ++k) {
            const BodyState state = gas.engine.flyer(k).state;
            turning += 0.5 * moment * state.spin * state.spin;
            all += 0.5 * state.velocity.squaredNorm();
        }
        return all + turning;
    };
    Equipartition found;
    double turning = 0.0;
    const double total = energies(turning);
    found.before = turning / total;

    // Three ways to move share a kinetic energy of 1 a body: k T = 2/3
    const double width = std::sqrt(2.0 / 3.0 / moment);
    Bins bins(k_bins);
    std::vector<double> blocks;
    mix(gas, 20.0);
    for (int block = 0; block < k_blocks; ++block) {
        double sum = 0.0;
        const int count = std::max(samples / k_blocks, 1);
        for (int k = 0; k < count; ++k) {
            mix(gas, 3.0);
            (void)energies(turning);
            sum += turning / total;
            for (int body = 0; body < gas.count; ++body)
                bins.add(0.5 * std::erfc(-gas.engine.flyer(body).state.spin / width * std::sqrt(0.5)));
        }
        blocks.push_back(sum / count);
    }
    found.share = mean_of(blocks);
    found.chi_square = bins.chi_square();
    return found;
}

Cooling cool(const BoxOptions& options, double taus)
{
    constexpr int k_moments = 20;
    BoxOptions elastic = options;
    elastic.restitution = 1.0;
    Gas mixed = make_gas(elastic);
    mix(mixed, 20.0);

    // The same bodies, which from now on lose
    std::vector<EventBody> bodies;
    for (int k = 0; k < mixed.engine.body_count(); ++k) {
        const bool is_wall = k >= mixed.count;
        Flyer flyer = mixed.engine.flyer(k);
        if (!is_wall) flyer.state = state_at(flyer, mixed.engine.time());
        flyer.state.time = 0.0;
        const double e = is_wall ? 1.0 : options.restitution;
        bodies.push_back({mixed.engine.shape(k), flyer, mixed.engine.inertia(k), {e, 0.0}, is_wall});
    }
    EventEngine engine(std::move(bodies), {});
    const auto temperature = [&] {
        double sum = 0.0;
        for (int k = 0; k < mixed.count; ++k) sum += 0.5 * engine.flyer(k).state.velocity.squaredNorm();
        return sum / mixed.count;
    };

    Cooling found;
    const double e = options.restitution;
    found.tau = 4.0 / ((1.0 - e * e) * collision_rate(series(options.packing)));
    for (int k = 1; k <= k_moments; ++k) {
        const double time = taus * found.tau * k / k_moments;
        if (engine.advance(time, -1)) return {found.tau, 1.0, 0.0};
        const double expected = std::pow(1.0 + time / found.tau, -2.0);
        found.last = temperature();
        found.worst = std::max(found.worst, std::abs(found.last / expected - 1.0));
    }
    return found;
}

} // namespace flying::gas
