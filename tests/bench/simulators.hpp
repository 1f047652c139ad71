#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "motion/body.hpp"
#include "precision/trial.hpp"
#include "world/world.hpp"

/// The same scene in three engines, each behind the same four functions.
namespace flying::bench {

/// This project's engine.
class Exact
{
public:
    /// scene  valid
    explicit Exact(const Scene& scene);
    void advance(double time);
    [[nodiscard]] std::vector<BodyState> states() const;
    [[nodiscard]] long collisions() const { return world_.collisions(); }
    [[nodiscard]] std::optional<std::string> failure() const { return failure_; }

private:
    World world_;
    std::optional<std::string> failure_;
};

/// Chipmunk 7: 10 iterations a step as it comes, no damping, no sleep. Walls are a metre thick and more. The pull of a centre,
/// which it doesn't know, takes gravity's place as in its own demonstration of planets.
class Chipmunk
{
public:
    /// effort  iterations, as a multiple of 10
    Chipmunk(const Scene& scene, double hertz, int effort = 1);
    Chipmunk(Chipmunk&&) noexcept;
    Chipmunk& operator=(Chipmunk&&) noexcept;
    ~Chipmunk();
    void advance(double time);
    [[nodiscard]] std::vector<BodyState> states() const;
    [[nodiscard]] std::vector<Load> loads() const; ///< of the last step, between bodies and between bodies and walls
    [[nodiscard]] long collisions() const { return 0; }
    [[nodiscard]] std::optional<std::string> failure() const { return std::nullopt; }

    struct Parts;

private:
    std::unique_ptr<Parts> parts_;
};

/// Box2D 2.4: 8 iterations for velocities and 3 for places, no damping, no sleep; every fixture's restitution threshold
/// is 0 m/s (as it comes: 1 m/s). Its numbers are floats. The pull of a centre is applied as a force before each step.
class Box2d
{
public:
    /// effort  iterations, as a multiple of 8 and 3
    Box2d(const Scene& scene, double hertz, int effort = 1);
    Box2d(Box2d&&) noexcept;
    Box2d& operator=(Box2d&&) noexcept;
    ~Box2d();
    void advance(double time);
    [[nodiscard]] std::vector<BodyState> states() const;
    [[nodiscard]] std::vector<Load> loads() const; ///< of the last step, between bodies and between bodies and walls
    [[nodiscard]] long collisions() const { return 0; }
    [[nodiscard]] std::optional<std::string> failure() const { return std::nullopt; }

    struct Parts;

private:
    std::unique_ptr<Parts> parts_;
};

using Simulator = std::variant<Exact, Chipmunk, Box2d>;

/// Which engine, and how often it steps where it steps.
struct EngineChoice
{
    enum class Kind
    {
        exact,
        chipmunk,
        box2d
    };
    Kind kind = Kind::exact;
    double hertz = 0.0; ///< of the peers [1/s]
};

[[nodiscard]] std::string name_of(EngineChoice::Kind kind);
[[nodiscard]] Simulator make_simulator(const EngineChoice& choice, const Scene& scene);

void advance(Simulator& simulator, double time);
[[nodiscard]] std::vector<BodyState> states_of(const Simulator& simulator);
[[nodiscard]] long collisions_of(const Simulator& simulator);
[[nodiscard]] std::optional<std::string> failure_of(const Simulator& simulator);

/// The number of steps that bring a clock of steps nearest to `time`.
[[nodiscard]] long steps_until(double time, double hertz);

/// How thick the peers' walls are made.  [m]
inline constexpr double k_wall = 4.0;

} // namespace flying::bench
