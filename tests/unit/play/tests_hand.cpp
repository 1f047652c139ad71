#include "play/pick.hpp"
#include "scene/read.hpp"
#include "stages.hpp"

using namespace flying;
using namespace flying::testing;

namespace {

void click(Stage& stage, const Vec2& place)
{
    point(stage, place);
    press_button(stage, Button::left);
    release_button(stage);
}

/// A clock by which each change of the run takes a twentieth of a second.
double slow_changes()
{
    static double now = 0.0;
    return now += 0.05;
}

} // namespace

TEST_CASE("a body is found under the pointer, in its concave parts and holes it isn't")
{
    Scene scene;
    BodyDef frame;
    frame.shape = PolygonDef{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}};
    scene.bodies = {frame, disc(0.5, {5.0, 0.0})};
    const Stage stage = stage_of(scene);
    const World& world = stage.run.world();
    CHECK(body_at(world, {1.5, 0.0}, 0.0) == 0);
    CHECK(body_at(world, {0.0, 0.0}, 0.0) == -1);
    CHECK(body_at(world, {5.3, 0.3}, 0.0) == 1);
    CHECK(body_at(world, {5.6, 0.0}, 0.0) == -1);
    CHECK(body_at(world, {5.6, 0.0}, 0.7) == 1);
}

TEST_CASE("a body that is held follows the pointer, and flies on with its speed when it is let go")
{
    Scene scene = three_bodies();
    scene.world.field = NoField{};
    Stage stage = stage_of(scene);
    point(stage, {5.1, 2.0});
    press_button(stage, Button::left);
    REQUIRE(stage.hand.grip.has_value());
    CHECK(stage.hand.grip->body == 1);
    for (int k = 0; k < 60; ++k) {
        stage.advance(1.0 / 60.0, no_time);
        point(stage, Vec2(5.1, 2.0) + k * Vec2(0.03, 0.04));
    }
    // 1.8 m/s and 2.4 m/s, a tenth of a second behind
    const BodyState held = stage.run.world().state(1);
    CHECK(held.position.x() == doctest::Approx(5.1 + 1.8).epsilon(0.05));
    CHECK(held.position.y() == doctest::Approx(2.0 + 2.4).epsilon(0.08));
    release_button(stage);
    CHECK(stage.hand.grip == std::nullopt);
    const BodyState thrown = stage.run.world().state(1);
    const Vec2 at_grip = velocity_at(thrown, Rotation::of(thrown.angle) * Vec2(0.1, 0.0));
    CHECK(at_grip.x() == doctest::Approx(1.8).epsilon(0.1));
    CHECK(at_grip.y() == doctest::Approx(2.4).epsilon(0.1));

    // All of it is one change
    press(stage, "ctrl+z");
    CHECK(stage.notice.text == "Undone: throw");
    CHECK(stage.run.world().state(1).velocity == Vec2::Zero());
}

TEST_CASE("a card is pulled out of a house that has settled")
{
    // Cards that lean on each other overlap by less than a micrometre, and sixty rounds did not make room for them: the
    // hand was refused, and told so
    const Expected<Scene> scene = read_scene_file(FLYING_SOURCE_DIR "/chapters/scenes/cards.toml");
    REQUIRE(scene.has_value());
    constexpr int k_card = 7;
    for (const double speed : {0.5, 1.0, 2.0}) {
        CAPTURE(speed);
        Stage stage = stage_of(scene.value());
        play(stage, 1.0);
        point(stage, {0.0, 1.01});
        press_button(stage, Button::left);
        REQUIRE(stage.hand.grip.has_value());
        REQUIRE(stage.hand.grip->body == k_card);
        for (int k = 1; k <= 60; ++k) {
            stage.advance(1.0 / 60.0, no_time);
            point(stage, Vec2(0.0, 1.01) + speed * k / 60.0 * Vec2(1.0, 0.5));
            CAPTURE(stage.notice.text);
            REQUIRE_FALSE(stage.notice.is_fault);
        }
        CHECK(stage.run.world().state(k_card).position.x() > 0.5 * speed);
    }
}

TEST_CASE("what is held comes to the pointer, however rarely it can be pulled")
{
    // It was given the speed that brings it there in 0.06 s, kept it until the next pull, and flew past ever farther
    Scene scene = three_bodies();
    scene.world.field = NoField{};
    scene.world.restitution = 0.5;
    for (const auto seconds : {no_time, slow_changes}) {
        Stage stage = stage_of(scene);
        point(stage, {5.0, 2.0});
        press_button(stage, Button::left);
        REQUIRE(stage.hand.grip.has_value());
        point(stage, {6.0, 3.0});
        for (int k = 0; k < 120; ++k) stage.advance(1.0 / 60.0, seconds);
        for (int k = 0; k < 60; ++k) {
            stage.advance(1.0 / 60.0, seconds);
            CHECK((stage.run.world().state(1).position - Vec2(6.0, 3.0)).norm() < 0.05);
        }
    }
}

