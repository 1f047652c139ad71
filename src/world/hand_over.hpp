#pragma once

#include <vector>

#include "broadphase/box_cells.hpp"
#include "geometry/aabb.hpp"

namespace flying {

/// A body that the resting integrator has, as it is when a step begins.
struct Leaning
{
    int body = 0;
    Vec2 position = Vec2::Zero();
    double radius = 0.0; ///< of its bounding circle [m]
    double speed = 0.0;  ///< of its centre [m/s]
    double pull = 0.0;   ///< no less than the field, wherever it may get in a step [m/s^2]
    Aabb way;            ///< holds all of it for a whole step, as it moves now
    bool is_awake = false;
};

/// The rules by which bodies change hands, as functions of where bodies are when a step begins and how fast they move:
/// a body that flies is taken in where it may meet one that leans, and is awake or may be woken, before the step ends;
/// one that bears no load is let go unless one that stays might take it in again.
class HandOver
{
public:
    /// Which of those that lean are connected within a step. To be followed by `reach`.
    void begin(std::vector<Leaning> leaning);
    /// Some that have come since.
    void add(std::vector<Leaning> more);
    /// Where those that are awake, and those that they may wake, can get within so long.  [s]
    void reach(double time);

    /// Whether one of these may get into the box.
    [[nodiscard]] bool is_near(const Aabb& box) const;
    /// Of bodies that could go, those that no other will take in again; ascending.
    /// may_go  of each body
    [[nodiscard]] std::vector<int> may_leave(std::vector<char> may_go) const;

private:
    /// Bodies that may be connected to each other within a step.
    struct Island
    {
        double top_speed = 0.0; // [m/s]
        bool is_awake = false;  // some of them
    };
    [[nodiscard]] int root_of(int k);
    void join(int one, int two);

    std::vector<Leaning> leaning_;
    std::vector<int> parent_;     // of each of these, towards the first that it may be connected to
    std::vector<Island> islands_; // each in the place of its first
    BoxCells ways_;               // of those that were sorted; entries name places in `leaning_`
    int sorted_ = 0;              // how many
    BoxCells reaches_;            // entries name bodies
};

} // namespace flying
