#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "broadphase/grid.hpp"
#include "broadphase/pair_finder.hpp"
#include "collide/seams.hpp"
#include "collide/touching.hpp"
#include "events/event_queue.hpp"
#include "events/waiting.hpp"
#include "math/hash.hpp"
#include "response/impact.hpp"
#include "toi/predict.hpp"

namespace flying {


/// One body as the event engine is given it.
struct EventBody
{
    Shape shape;
    Flyer flyer;
    Inertia inertia;
    Material material;
    bool is_static = false; ///< never moves: no velocity, no spin, no acceleration, infinite mass
};



struct EventEngineOptions
{
    PairFinder pair_finder = PairFinder::grid;
    bool skips_static_pairs = true; ///< static bodies are not compared with each other
    bool skips_far_features = true; ///< turning features wait until bounding circles meet
    bool skips_search = true;       ///< movers are predicted and struck from their rows, and later events of each wait
    bool skips_absent_field = true; ///< where nothing falls, paths are straight
    bool skips_apart_rings = true;  ///< round a centre, rings apart never meet
    bool skips_far_vertices = true; ///< vertices out of reach aren't followed
    bool ends_bounces = false;      ///< say so where an impact leaves a body on another, and when bounces ended that died away
    int most_crowded = 1000;        ///< impacts in a row of one body that leave it no room to move
    double (*seconds)() = nullptr;  ///< a clock, lent to measure the stages; null to measure nothing [s]
};



/// Why an engine can't go on.
struct EventFailure
{
    enum class Kind {
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



/// Work done so far, and work left out.
struct EventCounts
{
    std::int64_t events = 0;      ///< all that were handled
    std::int64_t impacts = 0;     ///< in which some point was pushed
    std::int64_t cells = 0;       ///< cells left
    std::int64_t looks = 0;       ///< pairs looked at again
    std::int64_t predictions = 0; ///< pairs predicted, all told
    std::int64_t stale = 0;       ///< events that had been overtaken
    std::int64_t searches = 0;    ///< predictions and looks that took the general search
    std::int64_t static_pairs_skipped = 0;
    std::int64_t far_pairs_skipped = 0;    ///< pairs that the grid left alone, compared with all pairs
    std::int64_t far_features_skipped = 0; ///< predictions of turning pairs whose bounding circles never meet
    std::int64_t fetched = 0; ///< bodies whose rows were asked for ahead
};



/// Seconds spent, where a clock was lent.
struct EventSeconds
{
    double predict = 0.0;
    double look = 0.0;
    double impact = 0.0;
    double cells = 0.0;
};



/// Moves bodies from event to event. Every body has a clock of its own, set at its last impact, and nothing moves between:
/// what happens does not depend on who looks, or when.
///
/// Bodies must not overlap at their start, beyond touching. Those that move share one acceleration, one centre or none.
class EventEngine
{
public:
    EventEngine(std::vector<EventBody> bodies, const EventEngineOptions& options);

    /// Handle every event up to `time`, or `most` of them.  [s]
    [[nodiscard]] std::optional<EventFailure> advance(double time, std::int64_t most);


    [[nodiscard]] double time() const { return now_; }
    [[nodiscard]] int body_count() const { return static_cast<int>(rows_.size()); }
    /// A body's flight since its last impact; one that others move stays where they put it.
    [[nodiscard]] Flyer flyer(int body) const { return flyer_of(row_of(body)); }
    [[nodiscard]] const Shape& shape(int body) const { return shapes_[body]; }
    [[nodiscard]] const Inertia& inertia(int body) const { return sheets_[row_of(body)].inertia; }
    [[nodiscard]] bool is_static(int body) const { return is_fixed(row_of(body)); }

    [[nodiscard]] std::uint64_t log_hash() const { return log_.value(); }
    /// The impact handled last; its bodies are -1 before the first.
    [[nodiscard]] const Event& last_impact() const { return last_impact_; }
    [[nodiscard]] double max_overlap() const { return max_overlap_; }
    [[nodiscard]] const EventCounts& counts() const { return counts_; }
    [[nodiscard]] const EventSeconds& seconds() const { return seconds_; }
    void set_clock(double (*clock)()) { options_.seconds = clock; }