TEST_CASE("a throw has the speed of the hand, whatever the frames do")
{
    Scene scene = three_bodies();
    scene.world.field = NoField{};
    const Vec2 start(5.1, 2.0);
    const Vec2 velocity(3.0, 1.0);
    for (const int reports_a_frame : {1, 5, 1000}) {
        for (const bool rests : {false, true}) {
            CAPTURE(reports_a_frame);
            CAPTURE(rests);
            Stage stage = stage_of(scene);
            // The mouse has a clock of its own, and reports every eight milliseconds
            double time = 7000.0;
            Vec2 place = start;
            point_at_world(stage, place, time);
            press_button(stage, Button::left);
            REQUIRE(stage.hand.grip.has_value());
            for (int report = 1; report <= 25; ++report) {
                time += 0.008;
                place += 0.008 * (report > 10 ? velocity : Vec2(-velocity));
                point_at_world(stage, place, time);
                if (report % reports_a_frame == 0) stage.advance(0.008 * reports_a_frame, no_time);
            }
            if (rests) time += 0.1;
            point_at_world(stage, place, time);
            release_button(stage);
            const BodyState thrown = stage.run.world().state(1);
            const Vec2 at_grip = velocity_at(thrown, Rotation::of(thrown.angle) * Vec2(0.1, 0.0));
            CHECK((at_grip - (rests ? Vec2::Zero() : velocity)).norm() < 1e-9);
        }
    }
}

TEST_CASE("keys that let go of what the mouse has moved don't throw it")
{
    Scene scene = three_bodies();
    scene.world.field = NoField{};
    Stage stage = stage_of(scene);
    point_at_world(stage, {5.1, 2.0}, 7000.0);
    press_button(stage, Button::left);
    point_at_world(stage, {5.5, 2.0}, 7000.05);
    press(stage, "return");
    CHECK(stage.hand.grip == std::nullopt);
    CHECK(stage.run.world().state(1).velocity.norm() < 1e-9);
}

TEST_CASE("while time stands still a body is carried, and not into another")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "p");
    point(stage, {2.0, 4.0});
    press_button(stage, Button::left);
    point(stage, {3.5, 4.5});
    stage.advance(0.01, no_time);
    CHECK((stage.run.world().state(0).position - Vec2(3.5, 4.5)).norm() < 1e-9);
    CHECK(stage.run.world().state(0).velocity == Vec2(1.0, 0.0));
    point(stage, {5.0, 2.0});
    stage.advance(0.01, no_time);
    CHECK((stage.run.world().state(0).position - Vec2(3.5, 4.5)).norm() < 1e-9);
    CHECK(stage.run.time() == 0.0);
}

TEST_CASE("discs and polygons are added where there is room, with the speed that they are dragged")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "p");
    press(stage, "2");
    click(stage, {8.0, 2.0});
    REQUIRE(stage.run.world().body_count() == 4);
    CHECK(std::holds_alternative<Disc>(stage.run.world().shape(3)));
    click(stage, {8.1, 2.0});
    CHECK(stage.run.world().body_count() == 4);
    CHECK(stage.notice.is_fault);
    CHECK(stage.notice.text == "No room: it would overlap body 3");
    click(stage, {9.9, 2.0});
    CHECK(stage.notice.text == "No room: it would overlap the box");

    press(stage, "3");
    press(stage, "page_up");
    press(stage, "bracketright");
    point(stage, {3.0, 6.0});
    press_button(stage, Button::left);
    point(stage, {4.0, 6.5});
    release_button(stage);
    REQUIRE(stage.run.world().body_count() == 5);
    CHECK(stage.run.world().state(4).position == Vec2(3.0, 6.0));
    CHECK(stage.run.world().state(4).velocity == Vec2(1.0, 0.5) / k_seconds_of_arrow);
    CHECK(std::get<RegularDef>(stage.run.scene().bodies[4].shape).sides == 6);
}

