#pragma once

#include <vector>

#include "rest/island.hpp"

namespace flying {

class HeapSweeps;
struct ApproachSpeeds;

/// A gap this small isn't worth a moment of its own, unless it closes fast.  [m]
[[nodiscard]] double hardly_open(const RestData& data, const ContactPoint& c);
/// It approaches so fast that it will be struck where it closes.
[[nodiscard]] bool comes_as_blow(const RestData& data, const Island& island, const ContactPoint& c);
/// The moment of an island's first impact after the beginning, as its contacts foresee it; 0 where there is none.  [s]
[[nodiscard]] double first_impact(const RestData& data, const Island& island);
/// When an impact comes that was not foreseen, since bodies sped up otherwise than they did before: the first moment at
/// which a gap closes on the ways that were found; 0 where none does.  [s]
[[nodiscard]] double missed_impact(const RestData& data, const Island& island);

/// Ends the approaches of an island with which the step, or the part of one, begins.
class Impacts
{
public:
    /// First what is thrown back, then the rest of the approaches, all at once and without rebound;
    /// `data.motion.before` is what they leave. Where impacts have no moments of their own, all that closes within the
    /// step counts as closed; where they have, what closes and hardly is open beside a point of the same two bodies
    /// that bore nothing and is struck, and all that can't be moved is one. True where there were any, and nothing
    /// approaches any more.
    bool strike(RestData& data, Island& island, HeapSweeps& sweeps);

private:
    [[nodiscard]] bool find_closed(const RestData& data, const Island& island, const ApproachSpeeds& speeds,
                                   double within);
    [[nodiscard]] bool any_approaches(std::span<const Mover> velocities) const;
    void end_approaches(RestData& data, Island& island, bool is_whole, HeapSweeps& sweeps);
    void strike_lone_pairs(RestData& data, const Island& island);

    std::vector<ContactPoint> struck_; // what is closed, or closes
    std::vector<ContactPoint> open_;   // what isn't, but may come to close
    std::vector<double> blows_;        // of each of them: the slowest approach that is a blow [m/s]
    std::vector<double> rebounds_;     // the same for one that brings a rebound
};

} // namespace flying
