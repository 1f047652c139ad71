#include "siconos.hpp"

// Siconos keeps its laws in an array of Boost's, whose constructor asks std::allocator for a member that C++20 no
// longer has: this is that constructor for the one type that it is used with
#include <memory>

#include <boost/numeric/ublas/storage.hpp>

class NonSmoothLaw;
template <>
inline boost::numeric::ublas::unbounded_array<std::shared_ptr<NonSmoothLaw>>::unbounded_array(
    size_type size, const std::allocator<std::shared_ptr<NonSmoothLaw>>& alloc)
    : alloc_(alloc), size_(size), data_(size ? alloc_.allocate(size) : nullptr)
{
    std::uninitialized_value_construct_n(data_, size);
}

#include <SiconosKernel.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include <Friction_cst.h>
#include <SolverOptions.h>

#include "collide/manifold.hpp"
#include "geometry/half_plane.hpp"
#include "simulators.hpp"
#include "weighed.hpp"

namespace flying::bench {
namespace {

/// Steps of Moreau-Jean weigh the velocities before and after equally: free flight is exact.
constexpr double k_theta = 0.5;
/// A contact whose gap half a step later would be smaller takes part. As it comes this is 0, and a box that rests at a
/// gap of one rounding falls into the floor before it is held.  [m]
constexpr double k_activation = 1e-9;
constexpr int k_most_sweeps = 1000;   // as it comes; Lemke needs fewer pivots
constexpr double k_tolerance = 1e-10; // of the contact problem, relative; as it comes it is 1e-4
constexpr double k_far = 1e9;         // a place or an angle beyond has grown without end [m or rad]

/// (Its own norm passes over what is not a number.)
[[nodiscard]] bool is_near(const SiconosVector& place)
{
    for (unsigned k = 0; k < place.size(); ++k) {
        if (!(std::abs(place.getValue(k)) < k_far)) return false;
    }
    return true;
}

/// What one side of a contact is: a body that moves, or one that doesn't.
struct Side
{
    const SiconosVector* q = nullptr;  ///< place and angle; null where it doesn't move
    Pose fixed;                        ///< of what doesn't move
    std::optional<double> disc_radius; ///< of a disc [m]
    Vec2 local = Vec2::Zero();         ///< the contact point in the body's frame, where it is no disc [m]

    [[nodiscard]] Pose pose() const
    {
        if (!q) return fixed;
        return {Vec2(q->getValue(0), q->getValue(1)), Rotation::of(q->getValue(2))};
    }
    /// The point of the surface, in the world; outwards is the unit vector out of this side.
    [[nodiscard]] Vec2 point(const Vec2& outwards) const
    {
        const Pose at = pose();
        return disc_radius ? Vec2(at.position + *disc_radius * outwards) : at * local;
    }
};

/// Gap and slip at one contact point, as functions of where the two bodies are.
class ContactRelation : public LagrangianScleronomousR
{
public:
    explicit ContactRelation(int bodies) { _jachq = std::make_shared<SimpleMatrix>(2, 3 * bodies); }

    /// Where the two touch now.
    void follow(const Side& a, const Side& b, const Contact& contact, bool edge_is_of_a)
    {
        a_ = a;
        b_ = b;
        edge_is_of_a_ = edge_is_of_a;
        const Pose world_from_a = a.pose();
        const Pose world_from_b = b.pose();
        const auto to_local = [](const Pose& pose, const Vec2& x) { return inverse(pose.rotation) * x; };
        a_.local =
            to_local(world_from_a, contact.point - 0.5 * contact.separation * contact.normal - world_from_a.position);
        b_.local =
            to_local(world_from_b, contact.point + 0.5 * contact.separation * contact.normal - world_from_b.position);
        normal_local_ = to_local(edge_is_of_a ? world_from_a : world_from_b, contact.normal);
    }

    using LagrangianScleronomousR::computeh;
    void computeh(const BlockVector&, BlockVector&, SiconosVector& y) override
    {
        const Vec2 n = normal();
        y.setValue(0, n.dot(b_.point(-n) - a_.point(n)));
        y.setValue(1, 0.0);
    }

    using LagrangianScleronomousR::computeJachq;
    void computeJachq(const BlockVector&, BlockVector&) override
    {
        const Vec2 n = normal();
        const Vec2 point = edge_is_of_a_ ? b_.point(-n) : a_.point(n); // the vertex, or the disc's surface
        int column = 0;
        if (a_.q) set_columns(column, point - a_.pose().position, -n);
        if (a_.q) column += 3;
        if (b_.q) set_columns(column, point - b_.pose().position, n);
    }

private:
    [[nodiscard]] Vec2 normal() const
    {
        if (a_.disc_radius && b_.disc_radius) return (b_.pose().position - a_.pose().position).normalized();
        return (edge_is_of_a_ ? a_ : b_).pose().rotation * normal_local_;
    }
    void set_columns(int first, const Vec2& r, const Vec2& n)
    {
        const Vec2 directions[2] = {n, Vec2(-n.y(), n.x())};
        for (int row = 0; row < 2; ++row) {
            const Vec2& d = directions[row];
            _jachq->setValue(row, first, d.x());
            _jachq->setValue(row, first + 1, d.y());
            _jachq->setValue(row, first + 2, r.x() * d.y() - r.y() * d.x());
        }
    }

