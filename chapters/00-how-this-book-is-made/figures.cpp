#include <fstream>
#include <string>

#include "falling.hpp"

namespace {

constexpr double k_g = 9.81;
constexpr double k_time = 2.0;
constexpr double k_width = 560.0;
constexpr double k_height = 300.0;

double x_of(double t)
{
    return 56.0 + (k_width - 84.0) * t / k_time;
}
double y_of(double s)
{
    return 24.0 + (k_height - 72.0) * s / flying::fall_distance(k_g, k_time);
}

std::string point(double t, double s)
{
    return std::to_string(x_of(t)) + "," + std::to_string(y_of(s)) + " ";
}

std::string label(double x, double y, const std::string& text)
{
    return "<text x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\">" + text + "</text>\n";
}

/// Distance fallen over time: the parabola, and four steps that follow it from behind.
void draw_steps(const std::string& folder)
{
    std::ofstream svg(folder + "/steps.svg");
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 560 282\" width=\"560\" font-family=\"sans-serif\" "
           "font-size=\"14\" fill=\"#333\">\n";
    svg << "<path d=\"M56,24 V" << y_of(flying::fall_distance(k_g, k_time)) + 12
        << " M56,24 H548\" stroke=\"#999\"/>\n";
    std::string curve;
    for (int k = 0; k <= 100; ++k) curve += point(k_time * k / 100, flying::fall_distance(k_g, k_time * k / 100));
    std::string steps;
    std::string dots;
    for (int k = 0; k <= 4; ++k) {
        const double t = k_time * k / 4;
        const double s = k == 0 ? 0.0 : flying::fall_by_steps(k_g, t, k);
        steps += point(t, s);
        dots += "<circle cx=\"" + std::to_string(x_of(t)) + "\" cy=\"" + std::to_string(y_of(s)) + "\" r=\"4.5\"/>";
    }
    svg << "<polyline points=\"" << curve << "\" fill=\"none\" stroke=\"#1f6fb4\" stroke-width=\"2.5\"/>\n";
    svg << "<polyline points=\"" << steps << "\" fill=\"none\" stroke=\"#c8501e\" stroke-width=\"2.5\"/>\n";
    svg << "<g fill=\"#c8501e\">" << dots << "</g>\n";
    svg << label(500, 17, "time") << label(64, y_of(flying::fall_distance(k_g, k_time)) + 12, "distance");
    svg << "<g fill=\"#1f6fb4\">" << label(322, 214, "closed form") << "</g>";
    svg << "<g fill=\"#c8501e\">" << label(438, 122, "four steps") << "</g></svg>\n";
}

/// A ball that falls by steps of a fifth of a second, and the closed form as its ghost.
void record_fall(const std::string& folder)
{
    std::ofstream trace(folder + "/fall.ndjson");
    trace << "{\"view\": [-3, -20.5, 3, 1.5], \"shapes\": [{\"radius\": 0.6}]}\n";
    for (int k = 0; k <= 60; ++k) {
        const double t = k_time * k / 60;
        const int steps = k / 6; // whole steps of a fifth of a second up to now
        const double dt = k_time / 10;
        const double s =
            (steps == 0 ? 0.0 : flying::fall_by_steps(k_g, steps * dt, steps)) + k_g * steps * dt * (t - steps * dt);
        trace << "{\"time\": " << t << ", \"bodies\": [[0, " << -s << ", 0]], \"ghosts\": [[0, "
              << -flying::fall_distance(k_g, t) << ", 0]]}\n";
    }
}

} // namespace

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    draw_steps(argv[1]);
    record_fall(argv[1]);
}
