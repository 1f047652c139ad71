#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "draw/paint.hpp"
#include "play/clock.hpp"
#include "play/look.hpp"
#include "play/run.hpp"

namespace flying {

/// What the arrow keys change.
enum class ArrowKeys
{
    pointer, ///< the place of the crosshair
    restitution,
    gravity
};

/// A sentence that is shown for a while.
struct Notice
{
    std::string text;
    double until = 0.0; ///< of the stage's own clock [s]
    bool is_fault = false;
};

/// All of a window but the window: a scene that is played, how it is shown, and whose keys do what. It knows neither
/// display nor files. Time passes only in `advance`.
struct Stage
{
    /// Faults: those of the scene.
    [[nodiscard]] static Expected<Stage> open(Scene scene, const WorldOptions& options = {});

    explicit Stage(PlayRun started);

    /// Let time pass: that of the stage, and that of the scene as long as nothing holds it.
    /// wall     since the last call, >= 0                                       [s]
    /// seconds  a clock that only goes forward, by which the work is kept within the budget [s]
    void advance(double wall, double (*seconds)());
    /// Bring `picture` up to the run, after anything changed.
    void refresh();

    /// Say something for some seconds.
    void say(std::string text, bool is_fault = false);
    /// Try a change, and say what is wrong with it. True where it was made.
    bool change(Scene scene, const std::string& label, Crowding crowding = Crowding::make_room);

    PlayRun run;
    Look look;
    PlayClock clock;
    ArrowKeys arrow_keys = ArrowKeys::pointer;
    double mode_until = 0.0; ///< the bar of a mode is shown until then [s]
    Notice notice;
    double now = 0.0;        ///< of the stage's own clock [s]
    bool wants_to_quit = false;
    SurfaceSize size{1280, 800};
    Picture picture;         ///< of the run, as `refresh` left it
    bool view_is_free = false; ///< zoomed or moved by hand: it no longer widens by itself
    int generation = -1;     ///< of the run, whose bodies `picture` holds
};

/// One frame on, or several back, whatever the clock does; it stops there.
void step(Stage& stage, int frames);
void set_speed(Stage& stage, double speed);
void set_restitution(Stage& stage, double e);
void set_friction(Stage& stage, double mu);
void set_field(Stage& stage, const Field& field);

enum class FieldKind
{
    none,
    uniform,
    central
};
[[nodiscard]] FieldKind field_kind(const Field& field);
/// The field of another kind, with strengths that suit what is in sight.
void set_field_kind(Stage& stage, FieldKind kind);

/// An arrow key where the arrows change something.  dx, dy  one of them +1 or -1, the other 0;  coarse  ten at once
void turn_knob(Stage& stage, int dx, int dy, bool coarse);

/// Step in which the keys change a gravity: a round eightieth of the height in sight.  [m/s^2]
[[nodiscard]] double gravity_step(const Stage& stage);

} // namespace flying
