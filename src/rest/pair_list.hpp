#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/box_cells.hpp"
#include "collide/separation.hpp"
#include "geometry/aabb.hpp"
#include "rest/near_points.hpp"
#include "rest/rest_body.hpp"

namespace flying {

/// The points at which two parts touched when they were looked at last, and what these bore.
struct PairLoads
{
    int count = 0;
    std::uint32_t feature[2] = {0, 0};            ///< their names
    Vec2 place[2] = {Vec2::Zero(), Vec2::Zero()}; ///< their places, in the frame of the one of the two that moves [m]
    double normal[2] = {0.0, 0.0};                ///< impulses that lasted to the end of the step [N s]
    double tangent[2] = {0.0, 0.0};               ///< [N s]
};

/// Two convex parts of two bodies that are near each other.
struct RestPair : PairLoads
{
    int a = 0; ///< body, below b
    int b = 0; ///< body
    int part_a = 0;
    int part_b = 0;
    double friction = 0.0;
    double restitution = 0.0;
    NearMemory memory;  ///< of the last look from where the bodies were when a step began
    double shift = 0.0; ///< that the two had made by then, in all [m]
    double turn = 0.0;
};

/// Which pairs may touch soon, kept from step to step. Every body has a box with room to spare, and with the same room
/// the parts of one that is cut have circles; as long as all stay within their boxes, the list stays as it is. Pairs
/// are in the order of (a, b, part of a, part of b).
class PairList
{
public:
    /// reach   how far each body may get in the coming step, whatever it turns or is pushed [m]
    /// radius  of each body's bounding circle; infinite for half-planes [m]
    /// NarrowPhase again only where a body has left its box, or `invalidate` was called. True if it looked.
    bool update(std::span<const RestBody> bodies, std::span<const CollisionShape> shapes,
                std::span<const double> radius, std::span<const double> reach);

    void invalidate() { valid_ = false; }
    /// Pairs of another list, in order, to look for anew with what they remember.
    void remember(std::vector<RestPair> pairs, int bodies);

    [[nodiscard]] std::span<RestPair> pairs() { return pairs_; }
    [[nodiscard]] std::span<const RestPair> pairs() const { return pairs_; }

    /// Where the pairs with a given first body begin; one entry more than there are bodies.
    [[nodiscard]] std::span<const int> starts() const { return starts_; }
    /// The pairs whose second body this is.
    [[nodiscard]] std::span<const int> pairs_of_second(int body) const
    {
        return std::span(by_second_).subspan(second_starts_[body], second_starts_[body + 1] - second_starts_[body]);
    }

private:
    [[nodiscard]] bool all_inside(std::span<const RestBody> bodies, std::span<const double> radius,
                                  std::span<const double> reach) const;
    void find_partners(std::span<const RestBody> bodies);
    void place_parts(std::span<const RestBody> bodies, std::span<const CollisionShape> shapes);
    void find_parts_near(const RestBody& other, double radius, int body, double room, std::vector<int>& parts) const;
    void add_pairs(std::span<const RestBody> bodies, std::span<const double> radius);
    void make_index(int bodies);

    struct Home
    {
        Vec2 position = Vec2::Zero(); ///< where the body was when its box was made
        double angle = 0.0;
        double room = 0.0; ///< by which the box is larger than the body [m]
    };
    /// The circle of a part.
    struct PartCircle
    {
        Vec2 centre = Vec2::Zero(); ///< where it was when its body's box was made
        double radius = 0.0;        ///< [m]
    };
    bool valid_ = false;
    std::vector<Home> homes_;
    std::vector<PartCircle> circles_; // of all parts, body after body
    std::vector<int> first_circle_;   // of each body, and the number of all at the end
    std::vector<Aabb> boxes_;
    BoxCells cells_; // of all that have a box and take part
    std::vector<int> partner_start_;
    std::vector<int> partners_;
    std::vector<std::pair<int, int>> found_;
    std::vector<RestPair> pairs_;
    std::vector<RestPair> old_;
    std::vector<int> near_a_; // circles of the one body that the other may reach
    std::vector<int> near_b_; // and the other way round
    std::vector<int> starts_;
    std::vector<int> second_starts_; // the same in `by_second_`
    std::vector<int> by_second_;     // pairs, by their second body
};

} // namespace flying
