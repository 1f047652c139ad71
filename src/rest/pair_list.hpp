#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/box_cells.hpp"
#include "collide/separation.hpp"
#include "geometry/aabb.hpp"
#include "rest/body_set.hpp"
#include "rest/near_points.hpp"
#include "rest/rest_bodies.hpp"

namespace flying {

/// The points at which two parts touched when they were looked at last, and what these bore.
struct PairLoads
{
    int count = 0;
    std::uint32_t feature[2] = {0, 0};            ///< their names
    Vec2 place[2] = {Vec2::Zero(), Vec2::Zero()}; ///< their places, in the frame of the one of the two that moves [m]
    double normal[2] = {0.0, 0.0};                ///< impulses at the end of the step, for a whole one [N s]
    double tangent[2] = {0.0, 0.0};               ///< [N s]
};

/// What the last look at two parts has found when a step, or a part of one, began and neither of the bodies had any
/// motion. As long as that is so, neither was put elsewhere, and the margin is the same, another look finds the same.
/// (Of what passes them, neighbours may hide points that lie flush with theirs.)
struct LastLook
{
    std::int64_t moves = -1; ///< of both bodies by then, in all; -1 where they had motion
    double margin = 0.0;     ///< [m]
    Manifold manifold;
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
    LastLook last_look;
};

/// A body, and where it is or will be.
struct BodyPose
{
    int body = -1;
    Pose pose;
};

/// How far bodies get.
struct PairReach
{
    std::span<const double>
        farthest; ///< of each, in the coming step or in what is foreseen, whatever turns or pushes it [m]
    std::span<const double> usual; ///< in a step: a box that is made anew has room for several of these [m]
};

/// The boxes of two bodies, with room for how far they get, overlap. Of two that do a list holds the pair if it was
/// updated for that; of others it depends on when its boxes were made.
/// farthest  of each body [m]
[[nodiscard]] bool may_meet(const RestBodies& bodies, int a, int b, std::span<const double> farthest);

/// Which pairs may touch soon, kept from step to step. Every body has a box with room to spare, and with the same room
/// the parts of one that is cut have circles; as long as all stay within their boxes, the list stays as it is. Pairs
/// are in the order of (a, b, part of a, part of b), and those of which no body is awake lie apart: a step doesn't
/// touch them.
class PairList
{
public:
    /// awake  as `separate` was told last
    /// Searches again only where a body that is awake has left its box, or `invalidate` was called, and then only for
    /// the pairs of those that are awake. How many boxes it sorted for that; 0 where it didn't search.
    int update(const RestBodies& bodies, const PairReach& reach, const BodySet& awake);

    /// Pairs of the parts of some bodies, wherever they are by now, that may touch each other, or those of another
    /// body: on the list or not. All others are within the boxes that they had when it was made.
    [[nodiscard]] std::vector<RestPair> pairs_at(std::span<const BodyPose> placed, const RestBodies& bodies) const;

    /// Some body that is awake, or no longer takes part, was put elsewhere.
    void invalidate() { is_valid_ = false; }
    /// Others are awake now, or take part.
    void separate(const RestBodies& bodies, const BodySet& awake);
    /// Pairs of another list, in order, to search for anew with what they remember.
    void remember(std::vector<RestPair> pairs, const RestBodies& bodies, const BodySet& awake);

    /// Those of which a body is awake.
    [[nodiscard]] std::span<RestPair> pairs() { return awake_.pairs; }
    [[nodiscard]] std::span<const RestPair> pairs() const { return awake_.pairs; }
    /// The others.
    [[nodiscard]] std::span<const RestPair> pairs_asleep() const { return asleep_.pairs; }
    /// All of them, in order.
    [[nodiscard]] std::vector<RestPair> all() const;

