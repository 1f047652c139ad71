#include "world/make_room.hpp"
#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

TEST_CASE("R and the arrows change the restitution, which stays from 0 to 1")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "r");
    press(stage, "left");
    CHECK(stage.run.scene().world.restitution == doctest::Approx(0.99));
    press(stage, "shift+left");
    CHECK(stage.run.scene().world.restitution == doctest::Approx(0.89));
    for (int k = 0; k < 20; ++k) press(stage, "shift+right");
    CHECK(stage.run.scene().world.restitution == 1.0);
    for (int k = 0; k < 20; ++k) press(stage, "shift+down");
    CHECK(stage.run.scene().world.restitution == 0.0);
}

TEST_CASE("G and the arrows change a uniform field, and the radius and strength of a central one")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "g");
    press(stage, "left");
    press(stage, "up");
    const Vec2 gravity = uniform_acceleration(stage.run.scene().world.field);
    CHECK(gravity.x() == doctest::Approx(-0.1));
    CHECK(gravity.y() == doctest::Approx(-0.9));

    press(stage, "shift+g");
    REQUIRE(std::holds_alternative<CentralField>(stage.run.scene().world.field));
    const CentralField before = std::get<CentralField>(stage.run.scene().world.field);
    press(stage, "up");
    press(stage, "right");
    const CentralField after = std::get<CentralField>(stage.run.scene().world.field);
    CHECK(after.mu == doctest::Approx(1.1 * before.mu));
    CHECK(after.radius == doctest::Approx(before.radius + 0.1));
    press(stage, "shift+g");
    CHECK(std::holds_alternative<NoField>(stage.run.scene().world.field));
}

TEST_CASE("a change keeps every body where it is and the time")
{
    Stage stage = stage_of(three_bodies());
    play(stage, 1.3);
    const std::vector<double> before = numbers_of(stage);
    const double time = stage.run.time();
    set_friction(stage, 0.4);
    CHECK(stage.run.scene().world.friction == 0.4);
    CHECK(numbers_of(stage) == before);
    CHECK(stage.run.time() == time);
}

TEST_CASE("undo brings back what was before the change: without changes there is nothing to undo")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "ctrl+z");
    CHECK(stage.notice.text == "Nothing to undo");
    play(stage, 0.7);
    const std::vector<double> before = numbers_of(stage);
    set_friction(stage, 0.4);
    play(stage, 0.7);
    press(stage, "ctrl+z");
    CHECK(stage.notice.text == "Undone: friction");
    CHECK(stage.run.scene().world.friction == 0.0);
    CHECK(numbers_of(stage) == before);
    CHECK(stage.run.time() == doctest::Approx(0.7));
}

TEST_CASE("redo brings back what undo has taken, to the bit, one change after the other, and a new change ends that")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "ctrl+y");
    CHECK(stage.notice.text == "Nothing to redo");
    play(stage, 0.5);
    set_friction(stage, 0.4);
    set_restitution(stage, 0.5); // at the same moment
    play(stage, 0.5);
    const std::vector<double> between = numbers_of(stage);
    set_field(stage, NoField{});
    play(stage, 0.5);
    const std::vector<double> last = numbers_of(stage);

    for (int k = 0; k < 3; ++k) {
        press(stage, "ctrl+z");
        play(stage, 0.1); // what happens meanwhile gives way
    }
    CHECK_FALSE(stage.run.can_undo());
    press(stage, "ctrl+y");
    CHECK(stage.notice.text == "Redone: friction");
    CHECK(stage.run.scene().world.friction == 0.4);
    CHECK(stage.run.scene().world.restitution == 1.0);
    press(stage, "ctrl+shift+z");
    CHECK(stage.run.scene().world.restitution == 0.5);
    press(stage, "ctrl+y");
    CHECK(stage.run.time() == doctest::Approx(1.5));
    CHECK(numbers_of(stage) == last);
    CHECK_FALSE(stage.run.can_redo());

    // And undone again
    press(stage, "ctrl+z");
    CHECK(numbers_of(stage) == between);
    CHECK(stage.run.can_redo());
    set_friction(stage, 0.2);
    CHECK_FALSE(stage.run.can_redo());
}

