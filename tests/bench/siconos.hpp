#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "motion/body.hpp"
#include "precision/trial.hpp"

namespace flying::bench {

/// Siconos 4: Moreau-Jean time stepping as the textbook has it. Each step poses one problem, with Newton's law of
/// impact and Coulomb's of friction at all active contacts, which a solver of its own solves. It has no collision of
/// its own in the plane: contact points are those of this engine's `make_manifold`, found anew at the start of each
/// step; from there to the step's end its relations follow them.
class Siconos
{
public:
    enum class Solver
    {
        sweeps, ///< nonsmooth Gauss-Seidel, contact by contact, until nothing changes or a thousand sweeps are over
        lemke   ///< all contacts at once, as a linear complementarity problem, by Lemke's pivots
    };

    /// scene  valid, its field uniform, its shapes discs and convex polygons
    Siconos(const Scene& scene, double hertz, Solver solver);
    Siconos(Siconos&&) noexcept;
    Siconos& operator=(Siconos&&) noexcept;
    ~Siconos();
    void advance(double time);
    [[nodiscard]] std::vector<BodyState> states() const;
    [[nodiscard]] std::vector<Load> loads() const; ///< of the last step, between bodies and between bodies and walls
    [[nodiscard]] std::optional<std::string> failure() const; ///< what it said when it stopped

    struct Parts;

private:
    std::unique_ptr<Parts> parts_;
};

} // namespace flying::bench
