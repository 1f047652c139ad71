#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/box_cells.hpp"
#include "geometry/aabb.hpp"

namespace flying {

/// [radii] Room about a body's circle, or its flight, against rounding and the tolerance of touching.
inline constexpr double k_room = 0x1p-10;

/// A body that the resting integrator has, as it is when a step begins.
struct Leaning
{
    int body = 0;
    Vec2 position = Vec2::Zero();
    double radius = 0.0; ///< of its bounding circle [m]
    double speed = 0.0;  ///< of its centre [m/s]
    double pull = 0.0;   ///< no less than the field, wherever it may get in a step [m/s^2]
    Aabb way;            ///< holds all of it for a whole step, as it moves now
};

/// Which of some are connected, directly or by others, and how fast the fastest is.
class Connections
{
public:
    void clear();
    /// One more, which is connected to none; what comes back is its number.
    int add(double speed);
    void join(int one, int two);
    /// The first that one is connected to.
    [[nodiscard]] int root_of(int k);
    [[nodiscard]] double top_speed(int k) { return nodes_[root_of(k)].top_speed; }

    /// What has come so far is known, from now on.
    void know_all();
    void know(int k) { nodes_[root_of(k)].is_known = true; }
    /// Some that is known was joined to something faster.
    [[nodiscard]] bool any_is_faster() const { return any_is_faster_; }

private:
    struct Node
    {
        int parent = 0;         // towards the first that it is connected to, which knows the rest
        double top_speed = 0.0; // [m/s]
        bool is_known = false;
    };
    std::vector<Node> nodes_;
    bool any_is_faster_ = false;
};

/// The rules by which bodies change hands, as functions of where bodies are when a step begins and how fast they move:
/// a body that flies is taken in where it may meet one that leans, and is awake or may be woken, before the step ends;
/// one that bears no load is let go unless one that stays might take it in again.
///
/// Those that sleep are sorted once, when others sleep than before. A step asks only for those that are awake, and for
/// the sleeping islands that they may come to.
class HandOver
{
public:
    /// Those that sleep, until others do.
    void set_asleep(std::vector<Leaning> asleep);
    /// Which of those that are awake are connected within a step, and with which that sleep. To be followed by `reach`.
    void begin(std::vector<Leaning> awake);
    /// Where those that are awake, and those that they may wake, can get within so long.  [s]
    void reach(double time);
    /// Some that have come since, one or more times. What comes back is as far as others may get now than before; to be
    /// followed by `end`.
    [[nodiscard]] std::span<const BoxCells::Entry> add(const std::vector<Leaning>& more);
    void end();

    /// Whether one of these may get into the box.
    [[nodiscard]] bool is_near(const Aabb& box) const;
    /// Of bodies that could go, and are awake, those that no other will take in again.
    /// may_go  ascending, as is what comes back
    [[nodiscard]] std::vector<int> may_leave(const std::vector<int>& may_go);

    /// Bodies looked at, those that sleep too, in all.
    [[nodiscard]] std::int64_t looked_at() const { return looked_at_; }

private:
    /// Some that sleep, and may come to each other within a step.
    struct Island
    {
        std::vector<int> members; // places in `asleep_`
        double top_speed = 0.0;   // [m/s]
        int node = -1;            // in `connections_`, where one that is awake may come to it
    };
    void connect_to_sleepers(int k);
    void add_reach(const Leaning& one, int node);

    std::vector<Leaning> asleep_;
    std::vector<int> island_; // of each of them
    std::vector<Island> islands_;
    BoxCells ways_asleep_; // entries name places in `asleep_`

    std::vector<Leaning> awake_;
    std::vector<int> node_;    // of each of them, in `connections_`
    BoxCells ways_;            // of those that were sorted; entries name places in `awake_`
    int sorted_ = 0;           // how many
    std::vector<int> reached_; // islands that one of these may come to
    Connections connections_;
    double time_ = 0.0;                        // within which others are reached [s]
    std::vector<BoxCells::Entry> new_reaches_; // not sorted yet; entries name bodies
    std::size_t first_new_ = 0;                // of these, that came last
    BoxCells reaches_;                         // the others
    std::int64_t looked_at_ = 0;
};

} // namespace flying