    Side a_;
    Side b_;
    Vec2 normal_local_ = Vec2::Zero();
    bool edge_is_of_a_ = false;
};

/// Two bodies, of which the second may be a wall behind the last body, and the features that meet.
using Key = std::tuple<int, int, std::uint32_t>;

struct Link
{
    std::shared_ptr<ContactRelation> relation;
    SP::Interaction interaction;
    bool is_found = false; ///< in this step
};

} // namespace

struct Siconos::Parts : public InteractionManager
{
    std::vector<WeighedBody> bodies; ///< walls follow the scene's
    std::size_t count = 0;           ///< of the scene's
    double hertz = 60.0;
    long steps = 0;
    std::optional<std::string> failure;
    std::vector<std::shared_ptr<LagrangianLinearTIDS>> systems; ///< null where a body doesn't move
    std::shared_ptr<NonSmoothDynamicalSystem> whole;
    std::shared_ptr<TimeStepping> simulation;
    std::map<Key, Link> links;
    std::map<std::pair<double, double>, SP::NonSmoothLaw> laws;

    [[nodiscard]] Side side_of(int k) const
    {
        const WeighedBody& body = bodies[k];
        Side side;
        if (systems[k]) side.q = systems[k]->q().get();
        side.fixed = {body.start.position, Rotation::of(body.start.angle)};
        if (const auto* disc = std::get_if<Disc>(&body.shape)) side.disc_radius = disc->radius;
        return side;
    }

    SP::NonSmoothLaw law_of(int a, int b)
    {
        const double e = std::max(bodies[a].material.restitution, bodies[b].material.restitution);
        const double mu = std::sqrt(bodies[a].material.friction * bodies[b].material.friction);
        SP::NonSmoothLaw& law = laws[{e, mu}];
        if (!law) law = std::make_shared<NewtonImpactFrictionNSL>(e, 0.0, mu, 2);
        return law;
    }

    void find_contacts(int a, int b)
    {
        const Side side_a = side_of(a);
        const Side side_b = side_of(b);
        const double margin = 0.1 * bodies[a].radius;
        const Manifold manifold = make_manifold(bodies[a].shape, side_a.pose(), bodies[b].shape, side_b.pose(), margin);
        for (int k = 0; k < manifold.count; ++k) {
            const Contact& contact = manifold.contacts[k];
            Link& link = links[Key{a, b, contact.feature}];
            link.is_found = true;
            const bool is_new = !link.relation;
            if (is_new) link.relation = std::make_shared<ContactRelation>(systems[a] && systems[b] ? 2 : 1);
            const bool vertex_is_of_b = (contact.feature & 1U) != 0;
            const bool edge_is_of_a = !side_a.disc_radius && (vertex_is_of_b || side_b.disc_radius.has_value());
            link.relation->follow(side_a, side_b, contact, edge_is_of_a);
            if (!is_new) continue;
            link.interaction = std::make_shared<Interaction>(law_of(a, b), link.relation);
            if (systems[a] && systems[b]) whole->link(link.interaction, systems[a], systems[b]);
            else whole->link(link.interaction, systems[a] ? systems[a] : systems[b]);
        }
    }

    /// At the start of each step: which points may touch within it.
    void updateInteractions(SP::Simulation) override
    {
        for (auto& [key, link] : links) link.is_found = false;
        std::vector<std::pair<double, int>> order; // by the left end
        for (int k = 0; k < static_cast<int>(count); ++k) {
            order.emplace_back(side_of(k).pose().position.x() - bodies[k].radius, k);
        }
        std::sort(order.begin(), order.end());
        for (std::size_t i = 0; i < order.size(); ++i) {
            const int a = order[i].second;
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const int b = order[j].second;
                if (order[j].first > order[i].first + 2.2 * bodies[a].radius) break;
                if (systems[a] || systems[b]) find_contacts(std::min(a, b), std::max(a, b));
            }
            for (int wall = static_cast<int>(count); wall < static_cast<int>(bodies.size()); ++wall) {
                if (systems[a]) find_contacts(a, wall);
            }
        }
        for (auto at = links.begin(); at != links.end();) {
            if (at->second.is_found) {
                ++at;
                continue;
            }
            whole->removeInteraction(at->second.interaction);
            at = links.erase(at);
        }
    }
};

