#pragma once

#include <vector>

#include "engine.hpp"

/// What double precision costs and buys: small copies of three kernels, each compiled once for floats and once for
/// doubles. They share nothing with the engine, which knows doubles only.
namespace flying::bench {

/// Flights through a field by steps, a gas of discs from impact to impact, and sweeps over the contacts of a stack.
/// Their names begin with "numbers-".
[[nodiscard]] std::vector<TrialMaker> number_trials();

/// For each of those trials one curve with floats and one with doubles. Of the stack, `Setting::hertz` over 60 is the
/// number of sweeps in each of its sixty steps a second.
[[nodiscard]] std::vector<Engine> number_engines();

} // namespace flying::bench
