#pragma once

#include <optional>
#include <string>
#include <vector>

#include "math/expected.hpp"
#include "math/vec2.hpp"
#include "world/scene.hpp"

namespace flying {

struct Stage;

/// What pressing the mouse button does.
enum class Tool
{
    grab,    ///< take a body, move it, let it go or throw it
    disc,    ///< add a disc
    polygon, ///< add a regular polygon
    draw,    ///< add a polygon, point by point
    remove   ///< take a body out
};
inline constexpr int k_tools = 5;
[[nodiscard]] std::string_view tool_text(Tool tool);

/// The hand on the stage: its tool, where it points, and what it holds.
struct Hand
{
    /// A body that is held by one of its points.
    struct Grip
    {
        int body = -1;
        Vec2 local = Vec2::Zero(); ///< the point, in the body's frame [m]
        double pulled_at = 0.0;    ///< last, by the run's clock, or taken hold of [s]
    };
    /// Where the pointer was, for the speed of a throw.
    struct Trace
    {
        double time = 0.0; ///< by the clock of what moves it [s]
        Vec2 place = Vec2::Zero(); ///< in the world [m]
    };

    Tool tool = Tool::grab;
    Vec2 pointer = Vec2::Zero();    ///< in the world [m]
    bool is_here = false;           ///< the pointer is over the stage
    bool by_keys = false;           ///< it is the crosshair, moved by keys
    bool is_pressed = false;
    Vec2 pressed_at = Vec2::Zero(); ///< [m]
    std::optional<Grip> grip;
    std::vector<Trace> traces;      ///< of late, in the order of time
    std::vector<Vec2> points;       ///< of the polygon that is drawn [m]
    int selected = -1;              ///< body that is looked at; -1 for none
    int sides = 5;                  ///< of new polygons, 3 ... 12
    double size = 0.0;              ///< radius of new bodies; 0 until it is known [m]
    double wait_until = 0.0;        ///< pulls no sooner, so that they don't eat up all time [s]
};

enum class Button
{
    left,
    right
};

/// The pointer goes to a place.
/// pixel  of the stage's surface
/// time   when it was there, by the pointer's own clock, whatever the time of the frame that tells of it [s]; where it is
///        not known, nothing is learnt of the pointer's speed
void point_at(Stage& stage, const Vec2& pixel, std::optional<double> time);
/// The same, in the world. [m]
void point_at_world(Stage& stage, const Vec2& place, std::optional<double> time);
/// Keys move it there, now.
void point_by_keys(Stage& stage, const Vec2& place);
void leave(Stage& stage);
/// A button goes down, and up, where the pointer is.
void press_button(Stage& stage, Button button);
void release_button(Stage& stage);
/// Return: as the left button, down and, where the tool needs it, up with the next one.
void press_return(Stage& stage);

/// Pull what is held towards the pointer; once a frame.
void pull(Stage& stage, double (*seconds)());

void take_tool(Stage& stage, Tool tool);
/// Let go of everything, drop what was drawn.
void cancel(Stage& stage);
/// The last point of the polygon that is drawn.
void take_point_back(Stage& stage);
/// Close the polygon that is drawn, and add it.
void close_drawing(Stage& stage);
void remove_body(Stage& stage, int body);
/// steps  of a fifth larger, or smaller where negative
void resize_new(Stage& stage, int steps);
void select_next(Stage& stage, int steps);
/// Bodies may have other numbers than before: forget what is no more.
void check_hand(Stage& stage);

/// The body that a click of the present tool would add there; none for tools that add none, or a drawing that is none yet.
[[nodiscard]] std::optional<BodyDef> new_body(const Stage& stage);
/// What is wrong with it; empty where it can be added.
[[nodiscard]] std::string fault_of_new(const Stage& stage, const BodyDef& body);
/// Which sides of the drawing cross another, by the number of their first point.
[[nodiscard]] std::vector<int> crossing_sides(const std::vector<Vec2>& points);

/// An arrow of speed shows the way that is made in this time. [s]
inline constexpr double k_seconds_of_arrow = 0.25;

} // namespace flying
