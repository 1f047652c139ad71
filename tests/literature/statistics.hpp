#pragma once

#include <vector>

#include "literature/disc_gas.hpp"

/// What a gas tells beside its pressure.
namespace flying::gas {

/// Numbers that should be uniform in [0, 1), counted in bins of equal width.
class Bins
{
public:
    explicit Bins(int count) : counts_(static_cast<std::size_t>(count), 0.0) {}
    void add(double number);
    /// Sum of (found - expected)^2 / expected; with n bins, distributed as chi^2 with n - 1 degrees of freedom.
    [[nodiscard]] double chi_square() const;

private:
    std::vector<double> counts_;
    double total_ = 0.0;
};

struct Equipartition
{
    double before = 0.0;     ///< share of the spins in the energy at the start
    Mean share;              ///< after mixing
    double chi_square = 0.0; ///< of the spins against the normal distribution, in twenty bins
};

/// A gas of polygons, sampled so often, three collisions of each body between samples.
[[nodiscard]] Equipartition share_of_spin(const BoxOptions& options, int samples);

struct Cooling
{
    double tau = 0.0;   ///< foreseen from the collision rate: 4 / ((1 - e^2) rate)
    double worst = 0.0; ///< greatest |T (1 + t / tau)^2 - 1|, at twenty moments
    double last = 0.0;  ///< temperature at the end, 1 at the start
};

/// A gas of inelastic discs, mixed elastically first, followed for so many tau. A collision with normal speed g takes
/// (1 - e^2) g^2 / 4 of energy, and g^2 has the mean 4 k T / m over collisions: d(k T)/dt = -(1 - e^2) rate k T / 2.
[[nodiscard]] Cooling cool(const BoxOptions& options, double taus);

} // namespace flying::gas