Siconos::Siconos(const Scene& scene, double hertz, Solver solver) : parts_(std::make_unique<Parts>())
{
    Parts& parts = *parts_;
    parts.hertz = hertz;
    parts.bodies = weigh(scene);
    parts.count = parts.bodies.size();
    if (scene.world.box) {
        const Material material{scene.world.restitution, scene.world.friction};
        const auto add = [&](const Vec2& normal, double offset) {
            parts.bodies.push_back({HalfPlane{normal, offset}, 0.0, 0.0, 0.0, material, {}, true});
        };
        add({1.0, 0.0}, scene.world.box->min.x());
        add({-1.0, 0.0}, -scene.world.box->max.x());
        add({0.0, 1.0}, scene.world.box->min.y());
        add({0.0, -1.0}, -scene.world.box->max.y());
    }

    parts.whole = std::make_shared<NonSmoothDynamicalSystem>(0.0, 1e6);
    const Vec2 g = uniform_acceleration(scene.world.field);
    for (const WeighedBody& body : parts.bodies) {
        parts.systems.push_back(nullptr);
        if (body.is_static) continue;
        const BodyState& start = body.start;
        const auto vector = [](double x, double y, double angle) {
            auto made = std::make_shared<SiconosVector>(3);
            made->setValue(0, x);
            made->setValue(1, y);
            made->setValue(2, angle);
            return made;
        };
        auto mass = std::make_shared<SimpleMatrix>(3, 3);
        mass->setValue(0, 0, body.mass);
        mass->setValue(1, 1, body.mass);
        mass->setValue(2, 2, body.moment_of_inertia);
        parts.systems.back() =
            std::make_shared<LagrangianLinearTIDS>(vector(start.position.x(), start.position.y(), start.angle),
                                                   vector(start.velocity.x(), start.velocity.y(), start.spin), mass);
        parts.systems.back()->setFExtPtr(vector(body.mass * g.x(), body.mass * g.y(), 0.0));
        parts.whole->insertDynamicalSystem(parts.systems.back());
    }

    const auto integrator = std::make_shared<MoreauJeanOSI>(k_theta);
    integrator->setConstraintActivationThreshold(k_activation);
    const auto problem = std::make_shared<FrictionContact>(2, solver == Solver::sweeps ? SICONOS_FRICTION_2D_NSGS
                                                                                       : SICONOS_FRICTION_2D_LEMKE);
    problem->numericsSolverOptions()->iparam[SICONOS_IPARAM_MAX_ITER] = k_most_sweeps;
    problem->numericsSolverOptions()->dparam[SICONOS_DPARAM_TOL] = k_tolerance;
    parts.simulation = std::make_shared<TimeStepping>(
        parts.whole, std::make_shared<TimeDiscretisation>(0.0, 1.0 / hertz), integrator, problem);
    // Like the other peers it goes on from contacts that it could not solve within its sweeps
    parts.simulation->setCheckSolverFunction([](int, Simulation*) {});
    parts.simulation->setWarnOnNonConvergence(false);
    // The manager is these parts themselves, which own the simulation: it must not own them in turn
    parts.simulation->insertInteractionManager(std::shared_ptr<InteractionManager>(&parts, [](InteractionManager*) {}));
}

Siconos::Siconos(Siconos&&) noexcept = default;
Siconos& Siconos::operator=(Siconos&&) noexcept = default;
Siconos::~Siconos() = default;

void Siconos::advance(double time)
{
    const long until = steps_until(time, parts_->hertz);
    for (; parts_->steps < until && !parts_->failure; ++parts_->steps) {
        try {
            parts_->simulation->computeOneStep();
            // It goes on with gaps that are numbers, and sees to that by an assertion, which would end the program
            for (const auto& system : parts_->systems) {
                if (system && !is_near(*system->q())) throw std::runtime_error("its numbers grew without end");
            }
            parts_->simulation->nextStep();
        } catch (const std::exception& error) {
            parts_->failure = error.what();
        } catch (...) {
            parts_->failure = "it stopped with an error of its own";
        }
    }
}

std::vector<BodyState> Siconos::states() const
{
    std::vector<BodyState> states;
    for (std::size_t k = 0; k < parts_->count; ++k) {
        BodyState state = parts_->bodies[k].start;
        if (const auto& system = parts_->systems[k]) {
            const SiconosVector& q = *system->q();
            const SiconosVector& v = *system->velocity();
            state = {Vec2(q.getValue(0), q.getValue(1)), Vec2(v.getValue(0), v.getValue(1)), q.getValue(2),
                     v.getValue(2), 0.0};
        }
        state.time = static_cast<double>(parts_->steps) / parts_->hertz;
        states.push_back(state);
    }
    return states;
}

std::vector<Load> Siconos::loads() const
{
    std::vector<Load> loads;
    for (const auto& [key, link] : parts_->links) {
        const auto [a, b, feature] = key;
        const int below = b < static_cast<int>(parts_->count) ? a : -1;
        const int above = b < static_cast<int>(parts_->count) ? b : a;
        const double impulse = link.interaction->lambda(1)->getValue(0);
        loads.push_back({below, above, impulse * parts_->hertz});
    }
    return loads;
}

std::optional<std::string> Siconos::failure() const
{
    return parts_->failure;
}

} // namespace flying::bench
