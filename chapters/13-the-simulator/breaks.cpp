#include <cstdio>

#include "runs.hpp"

using namespace flying;

namespace {

// [simulator.breaks.saved]
/// A minute of the original's scene, stopped after ten seconds and gone on with.
void stop_and_go_on()
{
    const Scene scene = scene_of_course(FLYING_SCENES, "original-polygons");
    World whole = start(scene);
    go(whole, 10.0);
    World saved = resumed(whole);
    World by_6 = start(as_it_looks(whole, 6));
    World by_17 = start(as_it_looks(whole, 17));
    std::printf("%26s %15s %15s\n", "apart after", "by eye", "by eye");
    std::printf("%12s %13s %15s %15s\n", "going on for", "snapshot", "6 digits",
                "17 digits");
    for (const double more : {1.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0}) {
        go(whole, 10.0 + more);
        go(saved, 10.0 + more);
        go(by_6, more);
        go(by_17, more);
        std::printf("%10.0f s %11.0e m %13.0e m %13.0e m\n", more, apart(whole, saved),
                    apart(whole, by_6), apart(whole, by_17));
    }
}
// [simulator.breaks.saved]

// [simulator.breaks.frames]
/// The same rain on machines that show it at different rates: where a step is a frame,
/// and where it is not.
void look_more_often()
{
    std::printf("\n%10s %24s %24s\n", "frames/s", "step = frame", "step = 1/60 s");
    for (const int rate : {30, 60, 75, 144}) {
        WorldOptions frame;
        frame.step = 1.0 / rate;
        World stepped = start(rain(24, 5), frame);
        World asked = start(rain(24, 5));
        for (int k = 1; k <= 12 * rate; ++k) {
            go(stepped, static_cast<double>(k) / rate);
            go(asked, static_cast<double>(k) / rate);
        }
        std::printf("%10d %24llx %24llx\n", rate,
                    static_cast<unsigned long long>(stepped.report().hash),
                    static_cast<unsigned long long>(asked.report().hash));
    }
}
// [simulator.breaks.frames]

} // namespace

// [simulator.breaks]
int main()
{
    stop_and_go_on();
    look_more_often();
}
// [simulator.breaks]
