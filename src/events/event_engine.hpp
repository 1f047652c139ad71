#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "events/at_once.hpp"
#include "events/body_rows.hpp"
#include "events/encounter.hpp"
#include "events/event_counts.hpp"
#include "events/event_options.hpp"
#include "events/foreseen.hpp"
#include "events/lasting_contact.hpp"
#include "events/meeting.hpp"
#include "events/neighbours.hpp"
#include "events/predictor.hpp"
#include "events/static_surfaces.hpp"
#include "math/hash.hpp"

namespace flying {

/// Why an engine can't go on.
struct EventFailure
{
    enum class Kind
    {
        crowded,    ///< impacts follow each other without end, with no time between them
        unresolved, ///< an impact's points could not all be made to part
        spun_out,   ///< a body turned through so large an angle that its sine is lost
        settled,    ///< a body's bounces on something flat have shrunk to a touch
        stays,      ///< an impact has left a body on another, to which the field presses it
    };
    Kind kind = Kind::crowded;
    double time = 0.0; ///< [s]
    int a = -1;        ///< the two bodies of the last impact
    int b = -1;
    double bounces_end = 0.0; ///< where they settled: when the last of infinitely many would have happened [s]
};

/// Moves bodies from event to event. Every body has a clock of its own, set at its last impact, and nothing moves
/// between: what happens does not depend on who looks, or when.
///
/// Bodies must not overlap at their start, beyond touching. Those that move share one acceleration, one centre or none.
class EventEngine
{
public:
    EventEngine(std::vector<EventBody> bodies, const EventEngineOptions& options);

    /// Handle every event up to `time`, or `most` of them.  [s]
    [[nodiscard]] std::optional<EventFailure> advance(double time, std::int64_t most);

    [[nodiscard]] double time() const { return now_; }
    [[nodiscard]] int body_count() const { return bodies_.count(); }
    /// A body's flight since its last impact; one that others move stays where they put it.
    [[nodiscard]] Flyer flyer(int body) const { return bodies_.flyer_of(bodies_.row_of(body)); }
    [[nodiscard]] const Shape& shape(int body) const { return bodies_.shape_of_id(body); }
    [[nodiscard]] const Inertia& inertia(int body) const { return bodies_.sheet(bodies_.row_of(body)).inertia; }
    [[nodiscard]] bool is_static(int body) const { return bodies_.is_fixed(bodies_.row_of(body)); }

    [[nodiscard]] std::uint64_t log_hash() const { return log_.value(); }
    /// The impacts handled last: those of one group at one moment; none before the first.
    [[nodiscard]] std::span<const Event> last_impacts() const { return noticed_.impacts; }
    [[nodiscard]] double max_overlap() const { return max_overlap_; }
    [[nodiscard]] const EventCounts& counts() const { return counts_; }
    [[nodiscard]] const EventSeconds& seconds() const { return seconds_; }
    void set_clock(double (*clock)()) { options_.seconds = clock; }

    /// Whether a body is this engine's to move.
    using Presence = BodyRows::Presence;
    /// Give a body to others, or take it back.  state  at the engine's time
    void place(int body, Presence presence, const BodyState& state);
    [[nodiscard]] Presence presence(int body) const { return bodies_.presence(bodies_.row_of(body)); }
    /// Come back from `advance` after every impact, or only after those that strike a body that lies.
    void notice_all(bool all) { noticed_.all = all; }
    /// The last impact made `advance` come back early.
    [[nodiscard]] bool noticed() const { return noticed_.now; }
    /// What impacts have taken from the kinetic energy.  [J]
    [[nodiscard]] double energy_lost() const { return energy_lost_; }

    using Bounces = flying::Bounces;
    /// What a later engine needs to go on with the same bits, beside the bodies.
    struct Resume
    {
        double time = 0.0;
        std::uint64_t log_hash = 0;
        double max_overlap = 0.0;
        std::vector<int> crowding;
        double energy_lost = 0.0;
        std::vector<Presence> presence;
        std::vector<Bounces> bounces;
    };
    [[nodiscard]] Resume resume() const;
    /// states  of the first bodies, each at the time of its last impact; the rest stay as they are
    void go_on_from(const Resume& resume, const std::vector<BodyState>& states);

private:
    [[nodiscard]] std::optional<EventFailure> handle(const Event& event);
    [[nodiscard]] bool may_have_company(const Event& impact);
    void gather_at_once(const Event& first);
    [[nodiscard]] std::optional<EventFailure> handle_impacts(std::span<const Event> impacts);
    [[nodiscard]] bool strike_discs(const Event& event);
    [[nodiscard]] std::optional<EventFailure> strike(std::span<const Event> impacts);
    [[nodiscard]] std::optional<EventFailure> failure_of(const Encounter& one, bool ended) const;
    void handle_look(const Event& event);
    void handle_cell(const Event& event);

    void set_up_cells();
    void line_up(const std::vector<int>& old_rows);
    void line_up_again();
    [[nodiscard]] Predictor predictor();
    void predict_all();
    void predict_after_impact(Predictor& predictor, int body, int partner);
    void predict_after_impacts(Predictor& predictor, std::span<const Event> impacts);
    void predict_anew(int body);
    void await(int body) { counts_.stale += foreseen_.await(bodies_, body); }

    void set_motion(int body, const Vec2& velocity, double spin);
    void count_crowding(int body, bool has_room);
    void log_impact(const Event& event, int row_a, int row_b);

    EventEngineOptions options_;
    BodyRows bodies_;
    StaticSurfaces surfaces_;
    PredictionRules rules_;
    Neighbours neighbours_;
    ForeseenEvents foreseen_;
    std::vector<Bounces> bounces_; // by id
    double now_ = 0.0;             // [s]
    double max_overlap_ = 0.0;     // [m]
    double energy_lost_ = 0.0;     // to impacts [J]
    Hash log_;
    ImpactsAtOnce at_once_;
    struct
    {
        bool all = false;           // every impact is
        bool now = false;           // the last ones were
        std::vector<Event> impacts; // the last ones
    } noticed_;
    std::int64_t line_up_at_ = 0; // when so many cells have been left, rows are put in order again
    EventCounts counts_;
    EventSeconds seconds_;
    std::vector<Encounter> encounters_; // workspace of impacts
    Push push_;                         // likewise
    std::vector<int> near_;             // workspace: rows of those about one body
};

} // namespace flying
