#include <cstdio>
#include <initializer_list>

#include "head_on.hpp"
#include "wrong_corners.hpp"

using namespace flying;

namespace {

/// Two bars as a plus sign, then one of them moved aside.
void cross_bars()
{
    std::printf("bars 4 m by 0.5 m\n  moved by    corners say    intervals say\n");
    for (const double x : {0.0, 1.0, 2.0, 2.25, 2.5}) {
        const Aabb lying = bounding_box(box_of(4.0, 0.5), placed(0.0, 0.0));
        const Aabb standing = bounding_box(box_of(0.5, 4.0), placed(x, 0.0));
        std::printf("%8.2f m %14s %16s\n", x,
                    wrong_overlap(lying, standing) ? "overlap" : "apart",
                    overlap(lying, standing) ? "overlap" : "apart");
    }
}

/// Two squares head on, one of them a little higher, for two seconds.
void meet_head_on()
{
    std::printf(
        "\nsquares of 1 m, head on\n   higher by   nearest edge   greatest separation\n");
    for (const double higher : {0.0, 0.01, 0.1, 0.5}) {
        std::printf("%10.2f m", higher);
        for (const Rule rule : {Rule::nearest_edge, Rule::greatest_separation}) {
            HeadOn meeting;
            meeting.pose_b.position.y() = higher;
            for (int k = 0; k < 120; ++k) meeting.step(rule, 1.0 / 60.0);
            const bool passed = meeting.pose_a.position.x() > meeting.pose_b.position.x();
            std::printf(rule == Rule::nearest_edge ? " %14s" : " %21s",
                        passed ? "pass through" : "bounce");
        }
        std::printf("\n");
    }
}

} // namespace


int main()
{
    cross_bars();
    meet_head_on();
}

