#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "collide/touching.hpp"
#include "events/event_queue.hpp"
#include "geometry/shape.hpp"
#include "math/fetch.hpp"
#include "motion/field.hpp"
#include "motion/flight.hpp"
#include "response/impact.hpp"
#include "toi/prediction.hpp"

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

/// The bodies of an event engine, each with a clock of its own, set at its last impact. They lie in rows, which are not
/// in the order of the bodies' ids: neighbours in the plane are neighbours in memory. Where nothing else is said, a
/// body is named by its row.
class BodyRows
{
public:
    enum class Kind : std::int32_t
    {
        disc,
        polygon,
        is_static,
        lies,
        away
    }; ///< those that fly first

    /// Whether a body is the event engine's to move.
    enum class Presence
    {
        flies, ///< yes
        lies,  ///< no: it is struck where it lies, with the mass that it has, and is away from then on
        away,  ///< no: nothing meets it
    };

    /// What predictions read: one line of the fast memory for each body.
    struct alignas(64) Row
    {
        Vec2 position = Vec2::Zero(); ///< at `time`, like the velocity
        Vec2 velocity = Vec2::Zero();
        double time = 0.0;
        double radius = 0.0;     ///< of the bounding circle; infinite for a half-plane
        std::uint32_t stamp = 0; ///< how often it was pushed
        Kind kind = Kind::disc;
        int id = 0;
    };

    /// What only impacts and turning pairs read.
    struct alignas(64) Sheet
    {
        double angle = 0.0; ///< at the row's time
        double spin = 0.0;
        Inertia inertia;
        Material material;
        int crowding = 0; ///< impacts in a row without room between them
    };

    explicit BodyRows(std::vector<EventBody> bodies);

    [[nodiscard]] int count() const { return static_cast<int>(rows_.size()); }
    [[nodiscard]] int row_of(int id) const { return places_[id].row; }
    [[nodiscard]] const Row& operator[](int row) const { return rows_[row]; }
    [[nodiscard]] const Row* data() const { return rows_.data(); }
    [[nodiscard]] const Sheet& sheet(int row) const { return sheets_[row]; }
    [[nodiscard]] const Shape& shape_of_id(int id) const { return shapes_[id]; }
    [[nodiscard]] const Shape& shape_of(int row) const { return shapes_[rows_[row].id]; }
    /// The same; a disc's is made from its row, which is at hand, while shapes lie far away.
    [[nodiscard]] const Shape& shape_from_row(int row, Shape& disc) const
    {
        if (rows_[row].kind != Kind::disc) return shape_of(row);
        disc = Disc{rows_[row].radius};
        return disc;
    }

    [[nodiscard]] bool is_fixed(int row) const { return rows_[row].kind >= Kind::is_static; }
    [[nodiscard]] bool never_moves(int row) const { return rows_[row].kind == Kind::is_static; }
    [[nodiscard]] Presence presence(int row) const;
    /// False where others see to the pair: one of them is away, or neither flies and one only lies.
    [[nodiscard]] bool can_meet(int a, int b) const;

    /// The acceleration of all that move, where the same everywhere.  [m/s^2]
    [[nodiscard]] const Vec2& acceleration() const { return acceleration_; }
    /// Round whose centre all fly that move.
    [[nodiscard]] bool is_central() const { return central_.has_value(); }
    /// What the field does to a body where it is; nothing to what is fixed.  [m/s^2]
    [[nodiscard]] Vec2 pull_on(int row) const;

    /// Of the heaviest of all that move to the lightest.
    [[nodiscard]] double mass_ratio() const { return mass_ratio_; }

    /// A body's flight since its last impact.
    [[nodiscard]] Flyer flyer_of(int row) const
    {
        const Row& body = rows_[row];
        const Sheet& sheet = sheets_[row];
        const BodyState state{body.position, body.velocity, sheet.angle, sheet.spin, body.time};
        if (is_fixed(row)) return {state};
        return {state, acceleration_, central_ ? &*central_ : nullptr};
    }
    /// Where it is at its own time.
    [[nodiscard]] Pose pose(int row) const { return {rows_[row].position, Rotation::of(sheets_[row].angle)}; }
    /// Where its centre is at a moment that its flight lasts to.  [s]
    [[nodiscard]] Vec2 position_at(int row, double time) const { return state_at(flyer_of(row), time).position; }
    /// Bound on the speed of any point of a body.  [m/s]
    [[nodiscard]] double top_speed(int row) const
    {
        const double spin = sheets_[row].spin;
        return rows_[row].velocity.norm() + (spin == 0.0 ? 0.0 : std::abs(spin) * rows_[row].radius);
    }
    /// It turned through so large an angle that its sine is lost.
    [[nodiscard]] bool has_spun_out(int row) const { return !(std::abs(sheets_[row].angle) <= k_largest_angle); }
    /// What new velocities give to a body's kinetic energy.  [J]
    [[nodiscard]] double energy_change(int row, const Vec2& velocity, double spin) const;

    /// Whether an event still counts: neither body was pushed since it was foreseen.
    [[nodiscard]] bool is_current(const Event& event) const
    {
        // Stamps only grow: their sum is the same where both are
        const std::uint32_t stamp = places_[event.a].stamp;
        return event.stamp == (event.b < 0 ? stamp : stamp + places_[event.b].stamp);
    }

    /// Bring a body to a moment; tells whether it went anywhere since its last impact.
    bool move_to(int row, double time);
    /// New velocities, which make all that was foreseen of the body stale.
    void set_motion(int row, const Vec2& velocity, double spin);
    /// The same for a disc that doesn't turn, with the place and the moment at which it was struck.
    void set_motion(int row, const Vec2& position, double time, const Vec2& velocity)
    {
        Row& body = rows_[row];
        body.position = position;
        body.velocity = velocity;
        body.time = time;
        outdate(body);
    }
    void set_crowding(int row, int crowding) { sheets_[row].crowding = crowding; }
    /// Put a body that can move where its state says: to fly from there on, or to stay.
    void put(int row, Presence presence, const BodyState& state);
    /// Put the rows in another order: row k is the one that was row old_rows[k]. No result knows of it, for order comes
    /// from ids.
    void line_up(std::span<const int> old_rows);

    /// Ask the memory for what will be read of a body: hints, which change nothing.
    void fetch_place(int id) const { fetch(&places_[id]); }
    void fetch_row(int row) const { fetch(&rows_[row]); }
    void fetch_sheet(int row) const { fetch(&sheets_[row]); }

private:
    static constexpr double k_largest_angle = 0x1p53; // beyond it, sine_cosine has no answer [rad]

    /// What tells whether an event still counts, and where its bodies are. Close together, so that those that don't
    /// count cost no more than this.
    struct Place
    {
        int row = 0;
        std::uint32_t stamp = 0; // how often it was pushed, like the row's
    };
    void outdate(Row& row) { places_[row.id].stamp = ++row.stamp; }

    std::vector<Row> rows_;
    std::vector<Sheet> sheets_;
    std::vector<Place> places_; // by id, like the shapes
    std::vector<Shape> shapes_;
    Vec2 acceleration_ = Vec2::Zero(); // of all that move [m/s^2]
    std::optional<CentralField> central_;
    double mass_ratio_ = 1.0;
};

} // namespace flying