    /// Whether a body is this engine's to move.
    enum class Presence {
        flies, ///< yes
        lies,  ///< no: it is struck where it lies, with the mass that it has, and is away from then on
        away,  ///< no: nothing meets it
    };
    /// Give a body to others, or take it back.  state  at the engine's time
    void place(int body, Presence presence, const BodyState& state);
    [[nodiscard]] Presence presence(int body) const;
    /// Come back from `advance` after every impact, or only after those that strike a body that lies.
    void notice_all(bool all) { notices_all_ = all; }
    /// The last impact made `advance` come back early.
    [[nodiscard]] bool noticed() const { return noticed_; }
    /// What impacts have taken from the kinetic energy.  [J]
    [[nodiscard]] double energy_lost() const { return energy_lost_; }



    /// Bounces of one body on one flat thing, undisturbed.
    struct Bounces
    {
        int on = -1; ///< -1 where the last impact was none of them
        Vec2 normal = Vec2::Zero();
        double end = 0.0; ///< [s]
    };
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

    enum class Kind : std::int32_t { disc, polygon, is_static, lies, away }; // those that fly first

    static constexpr double k_largest_angle = 0x1p53; // beyond it, sine_cosine has no answer [rad]



    /// What predictions read: one line of the fast memory for each body. Rows are not in the order of the bodies' ids:
    /// neighbours in the plane are neighbours in memory.
    struct alignas(64) Row
    {
        Vec2 position = Vec2::Zero(); // at `time`, like the velocity
        Vec2 velocity = Vec2::Zero();
        double time = 0.0;
        double radius = 0.0; // of the bounding circle; infinite for a half-plane
        std::uint32_t stamp = 0; // how often it was pushed
        Kind kind = Kind::disc;
        int id = 0;
    };



    /// What only impacts and turning pairs read.
    struct alignas(64) Sheet
    {
        double angle = 0.0; // at the row's time
        double spin = 0.0;
        Inertia inertia;
        Material material;
        int crowding = 0; // impacts in a row without room between them
    };



    /// What tells whether an event still counts, and where its bodies are. Close together, so that those that don't count
    /// cost no more than this.
    struct Place
    {
        int row = 0;
        std::uint32_t stamp = 0; // how often it was pushed, like the row's
    };
    [[nodiscard]] int row_of(int id) const { return places_[id].row; }



    [[nodiscard]] bool is_current(const Event& event) const
    {
        // Stamps only grow: their sum is the same where both are
        const std::uint32_t stamp = places_[event.a].stamp;
        return event.stamp == (event.b < 0 ? stamp : stamp + places_[event.b].stamp);
    }


    /// It is the first event of its owner: when it is over or overtaken, the next one's turn has come.
    [[nodiscard]] bool is_called(const Event& event) const
    {
        return event.owner != Event::Owner::none && waiting_[owner_of(event)].called == event.time;
    }
    [[nodiscard]] int owner_of(const Event& event) const
    {
        return row_of(event.owner == Event::Owner::b ? event.b : event.a);
    }


    // From here on bodies are named by their rows, but in events and failures, which name them by id
    [[nodiscard]] bool is_fixed(int row) const { return rows_[row].kind >= Kind::is_static; }
    [[nodiscard]] bool never_moves(int row) const { return rows_[row].kind == Kind::is_static; }
    [[nodiscard]] const Shape& shape_of(int row) const { return shapes_[rows_[row].id]; }
    /// The same; a disc's is made from its row, which is at hand, while shapes lie far away
    [[nodiscard]] const Shape& shape_from_row(int row, Shape& disc) const
    {
        if (rows_[row].kind != Kind::disc) return shape_of(row);
        disc = Disc{rows_[row].radius};
        return disc;
    }
    [[nodiscard]] Flyer flyer_of(int body) const
    {
        const Row& row = rows_[body];
        const Sheet& sheet = sheets_[body];
        const BodyState state{row.position, row.velocity, sheet.angle, sheet.spin, row.time};
        if (is_fixed(body)) return {state};
        return {state, acceleration_, central_ ? &*central_ : nullptr};
    }
    template <typename CellOf>
    [[nodiscard]] std::vector<int> order_along_curve(const CellOf& cell_of) const;
    void line_up(const std::vector<int>& old_rows);
    void line_up_again();
    void fetch_ahead();



