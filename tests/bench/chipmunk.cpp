#include <chipmunk/chipmunk.h>

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

} // namespace

Chipmunk::Chipmunk(const Scene& scene, double hertz) : parts_(std::make_unique<Parts>())
{
    parts_->hertz = hertz;
    cpSpace* space = parts_->space;
    cpSpaceSetIterations(space, 10);
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
    for (; parts_->steps < until; ++parts_->steps) cpSpaceStep(parts_->space, 1.0 / parts_->hertz);
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
