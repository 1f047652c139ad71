#include <box2d/box2d.h>

#include <algorithm>

#include "collide/separation.hpp"
#include "simulators.hpp"
#include "weighed.hpp"

namespace flying::bench {

struct Box2d::Parts
{
    b2World world{b2Vec2(0.0f, 0.0f)};
    std::vector<b2Body*> bodies;
    double hertz = 60.0;
    long steps = 0;
    int effort = 1;
    std::vector<double> masses;
    std::optional<CentralField> centre;
};

namespace {

b2Vec2 vect(const Vec2& a)
{
    return b2Vec2(static_cast<float>(a.x()), static_cast<float>(a.y()));
}

b2FixtureDef fixture_of(const b2Shape& shape, const Material& material)
{
    b2FixtureDef def;
    def.shape = &shape;
    def.density = 1.0f;
    def.restitution = static_cast<float>(material.restitution);
    def.restitutionThreshold = 0.0f;
    def.friction = static_cast<float>(material.friction);
    return def;
}

void add_part(b2Body* body, const Shape& part, const Material& material)
{
    if (const auto* disc = std::get_if<Disc>(&part)) {
        b2CircleShape circle;
        circle.m_radius = static_cast<float>(disc->radius);
        const b2FixtureDef def = fixture_of(circle, material);
        body->CreateFixture(&def);
        return;
    }
    // Fans of eight corners: it takes no more
    const std::span<const Vec2> vertices = std::get<Polygon>(part).vertices();
    const std::size_t most = b2_maxPolygonVertices;
    for (std::size_t first = 1; first + 1 < vertices.size(); first += most - 2) {
        std::vector<b2Vec2> corners = {vect(vertices[0])};
        for (std::size_t k = first; k < std::min(first + most - 1, vertices.size()); ++k) {
            corners.push_back(vect(vertices[k]));
        }
        b2PolygonShape polygon;
        polygon.Set(corners.data(), static_cast<int>(corners.size()));
        const b2FixtureDef def = fixture_of(polygon, material);
        body->CreateFixture(&def);
    }
}

} // namespace

Box2d::Box2d(const Scene& scene, double hertz, int effort) : parts_(std::make_unique<Parts>())
{
    parts_->hertz = hertz;
    parts_->effort = effort;
    if (const auto* centre = std::get_if<CentralField>(&scene.world.field)) parts_->centre = *centre;
    parts_->world.SetGravity(vect(uniform_acceleration(scene.world.field)));
    parts_->world.SetAllowSleeping(false);

    for (const WeighedBody& from : weigh(scene)) {
        b2BodyDef def;
        def.type = from.is_static ? b2_staticBody : b2_dynamicBody;
        def.position = vect(from.start.position);
        def.angle = static_cast<float>(from.start.angle);
        def.linearVelocity = vect(from.start.velocity);
        def.angularVelocity = static_cast<float>(from.start.spin);
        def.allowSleep = false;
        def.userData.pointer = parts_->bodies.size() + 1; // 0: the walls
        b2Body* body = parts_->world.CreateBody(&def);
        parts_->bodies.push_back(body);
        parts_->masses.push_back(from.mass);
        for (const ConvexPart& part : make_collision_shape(from.shape).parts) {
            add_part(body, part.shape, from.material);
        }
        b2MassData mass;
        mass.mass = static_cast<float>(from.mass);
        mass.center.SetZero();
        mass.I = static_cast<float>(from.moment_of_inertia);
        if (!from.is_static) body->SetMassData(&mass);
    }
    if (!scene.world.box) return;

    // Thick bars whose inner side is the wall
    const Material material{scene.world.restitution, scene.world.friction};
    const Vec2 low = scene.world.box->min;
    const Vec2 high = scene.world.box->max;
    const Vec2 middle = 0.5 * (low + high);
    const Vec2 half = 0.5 * (high - low) + Vec2::Constant(k_wall);
    b2BodyDef ground_def;
    b2Body* ground = parts_->world.CreateBody(&ground_def);
    const auto bar = [&](double half_width, double half_height, const Vec2& centre) {
        b2PolygonShape box;
        box.SetAsBox(static_cast<float>(half_width), static_cast<float>(half_height), vect(centre), 0.0f);
        const b2FixtureDef def = fixture_of(box, material);
        ground->CreateFixture(&def);
    };
    const double thick = 0.5 * k_wall;
    bar(half.x(), thick, Vec2(middle.x(), low.y() - thick));
    bar(half.x(), thick, Vec2(middle.x(), high.y() + thick));
    bar(thick, half.y(), Vec2(low.x() - thick, middle.y()));
    bar(thick, half.y(), Vec2(high.x() + thick, middle.y()));
}

Box2d::Box2d(Box2d&&) noexcept = default;
Box2d& Box2d::operator=(Box2d&&) noexcept = default;
Box2d::~Box2d() = default;

void Box2d::advance(double time)
{
    const long until = steps_until(time, parts_->hertz);
    const auto step = static_cast<float>(1.0 / parts_->hertz);
    for (; parts_->steps < until; ++parts_->steps) {
        for (std::size_t k = 0; parts_->centre && k < parts_->bodies.size(); ++k) {
            b2Body* body = parts_->bodies[k];
            const Vec2 place(body->GetPosition().x, body->GetPosition().y);
            body->ApplyForceToCenter(vect(parts_->masses[k] * acceleration_at(*parts_->centre, place)), true);
        }
        parts_->world.Step(step, 8 * parts_->effort, 3 * parts_->effort);
    }
}

std::vector<Load> Box2d::loads() const
{
    std::vector<Load> loads;
    for (const b2Contact* contact = parts_->world.GetContactList(); contact; contact = contact->GetNext()) {
        if (!contact->IsTouching()) continue;
        const auto number = [](const b2Fixture* fixture) {
            return static_cast<int>(const_cast<b2Fixture*>(fixture)->GetBody()->GetUserData().pointer) - 1;
        };
        const int a = number(contact->GetFixtureA());
        const int b = number(contact->GetFixtureB());
        const b2Manifold* manifold = contact->GetManifold();
        double impulse = 0.0;
        for (int k = 0; k < manifold->pointCount; ++k) impulse += manifold->points[k].normalImpulse;
        loads.push_back({std::min(a, b), std::max(a, b), impulse * parts_->hertz});
    }
    return loads;
}

std::vector<BodyState> Box2d::states() const
{
    std::vector<BodyState> states;
    for (const b2Body* body : parts_->bodies) {
        const b2Vec2 x = body->GetPosition();
        const b2Vec2 v = body->GetLinearVelocity();
        states.push_back({Vec2(x.x, x.y), Vec2(v.x, v.y), body->GetAngle(), body->GetAngularVelocity(),
                          static_cast<double>(parts_->steps) / parts_->hertz});
    }
    return states;
}

} // namespace flying::bench
