#pragma once

#include <optional>
#include <vector>

#include "rest/rest_engine.hpp"
#include "world/scene.hpp"

namespace flying::bench {

/// This project's integrator for lasting contacts, by itself.
class Resting
{
public:
    /// scene  valid
    Resting(const Scene& scene, double hertz, bool sleeps);
    void step();
    [[nodiscard]] std::vector<BodyState> states() const;
    [[nodiscard]] const RestEngine& engine() const { return *engine_; }

private:
    std::size_t count_ = 0;
    std::optional<RestEngine> engine_;
};

} // namespace flying::bench
