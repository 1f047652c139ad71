#pragma once

#include "scene/generate.hpp"

// The generators one by one. Each takes options that `generate` has checked one by one, and tells only of those that
// don't go together.
namespace flying {

[[nodiscard]] Expected<Scene> generate_balls(const GenerateOptions& options);
[[nodiscard]] Expected<Scene> generate_gas(const GenerateOptions& options);
[[nodiscard]] Expected<Scene> generate_polygons(const GenerateOptions& options);
[[nodiscard]] Expected<Scene> generate_pile(const GenerateOptions& options);
[[nodiscard]] Expected<Scene> generate_stack(const GenerateOptions& options);
[[nodiscard]] Expected<Scene> generate_pyramid(const GenerateOptions& options);
[[nodiscard]] Expected<Scene> generate_cradle(const GenerateOptions& options);
[[nodiscard]] Expected<Scene> generate_billiard(const GenerateOptions& options);

/// Title, end, field and materials: the options' where given, else those of `defaults`.
[[nodiscard]] Scene scene_from(const GenerateOptions& options, const Scene& defaults);

/// The field with this gravity; none where it is zero.
[[nodiscard]] Field field_of(const Vec2& gravity);

/// "100 balls", "1 ball".
[[nodiscard]] std::string counted(int count, const std::string& singular, const std::string& plural);

} // namespace flying
