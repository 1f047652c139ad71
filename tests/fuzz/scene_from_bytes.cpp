#include "fuzz/scene_from_bytes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace flying::fuzz {

namespace {

/// Takes numbers off the front of the bytes; zeros when they are at their end.
class Bytes
{
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : left_(bytes) {}

    [[nodiscard]] bool is_empty() const { return left_.empty(); }

    int byte()
    {
        if (left_.empty()) return 0;
        const int value = left_.front();
        left_ = left_.subspan(1);
        return value;
    }
    /// 0 ... count - 1
    int below(int count) { return byte() % count; }
    /// In 65536 steps, both ends possible.
    double between(double low, double high)
    {
        const int value = 256 * byte();
        return low + (high - low) * (value + byte()) / 65535.0;
    }
    template <std::size_t N>
    double one_of(const std::array<double, N>& values)
    {
        return values[static_cast<std::size_t>(below(static_cast<int>(N)))];
    }
    Vec2 vector(double most) { return {between(-most, most), between(-most, most)}; }

private:
    std::span<const std::uint8_t> left_;
};

constexpr std::array k_restitutions = {1.0, 0.0, 0.5, 0.9, 0.1};
constexpr std::array k_frictions = {0.0, 0.3, 0.5, 1.0, 10.0};

Field take_field(Bytes& bytes)
{
    switch (bytes.below(4)) {
    case 0:
        return NoField{};
    case 1:
        return UniformField{{0.0, -9.81}};
    case 2:
        return UniformField{bytes.vector(20.0)};
    default:
        return CentralField{bytes.vector(2.0), bytes.between(1.0, 100.0), bytes.below(2) * 0.5};
    }
}

ShapeDef take_shape(Bytes& bytes)
{
    const double size = std::ldexp(1.0 + bytes.byte() / 256.0, bytes.below(6) - 4);
    switch (bytes.below(7)) {
    case 0:
        return DiscDef{size};
    case 1:
        return SquareDef{size};
    case 2:
        return RectangleDef{size, size * bytes.between(0.01, 4.0)};
    case 3:
        return TriangleDef{{size, size * bytes.between(0.1, 2.0)}, bytes.between(0.05, 3.0)};
    case 4:
        return RegularDef{3 + bytes.below(10), size};
    default:
        break;
    }

    // Corners round about the centre, as far out as the bytes say; or anywhere
    PolygonDef polygon;
    const bool is_anywhere = bytes.below(4) == 0;
    const int count = 3 + bytes.below(8);
    for (int k = 0; k < count; ++k) {
        const double turn = 2.0 * std::numbers::pi * k / count;
        const Vec2 out(std::cos(turn), std::sin(turn));
        polygon.vertices.push_back(is_anywhere ? bytes.vector(size) : Vec2(size * bytes.between(0.05, 1.0) * out));
    }
    if (bytes.below(8) == 0) polygon.holes.push_back({{0.0, 0.0}, {0.05 * size, 0.0}, {0.0, 0.05 * size}});
    return polygon;
}

/// Half of a body's height where it stands upright; 0 where it has no flat side below.
double half_height(const ShapeDef& shape)
{
    if (const auto* disc = std::get_if<DiscDef>(&shape)) return disc->radius;
    if (const auto* square = std::get_if<SquareDef>(&shape)) return 0.5 * square->side;
    if (const auto* rectangle = std::get_if<RectangleDef>(&shape)) return 0.5 * rectangle->height;
    return 0.0;
}

BodyDef take_body(Bytes& bytes, const Scene& scene)
{
    BodyDef body;
    body.shape = take_shape(bytes);
    const int place = bytes.below(4);
    body.position = bytes.vector(4.5);
    if (bytes.below(2) == 1) body.angle = bytes.between(-4.0, 4.0);

    // Upon the one before, or on the floor, to the bit
    if (place == 1 && !scene.bodies.empty() && body.angle == 0.0) {
        const BodyDef& below = scene.bodies.back();
        body.position =
            below.position + Vec2(bytes.between(-0.5, 0.5), half_height(below.shape) + half_height(body.shape));
    }
    if (place == 2) body.position.y() = half_height(body.shape) - 5.0;

    body.is_static = bytes.below(6) == 5;
    if (!body.is_static) {
        const double speed = bytes.one_of(std::array{0.0, 1.0, 10.0, 100.0});
        body.velocity = bytes.vector(speed);
        body.spin = bytes.between(-1.0, 1.0) * speed;
        body.density = std::ldexp(1.0, 2 * bytes.below(12) - 11);
    }
    if (bytes.below(4) == 3) body.restitution = bytes.one_of(k_restitutions);
    if (bytes.below(4) == 3) body.friction = bytes.one_of(k_frictions);
    return body;
}

} // namespace

Trial trial_from_bytes(std::span<const std::uint8_t> given)
{
    Bytes bytes(given);
    Trial trial;
    Scene& scene = trial.scene;
    scene.title = "from bytes";
    scene.world.field = take_field(bytes);
    scene.world.restitution = bytes.one_of(k_restitutions);
    scene.world.friction = bytes.one_of(k_frictions);
    if (bytes.below(4) != 3) scene.world.box = BoxDef{{-5.0, -5.0}, {5.0, 5.0}};
    scene.until = bytes.one_of(std::array{0.5, 1.0, 2.0});
    constexpr std::array k_engines = {EngineChoice::automatic, EngineChoice::events, EngineChoice::rest};
    trial.options.engine = k_engines[static_cast<std::size_t>(bytes.below(3))];
    trial.options.step = bytes.one_of(std::array{1.0 / 60.0, 1.0 / 240.0, 1.0 / 30.0});
    constexpr std::size_t k_most_bodies = 8;
    do scene.bodies.push_back(take_body(bytes, scene));
    while (!bytes.is_empty() && scene.bodies.size() < k_most_bodies);
    return trial;
}

} // namespace flying::fuzz
