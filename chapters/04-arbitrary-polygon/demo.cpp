#include <cstdio>
#include <string>
#include <vector>

#include "geometry/moments.hpp"
#include "mass/polygon.hpp"
#include "outlines.hpp"
#include "wrong_polygon.hpp"

using namespace flying;
using namespace flying::outlines;

namespace {


/// One line of the table. The outer ring comes first, holes turn the other way.
void print_row(const char* name, const std::vector<Ring>& rings)
{
    const Polygon polygon(rings);
    const AreaMoments moments = moments_of(polygon);
    const Vec2 mean = vertex_mean(polygon.vertices());
    std::printf("%-18s %6.0f %7.2f %6.2f %7.2f %6.2f %10.0f\n", name, moments.area,
                moments.centroid.x(), moments.centroid.y(), mean.x(), mean.y(),
                moments.second_moment);
}



/// The house, further and further from the origin.
void move_house()
{
    std::printf("\nhouse moved by         second moment       about the origin\n");
    for (const double far : {0.0, 1e3, 1e5, 1e7, 1e9}) {
        const Ring ring = moved(house(), Vec2(far, far));
        std::printf("%13g cm %21.6f %22.6g\n", far, moments_of_ring(ring).second_moment,
                    moments_about_origin(ring).second_moment);
    }
}


} // namespace

int main()
{
    std::printf("in cm                area    centroid     mean of corners   moment\n");
    print_row("square", {square(Vec2(0, 0), 80)});
    print_row("house", {house()});
    print_row("horseshoe", {horseshoe()});
    print_row("dumbbell", {dumbbell()});
    print_row("dumbbell, 4 more", {with_corners(dumbbell(), 9, 4)});
    print_row("square with a hole",
              {square(Vec2(0, 0), 80), reversed(square(Vec2(10, 0), 40))});
    move_house();

    const MassProperties body = polygon_mass(Polygon({dumbbell()}), 0.001);
    std::printf("\ndumbbell of 1 g per cm^2: mass = %.3f kg\n", body.mass);
    std::printf("moment of inertia = %.3f kg cm^2\n", body.moment_of_inertia);
}
