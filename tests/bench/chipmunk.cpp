#include <chipmunk/chipmunk.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "collide/separation.hpp"
#include "simulators.hpp"
#include "weighed.hpp"

namespace flying::bench {

struct Chipmunk::Parts
{
    cpSpace* space = cpSpaceNew();
    std::vector<cpBody*> bodies;
    std::vector<cpShape*> shapes;
    double hertz = 60.0;
    long steps = 0;
    std::optional<CentralField> centre;

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts()
    {
        for (cpShape* shape : shapes) {
            cpSpaceRemoveShape(space, shape);
            cpShapeFree(shape);
        }
        for (cpBody* body : bodies) {
            cpSpaceRemoveBody(space, body);
            cpBodyFree(body);
        }
        cpSpaceFree(space);
    }

    void add(cpShape* shape, const Material& material)
    {
        // It multiplies both materials: roots make the pair's what ours is for equal ones
        cpShapeSetElasticity(shape, std::sqrt(material.restitution));
        cpShapeSetFriction(shape, std::sqrt(material.friction));
        cpSpaceAddShape(space, shape);
        shapes.push_back(shape);
    }
};

namespace {

cpVect vect(const Vec2& a)
{
    return cpv(a.x(), a.y());
}

cpShape* part_shape(cpBody* body, const Shape& part)
{
    if (const auto* disc = std::get_if<Disc>(&part)) return cpCircleShapeNew(body, disc->radius, cpvzero);
    std::vector<cpVect> corners;
    for (const Vec2& vertex : std::get<Polygon>(part).vertices()) corners.push_back(vect(vertex));
    return cpPolyShapeNewRaw(body, static_cast<int>(corners.size()), corners.data(), 0.0);
}

bool has_mixed_restitution(const Scene& scene)
{
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodyDef& body) {
        return body.restitution && *body.restitution != scene.world.restitution;
    });
}

/// As its own demonstration of planets has it: the pull where the body is now, in place of gravity.
void pull_to_centre(cpBody* body, cpVect, cpFloat damping, cpFloat step)
{
    const auto* centre = static_cast<const CentralField*>(cpBodyGetUserData(body));
    const cpVect x = cpBodyGetPosition(body);
    cpBodyUpdateVelocity(body, vect(acceleration_at(*centre, Vec2(x.x, x.y))), damping, step);
}

/// Ours, and Box2D's: of two bodies the larger restitution counts.
cpBool take_larger_restitution(cpArbiter* arbiter, cpSpace*, cpDataPointer)
{
    cpShape* a = nullptr;
    cpShape* b = nullptr;
    cpArbiterGetShapes(arbiter, &a, &b);
    const double root = std::max(cpShapeGetElasticity(a), cpShapeGetElasticity(b));
    cpArbiterSetRestitution(arbiter, root * root);
    return cpTrue;
}

} // namespace

Chipmunk::Chipmunk(const Scene& scene, double hertz, int effort) : parts_(std::make_unique<Parts>())
{
    parts_->hertz = hertz;
    if (const auto* centre = std::get_if<CentralField>(&scene.world.field)) parts_->centre = *centre;
    if (has_mixed_restitution(scene)) {
        cpSpaceAddDefaultCollisionHandler(parts_->space)->preSolveFunc = take_larger_restitution;
    }
    cpSpace* space = parts_->space;
    cpSpaceSetIterations(space, 10 * effort);
    cpSpaceSetDamping(space, 1.0);
    cpSpaceSetSleepTimeThreshold(space, std::numeric_limits<double>::infinity());
    cpSpaceSetGravity(space, vect(uniform_acceleration(scene.world.field)));

    for (const WeighedBody& from : weigh(scene)) {
        cpBody* body = from.is_static ? cpBodyNewStatic() : cpBodyNew(from.mass, from.moment_of_inertia);
        cpBodySetPosition(body, vect(from.start.position));
        cpBodySetAngle(body, from.start.angle);
        if (!from.is_static) {
            cpBodySetVelocity(body, vect(from.start.velocity));
            cpBodySetAngularVelocity(body, from.start.spin);
        }
        cpSpaceAddBody(space, body);
        parts_->bodies.push_back(body);
        if (parts_->centre) {
            cpBodySetUserData(body, &*parts_->centre);
            cpBodySetVelocityUpdateFunc(body, pull_to_centre);
        }
        for (const ConvexPart& part : make_collision_shape(from.shape).parts) {
            parts_->add(part_shape(body, part.shape), from.material);
        }
    }
    if (!scene.world.box) return;

    // Rods whose inner side is the wall
    const Material material{scene.world.restitution, scene.world.friction};
    const Vec2 low = scene.world.box->min - Vec2::Constant(0.5 * k_wall);
    const Vec2 high = scene.world.box->max + Vec2::Constant(0.5 * k_wall);
    const cpVect corners[4] = {cpv(low.x(), low.y()), cpv(high.x(), low.y()), cpv(high.x(), high.y()),
                               cpv(low.x(), high.y())};
    cpBody* ground = cpSpaceGetStaticBody(space);
    for (int k = 0; k < 4; ++k) {
        parts_->add(cpSegmentShapeNew(ground, corners[k], corners[(k + 1) % 4], 0.5 * k_wall), material);
    }
}

Chipmunk::Chipmunk(Chipmunk&&) noexcept = default;
Chipmunk& Chipmunk::operator=(Chipmunk&&) noexcept = default;
Chipmunk::~Chipmunk() = default;

void Chipmunk::advance(double time)
{
    const long until = steps_until(time, parts_->hertz);
    for (; parts_->steps < until; ++parts_->steps) {
        cpSpaceStep(parts_->space, 1.0 / parts_->hertz);
    }
}

std::vector<Load> Chipmunk::loads() const
{
    // Each body tells of all that it touches: of two bodies the one of the lower number does
    struct Listing
    {
        const Parts* parts;
        int self;
        std::vector<Load> loads;
    } listing{parts_.get(), 0, {}};
    const auto note = [](cpBody* self, cpArbiter* arbiter, void* data) {
        auto& into = *static_cast<Listing*>(data);
        cpBody* a = nullptr;
        cpBody* b = nullptr;
        cpArbiterGetBodies(arbiter, &a, &b);
        const auto& bodies = into.parts->bodies;
        const auto found = std::find(bodies.begin(), bodies.end(), a == self ? b : a);
        const int other = found == bodies.end() ? -1 : static_cast<int>(found - bodies.begin());
        if (other >= 0 && other < into.self) return;
        const double impulse = std::abs(cpvdot(cpArbiterTotalImpulse(arbiter), cpArbiterGetNormal(arbiter)));
        into.loads.push_back({std::min(into.self, other), std::max(into.self, other), impulse * into.parts->hertz});
    };
    for (; listing.self < static_cast<int>(parts_->bodies.size()); ++listing.self) {
        cpBodyEachArbiter(parts_->bodies[listing.self], note, &listing);
    }
    return listing.loads;
}

std::vector<BodyState> Chipmunk::states() const
{
    std::vector<BodyState> states;
    for (cpBody* body : parts_->bodies) {
        const cpVect x = cpBodyGetPosition(body);
        const cpVect v = cpBodyGetVelocity(body);
        states.push_back({Vec2(x.x, x.y), Vec2(v.x, v.y), cpBodyGetAngle(body), cpBodyGetAngularVelocity(body),
                          static_cast<double>(parts_->steps) / parts_->hertz});
    }
    return states;
}

} // namespace flying::bench