    [[nodiscard]] std::optional<EventFailure> handle(const Event& event);
    [[nodiscard]] std::optional<EventFailure> handle_impact(const Event& event);
    [[nodiscard]] std::optional<EventFailure> strike(const Event& event, int a, int b);
    [[nodiscard]] bool strike_discs(const Event& event, int a, int b);
    void handle_look(const Event& event);
    void handle_cell(const Event& event);

    void set_up_grid();
    void predict_all();
    void predict_after_impact(int body, int partner);
    void predict_anew(int body);
    template <typename Wants>
    void predict_partners(int body, const Wants& wants);
    void predict_near(int body, int partner);
    void predict_pair(int p, int q);
    void predict_movers(int p, int q);
    void predict_general(int p, int q, double from, int windows);
    void push_pair(double time, int p, int q, Event::Kind kind);
    void predict_cell(int body, double now);
    void await(int body);
    void call_all();
    void forget(int body);

    double find_points(int a, int b, double time);
    void find_seams_of_statics();
    void touch_surface(int a, int b, double slack);
    void mend_touches(int a, int b);
    void add_points();
    [[nodiscard]] bool has_seams(int body) const { return !seams_[rows_[body].id].empty(); }
    [[nodiscard]] bool is_creeping(int a, int b, double touch) const;
    bool move_to(int body, double time);
    [[nodiscard]] bool has_spun_out(int body) const { return !(std::abs(sheets_[body].angle) <= k_largest_angle); }
    void set_motion(int body, const Vec2& velocity, double spin);
    void log_impact(const Event& event, int row_a, int row_b);
    [[nodiscard]] double top_speed(int body) const;
    [[nodiscard]] Pose pose(int body) const;
    void sweep_queue();
    [[nodiscard]] Kind kind_of(int body, Presence presence) const;
    [[nodiscard]] bool can_meet(int a, int b) const;
    [[nodiscard]] double energy_change(int body, const Vec2& velocity, double spin) const;
    [[nodiscard]] Vec2 pull_on(int body) const;
    [[nodiscard]] bool stays(int a, int b, double touch) const;
    [[nodiscard]] std::optional<double> end_of_bounces(int a, int b, double time, double touch);



    EventEngineOptions options_;
    std::vector<Row> rows_;
    std::vector<Sheet> sheets_;
    std::vector<Waiting> waiting_;
    std::vector<Place> places_;       // by id, like the shapes
    std::vector<Shape> shapes_;
    std::vector<std::vector<Seam>> seams_; // of static bodies with what lies beside them, by id
    std::vector<std::vector<int>> beside_; // ids of what lies beside them, by id
    std::vector<int> everywhere_;     // rows of static bodies that no cell can hold
    bool fetches_ahead_ = false;      // for more bodies than the fast memory holds
    std::int64_t line_up_at_ = 0;             // when so many cells have been left, rows are put in order again
    Vec2 acceleration_ = Vec2::Zero(); // of all that move [m/s^2]
    bool falls_ = false;              // there is such an acceleration
    bool searches_all_ = false;       // every pair takes the general search
    bool is_plain_ = false;           // movers are read from their rows, and fly straight
    std::optional<CentralField> central_; // round whose centre all fly that move
    std::optional<Grid> grid_;
    EventQueue queue_;
    std::size_t sweep_at_ = 0;
    double now_ = 0.0;
    double max_overlap_ = 0.0;
    Hash log_;
    EventCounts counts_;
    EventSeconds seconds_;
    Event last_impact_;
    Shape disc_a_ = Disc{};           // workspace of one impact
    Shape disc_b_ = Disc{};           // workspace of one impact
    double energy_lost_ = 0.0;        // to impacts [J]
    bool notices_all_ = false;
    bool noticed_ = false;
    std::vector<Bounces> bounces_;    // by id
    std::vector<Event> foreseen_;     // workspace: of one body
    std::vector<int> near_;           // workspace: rows of those about one body
    std::vector<Touch> touches_;      // workspace of one impact
    std::vector<ImpactPoint> points_; // workspace of one impact

};


} // namespace flying
