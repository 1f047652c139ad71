#pragma once

#include <span>

#include "rest/island.hpp"

namespace flying {

/// The acceleration by which the field acts on a body that goes from one place to another, such that its work along the
/// way is just what the potential loses.  [m/s^2]
[[nodiscard]] Vec2 mean_field(const RestData& data, int body, const Vec2& from, const Vec2& to);
/// The field at a place.  [m/s^2]
[[nodiscard]] Vec2 field_at(const RestData& data, int body, const Vec2& place);
/// What the field does on the way of a body's step, for each kilogram.  [J/kg]
[[nodiscard]] double work_of_field(const RestData& data, int body);
/// No less than the field anywhere that the body may get to within so long [s], unless it comes to half its distance
/// from the centre.  [m/s^2]
[[nodiscard]] double greatest_field(const RestData& data, int body, double within);
/// How far a body may get within so long [s] that the field alone acts on, and the room in which points are watched.
/// [m]
[[nodiscard]] double reach_of(const RestData& data, int body, double within);

/// Sets the acceleration for a step, or a part of one, by where the body is expected to get in it.
void aim_field(RestData& data, int body);
/// From now on nothing but the field is expected to act on a body.
void expect_flight(RestData& data, int body, const Vec2& place);
/// Sets the velocities that an island's bodies would have without contacts a time after the start.  [s]
void set_free(RestData& data, const Island& island, std::span<const Mover> start, double time);
/// Bodies that no point holds fly: round a centre by the closed form, as everywhere.
void fly(RestData& data, Island& island);

} // namespace flying