TEST_CASE("changes of one stroke are undone together")
{
    Stage stage = stage_of(three_bodies());
    for (int k = 0; k < 5; ++k) set_friction(stage, 0.1 * k);
    stage.run.begin_stroke();
    for (int k = 0; k < 5; ++k) set_friction(stage, 1.0 + 0.1 * k);
    press(stage, "ctrl+z");
    CHECK(stage.run.scene().world.friction == doctest::Approx(0.4));
    press(stage, "ctrl+z");
    CHECK(stage.run.scene().world.friction == 0.0);
}

TEST_CASE("going back over a change finds the run as it was before it")
{
    Stage stage = stage_of(three_bodies());
    play(stage, 0.5);
    set_field(stage, NoField{});
    play(stage, 0.5);
    REQUIRE(stage.run.go_back(0.25));
    CHECK(uniform_acceleration(stage.run.scene().world.field).y() == -1.0);
    Stage other = stage_of(three_bodies());
    (void)other.run.advance(0.25, -1);
    CHECK(numbers_of(stage) == numbers_of(other));
}

TEST_CASE("reset begins anew")
{
    Stage stage = stage_of(three_bodies());
    const std::vector<double> before = numbers_of(stage);
    play(stage, 0.5);
    set_friction(stage, 0.4);
    press(stage, "home");
    CHECK(stage.run.time() == 0.0);
    CHECK(stage.run.scene().world.friction == 0.0);
    CHECK(numbers_of(stage) == before);
}

TEST_CASE("bodies that lean on each other survive a change of anything")
{
    GenerateOptions options;
    options.count = 4;
    const Expected<Scene> pyramid = generate("pyramid", options);
    REQUIRE(pyramid.has_value());
    Stage stage = stage_of(pyramid.value());
    play(stage, 0.513);
    const std::vector<double> before = numbers_of(stage);
    for (int k = 0; k < 10; ++k) {
        set_friction(stage, 0.5 + 0.01 * k);
        CHECK(stage.run.scene().world.friction == doctest::Approx(0.5 + 0.01 * k));
        play(stage, 0.0137, 0.0137);
    }
    const std::vector<double> after = numbers_of(stage);
    for (std::size_t k = 0; k < before.size(); ++k) CHECK(std::abs(after[k] - before[k]) < 1e-6);
}

TEST_CASE("a change waits for the end of the step that bodies are in, which is short where one of them is fast")
{
    // On the floor, at a spin for which a sixtieth of a second is cut into halves of halves
    Scene scene = three_bodies();
    scene.bodies = {disc(0.5, {2.0, 0.5}), rectangle(1.0, 0.6, {5.0, 0.3})};
    scene.bodies[0].spin = 200.0;
    Stage stage = stage_of(scene);
    REQUIRE(stage.run.world().mover(0) == BodyMover::rest);
    play(stage, 0.1003, 0.1003);
    const double before = stage.run.time();
    set_restitution(stage, 0.5);
    CHECK(stage.run.time() >= before);
    CHECK(stage.run.time() - before < 1.0 / 60.0 / 16.0);

    // At the end of a step there is nothing to wait for
    const double then = stage.run.time();
    set_restitution(stage, 0.6);
    CHECK(stage.run.time() == then);
}

TEST_CASE("bodies that overlap are moved apart, and those outside the box into it")
{
    Scene scene = three_bodies();
    scene.bodies[1].position = {2.2, 4.1};
    scene.bodies[2].position = {10.5, -0.3};
    REQUIRE_FALSE(validate(scene).empty());
    REQUIRE(make_room(scene, 10.0));
    CHECK(validate(scene).empty());
}

TEST_CASE("where there is no room, making room says so")
{
    Scene scene;
    scene.world.box = BoxDef{{0.0, 0.0}, {1.0, 1.0}};
    for (int k = 0; k < 9; ++k) scene.bodies.push_back(disc(0.4, {0.5, 0.5 + 0.001 * k}));
    CHECK_FALSE(make_room(scene, 10.0));
}
