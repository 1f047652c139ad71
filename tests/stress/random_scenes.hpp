#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "world/world.hpp"

namespace flying::stress {

/// Kinds of random scenes, in the order in which seeds take turns.
enum class SceneKind { discs, polygons, concave, mixed, crowd, central };
inline constexpr int k_scene_kinds = 6;
[[nodiscard]] const char* name_of(SceneKind kind);
[[nodiscard]] SceneKind kind_of(std::uint64_t seed);

/// A valid scene, the same on every machine but for rounding of the mathematical library: four to sixty bodies of the
/// seed's kind, some of them static, in no field, one that is weak or strong, or round a centre; with restitution, friction
/// and spins, within a box or without one.
[[nodiscard]] Scene random_scene(std::uint64_t seed);

/// A run of a scene as it is after every impact.
struct Trace
{
    struct Moment
    {
        double time = 0.0;
        std::uint64_t log = 0;    ///< of all impacts so far
        std::uint64_t bodies = 0; ///< of all bodies, each at its own last impact

        friend bool operator==(const Moment&, const Moment&) = default;
    };
    std::vector<Moment> moments;
    std::uint64_t end = 0; ///< hash of the report at the end
    bool failed = false;   ///< impacts crowded without end
    bool cut_short = false; ///< too many events: only the impacts so far can be compared
    std::vector<Skip> skips;
};

/// most  impacts to follow. A body caught close to a centre without core goes round it in microseconds: events have a
///       limit too
[[nodiscard]] Trace trace_of(const Scene& scene, const std::vector<std::string>& without, std::size_t most = 2000);

/// Where two runs differ first: in words, or nothing where they don't.
[[nodiscard]] std::string difference(const Trace& a, const Trace& b);

} // namespace flying::stress