    /// Whether is(other) holds of any body with which a body has pairs.
    template <typename Is>
    [[nodiscard]] bool any_beside(int body, const Is& is) const
    {
        if (body >= static_cast<int>(awake_.firsts.size())) return false;
        for (const Pairs* list : {&awake_, &asleep_}) {
            const RestPair* const end = list->pairs.data() + list->pairs.size();
            const RestPair* pair = list->firsts[body] >= 0 ? &list->pairs[list->firsts[body]] : end;
            for (; pair != end && pair->a == body; ++pair) {
                if (is(pair->b)) return true;
            }
            for (int k = list->seconds[body]; k >= 0; k = list->next_of_second[k]) {
                if (is(list->pairs[k].a)) return true;
            }
        }
        return false;
    }
    /// Call visit(pairs) for every other body with which a body has pairs, with all of those: first where it is the
    /// first of two, each time in order.
    template <typename Visit>
    void for_each_of(int body, Visit&& visit) const
    {
        if (body >= static_cast<int>(awake_.firsts.size())) return;
        for (int k = awake_.firsts[body], m = asleep_.firsts[body]; k >= 0 || m >= 0;) {
            const bool is_next = m < 0 || (k >= 0 && awake_.pairs[k].b < asleep_.pairs[m].b);
            visit(is_next ? awake_.of_two(k) : asleep_.of_two(m));
            if (is_next) k = awake_.next_of_first(k);
            else m = asleep_.next_of_first(m);
        }
        for (int k = awake_.seconds[body], m = asleep_.seconds[body]; k >= 0 || m >= 0;) {
            const bool is_next = m < 0 || (k >= 0 && awake_.pairs[k].a < asleep_.pairs[m].a);
            visit(is_next ? awake_.of_two(k) : asleep_.of_two(m));
            if (is_next) k = awake_.next_of_second[k];
            else m = asleep_.next_of_second[m];
        }
    }

private:
    /// Pairs in order, and where to find those of a body: those of the same two stand together.
    struct Pairs
    {
        std::vector<RestPair> pairs;
        std::vector<int> firsts;         // of each body, its first pair as the first of two; -1 for none
        std::vector<int> seconds;        // the same as the second of two
        std::vector<int> ends;           // of each pair, the number after the last one of its two bodies
        std::vector<int> next_of_second; // of each pair, the next with the same second body and another first; or -1

        void clear_index(int bodies);
        void make_index();
        [[nodiscard]] std::span<const RestPair> of_two(int pair) const
        {
            return std::span(pairs).subspan(pair, ends[pair] - pair);
        }
        [[nodiscard]] int next_of_first(int pair) const
        {
            const int next = ends[pair];
            return next < static_cast<int>(pairs.size()) && pairs[next].a == pairs[pair].a ? next : -1;
        }
    };
    struct Home
    {
        Vec2 position = Vec2::Zero(); ///< where the body was when its box was made
        double angle = 0.0;
        double room = 0.0; ///< that the body has in its box [m]
    };

    /// The circle of a part.
    struct PartCircle
    {
        Vec2 centre = Vec2::Zero();
        double radius = 0.0; ///< [m]
    };

    [[nodiscard]] static bool are_near(const PartCircle& a, const PartCircle& b, double room)
    {
        const double clear = a.radius + b.radius + room;
        return (b.centre - a.centre).squaredNorm() <= clear * clear;
    }
    [[nodiscard]] bool all_inside(const RestBodies& bodies, std::span<const double> farthest,
                                  const BodySet& awake) const;
    void search_all(const RestBodies& bodies, const PairReach& reach);
    void search(const RestBodies& bodies, const PairReach& reach, const BodySet& movers);
    void make_box(const RestBodies& bodies, int k, double room);
    void put_circles(const RestBodies& bodies, int k, const Pose& pose, std::vector<PartCircle>& circles) const;
    void sort_others(const RestBodies& bodies, const BodySet& movers);
    void find_partners(const RestBodies& bodies, const BodySet& movers);
    void find_partners_among(const BoxCells& others, const BoxCells::Entry& entry, const RestBodies& bodies,
                             const BodySet& movers, std::vector<std::pair<int, int>>& found) const;
    void find_parts_near(const RestBodies& bodies, int other, int body, double room, std::vector<int>& parts) const;
    void add_pairs(const RestBodies& bodies);

    bool is_valid_ = false;
    bool is_new_ = true; // nothing was searched for yet, or what was is forgotten
    std::vector<Home> homes_;
    std::vector<PartCircle> circles_; // of all parts, body after body, where they were when its box was made
    std::vector<int> first_circle_;   // of each body, and the number of all at the end
    std::vector<Aabb> boxes_;
    BoxCells cells_;            // of those that the last search was for
    BoxCells others_;           // of those that it wasn't for, as far as they take part; may hold some that it was for
    std::vector<int> searched_; // those that the last search was for
    std::vector<int> walls_;    // half-planes
    std::vector<std::pair<int, int>> found_;
    Pairs awake_;
    Pairs asleep_;
    std::vector<RestPair> old_;
    std::vector<int> near_a_; // circles of the one body that the other may reach
    std::vector<int> near_b_; // and the other way round
    int boxes_sorted_ = 0;    // in a search
};

} // namespace flying