TEST_CASE("a polygon is drawn point by point, concave too: one whose sides cross is refused")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "p");
    press(stage, "4");
    for (const Vec2& point : {Vec2(3, 5), Vec2(5, 7), Vec2(3, 7), Vec2(5, 5)}) click(stage, point);
    CHECK(crossing_sides(stage.hand.points) == std::vector<int>{0, 2});
    press_button(stage, Button::right);
    CHECK(stage.run.world().body_count() == 3);
    CHECK(stage.notice.is_fault);
    press(stage, "escape");
    for (const Vec2& point : {Vec2(3, 5), Vec2(5.123456, 7), Vec2(3, 7), Vec2(5, 4)}) click(stage, point);
    press_button(stage, Button::right);
    CHECK(
        stage.notice.text.starts_with("No polygon yet: edge 0 of vertices, from (3, 5) to (5.123, 7) crosses edge 2"));
    press(stage, "escape");
    CHECK(stage.hand.points.empty());

    for (const Vec2& point : {Vec2(3, 5), Vec2(5, 5), Vec2(5, 7), Vec2(9, 9)}) click(stage, point);
    press(stage, "backspace");
    click(stage, {4.5, 5.5});
    CHECK(crossing_sides(stage.hand.points).empty());
    click(stage, {3, 5});
    REQUIRE(stage.run.world().body_count() == 4);
    CHECK_FALSE(std::get<Polygon>(stage.run.world().shape(3)).is_convex());
    CHECK(stage.hand.points.empty());
    // It stands where it was drawn
    CHECK(body_at(stage.run.world(), {4.9, 5.1}, 0.0) == 3);
    CHECK(body_at(stage.run.world(), {4.0, 5.9}, 0.0) == -1);
}

TEST_CASE("bodies are removed with the tool, and with Delete where one is chosen: undo brings them back")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "5");
    click(stage, {5.0, 2.0});
    CHECK(stage.run.world().body_count() == 2);
    press(stage, "1");
    press(stage, "b");
    CHECK(stage.hand.selected == 0);
    press(stage, "delete");
    CHECK(stage.run.world().body_count() == 1);
    press(stage, "ctrl+z");
    press(stage, "ctrl+z");
    CHECK(stage.run.world().body_count() == 3);
    CHECK(stage.run.scene().bodies[1].name == "box");
}

TEST_CASE("the crosshair does all that the mouse does")
{
    Stage stage = stage_of(three_bodies());
    press(stage, "p");
    press(stage, "2");
    press(stage, "right"); // from the middle of what is in sight
    press(stage, "shift+up");
    const Vec2 place = stage.hand.pointer;
    CHECK(place.y() > 4.3);
    press(stage, "return");
    press(stage, "return");
    REQUIRE(stage.run.world().body_count() == 4);
    CHECK(stage.run.world().state(3).position == place);

    press(stage, "1");
    press(stage, "b");
    press(stage, "b");
    const int chosen = stage.hand.selected;
    const Vec2 before = stage.run.world().state(chosen).position;
    press(stage, "return");
    CHECK(stage.hand.grip.has_value());
    press(stage, "left");
    stage.advance(0.01, no_time);
    press(stage, "return");
    CHECK(stage.run.world().state(chosen).position.x() < before.x());
}

TEST_CASE("scrolling steers the ship: it turns, and burns for fifty frames")
{
    Scene scene = three_bodies();
    scene.world.field = NoField{};
    scene.bodies[0].velocity = {0.0, 0.0};
    Stage stage = stage_of(scene);
    steer(stage, 9.0, 0.0);
    CHECK(stage.ship.body == 0);
    CHECK(std::abs(stage.ship.heading) < 1e-12);
    CHECK_FALSE(stage.ship.burns(stage.now));
    steer(stage, 0.0, 2.0);
    CHECK(stage.ship.thrust == 0.5);
    play(stage, 2.0);
    const Vec2 velocity = stage.run.world().state(0).velocity;
    const double expected = 50.0 / 60.0 * 0.5 * full_thrust(stage);
    CHECK(velocity.x() == doctest::Approx(expected).epsilon(0.03));
    CHECK(std::abs(velocity.y()) < 1e-12);
    CHECK_FALSE(stage.ship.burns(stage.now));
}

TEST_CASE("a box that is made smaller moves bodies back inside")
{
    Stage stage = stage_of(three_bodies());
    resize_box(stage, 0.6, 0.5);
    REQUIRE(stage.run.scene().world.box.has_value());
    CHECK(stage.run.scene().world.box->max == Vec2(6.0, 4.0));
    for (int k = 0; k < 3; ++k) {
        CHECK(stage.run.world().state(k).position.x() < 6.0);
        CHECK(stage.run.world().state(k).position.y() < 4.0);
    }
}
