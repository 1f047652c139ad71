#pragma once

#include "math/vec2.hpp"

namespace flying {

struct Stage;

/// A body that is steered: scrolling turns its arrow and sets its thrust, which lasts for a while.
struct Ship
{
    int body = -1;            ///< -1 where none is steered
    double heading = 1.5707963267948966; ///< of the arrow [rad]
    double thrust = 0.0;      ///< -1 ... 1, of the full one
    double burns_until = 0.0; ///< on the stage's own clock [s]
    double owed = 0.0;        ///< time of thrust that has not been given yet [s]

    [[nodiscard]] bool burns(double now) const { return body >= 0 && thrust != 0.0 && now < burns_until; }
};

/// Turn the ship's arrow by so many notches, and give it so many notches more thrust. Where there is no ship yet, the body
/// called "spaceship" becomes it, or the one that is chosen, or the first disc that moves, or the first body that does.
void steer(Stage& stage, double turn, double thrust);
/// Steer this body from now on, or none where it is steered already.
void board(Stage& stage, int body);
/// Let the engine work; once a frame.  wall  [s]
void drive(Stage& stage, double wall, double (*seconds)());
/// Acceleration at full thrust: from end to end of what is in sight in two seconds.  [m/s^2]
[[nodiscard]] double full_thrust(const Stage& stage);

} // namespace flying
