#include "play/ship.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "play/stage.hpp"

namespace flying {

namespace {

constexpr double k_turn = std::numbers::pi / 18.0; ///< of the arrow at each notch [rad]
constexpr double k_notch = 0.25;                   ///< of thrust
constexpr double k_lasts = 50.0 / 60.0;            ///< fifty frames, as in the original [s]

int first_ship(const Stage& stage)
{
    const World& world = stage.run.world();
    const auto moves = [&](int k) { return k >= 0 && k < world.body_count() && !world.is_static(k); };
    for (int k = 0; k < world.body_count(); ++k) {
        if (moves(k) && world.scene().bodies[static_cast<std::size_t>(k)].name == "spaceship") return k;
    }
    if (moves(stage.hand.selected)) return stage.hand.selected;
    for (int k = 0; k < world.body_count(); ++k) {
        if (moves(k) && std::holds_alternative<Disc>(world.shape(k))) return k;
    }
    for (int k = 0; k < world.body_count(); ++k) {
        if (moves(k)) return k;
    }
    return -1;
}

} // namespace

double full_thrust(const Stage& stage)
{
    return 0.5 * (stage.picture.view.max - stage.picture.view.min).maxCoeff();
}

void steer(Stage& stage, double turn, double thrust)
{
    Ship& ship = stage.ship;
    if (ship.body < 0) ship.body = first_ship(stage);
    if (ship.body < 0) {
        stage.say("No body moves here that could be steered");
        return;
    }
    if (!ship.burns(stage.now)) ship.thrust = 0.0;
    ship.heading = std::remainder(ship.heading - k_turn * turn, 2.0 * std::numbers::pi);
    if (thrust != 0.0) {
        ship.thrust = std::clamp(ship.thrust + k_notch * thrust, -1.0, 1.0);
        ship.burns_until = stage.now + k_lasts;
        stage.run.begin_stroke();
    }
}

void board(Stage& stage, int body)
{
    const World& world = stage.run.world();
    if (body < 0 || body >= world.body_count() || world.is_static(body) || body == stage.ship.body) stage.ship = Ship{};
    else stage.ship = Ship{body};
}

void drive(Stage& stage, double wall, double (*seconds)())
{
    Ship& ship = stage.ship;
    if (stage.clock.is_paused || !ship.burns(stage.now) || stage.hand.grip) return;
    ship.owed += wall;
    if (stage.now < stage.hand.wait_until) return;
    const double started = seconds();
    Scene scene = stage.run.scene_now();
    const double push = std::exchange(ship.owed, 0.0) * stage.clock.speed * ship.thrust * full_thrust(stage);
    scene.bodies[static_cast<std::size_t>(ship.body)].velocity += push * Vec2(std::cos(ship.heading), std::sin(ship.heading));
    stage.change(std::move(scene), "thrust", Crowding::refuse);
    stage.hand.wait_until = stage.now + 3.0 * (seconds() - started);
}

} // namespace flying
