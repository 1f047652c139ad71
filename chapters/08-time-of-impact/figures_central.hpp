#pragma once

#include <string>
#include <vector>

#include "../support/sketch.hpp"
#include "toi/central_flight.hpp"

namespace flying::sketch {

/// A body that falls towards a centre, and for how long each bound on the pull holds.
inline void draw_outlook(const std::string& folder)
{
    Sketch s(folder + "/outlook.svg", 560, 330);
    const double scale = 88.0;
    const auto at = [&](const Vec2& p) { return Vec2(196.0 + scale * p.x(), 166.0 - scale * p.y()); };
    const CentralField field{{0.0, 0.0}, 1.0};
    Flyer flyer;
    flyer.state.position = {3.6, 0.0};
    flyer.state.velocity = {0.0, 0.2};
    flyer.central = &field;
    const CentralPath path(flyer, field);
    std::vector<Vec2> orbit;
    for (double t = 0.0; t < 17.0; t += 0.02) orbit.push_back(at(path.at(t).position));
    s.path(orbit, pale(k_soft, 0.8), 1.8);

    // Circles of half the distance, and the piece of the path over which each is not entered
    const Tone tones[] = {k_blue, k_teal, k_ochre, k_rust};
    double time = 0.0;
    for (const Tone tone : tones) {
        const Vec2 place = path.at(time).position;
        const CentralPath::Outlook outlook = path.outlook(place, time);
        s.disc(at(Vec2::Zero()), outlook.nearest * scale, pale(tone, 0.05), tone, 1.8);
        std::vector<Vec2> piece;
        for (int k = 0; k <= 40; ++k)
            piece.push_back(at(path.at(time + (outlook.until - time) * k / 40.0).position));
        s.path(piece, tone, 4.2);
        s.disc(at(place), 7.0, tone, k_none);
        time = outlook.until;
    }
    s.disc(at(Vec2::Zero()), 5.0, k_ink, k_none);
}

} // namespace flying::sketch
