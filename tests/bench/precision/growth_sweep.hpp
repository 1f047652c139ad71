#pragma once

#include <functional>
#include <string>
#include <vector>

#include "14-time-against-error/record.hpp"
#include "trial.hpp"

namespace flying::bench {

/// How time grows with the number of bodies: gas, pile, stack.
[[nodiscard]] std::vector<std::string> growth_names();

/// Seconds of computing against the number of bodies, each engine up to the size at which a run takes longer than
/// allowed; and what its largest run holds in memory at its end.
/// name  one of growth_names();  most  for a peer; ours may take five times as long  [s]
[[nodiscard]] work::GrowthRecord grow(const std::string& name, Coarseness coarseness, double most, int repeats,
                                      const std::function<void(const std::string&)>& tell);

/// One scene file with all of its skips, and without each: time, what was saved, and whether the bits are the same.
/// until  simulated at most [s]
[[nodiscard]] work::SkipsRecord weigh_skips(const std::string& path, double until, int repeats,
                                            const std::function<void(const std::string&)>& tell);

} // namespace flying::bench
