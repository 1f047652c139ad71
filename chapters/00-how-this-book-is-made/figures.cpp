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
           "font-size=\"18\" fill=\"#333\">\n";
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

/// A box with one or two lines of words, its middle at (x, y).
std::string box(double x, double y, double width, const std::string& colour, const std::string& first,
                const std::string& second = "")
{
    const double height = second.empty() ? 40.0 : 62.0;
    const double line = y + (second.empty() ? 6.0 : -5.0);
    std::string words = label(x, line, first);
    if (!second.empty()) words += label(x, line + 23.0, second);
    return "<rect x=\"" + std::to_string(x - width / 2) + "\" y=\"" + std::to_string(y - height / 2) + "\" width=\"" +
           std::to_string(width) + "\" height=\"" + std::to_string(height) + "\" rx=\"7\" fill=\"" + colour +
           "\" fill-opacity=\"0.14\" stroke=\"" + colour + "\" stroke-width=\"1.6\"/>\n" + words;
}

std::string arrow(const std::string& way)
{
    return "<path d=\"" + way + "\" fill=\"none\" stroke=\"#555\" stroke-width=\"1.8\" marker-end=\"url(#head)\"/>\n";
}

/// From sources to the page: what is compiled, what runs, what is woven.
void draw_way(const std::string& folder)
{
    const std::string blue = "#1f6fb4";
    const std::string orange = "#c8501e";
    const std::string green = "#3d8b4f";
    std::ofstream svg(folder + "/way.svg");
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 560 330\" width=\"560\" font-family=\"sans-serif\" "
           "font-size=\"18\" fill=\"#333\" text-anchor=\"middle\">\n<defs><marker id=\"head\" markerWidth=\"9\" "
           "markerHeight=\"9\" refX=\"8\" refY=\"4.5\" orient=\"auto\" markerUnits=\"userSpaceOnUse\"><path "
           "d=\"M0,0 L9,4.5 L0,9 z\" fill=\"#555\"/></marker></defs>\n";
    svg << box(95, 50, 150, blue, "sources", "in C++") << box(95, 280, 150, blue, "the text");
    svg << box(285, 50, 150, orange, "tests and", "programs run");
    svg << box(285, 165, 190, orange, "receipts, values,", "outputs, figures");
    svg << box(285, 280, 150, orange, "weave") << box(475, 280, 130, green, "the page");
    svg << arrow("M172,50 H208") << arrow("M285,83 V132") << arrow("M285,198 V258") << arrow("M172,280 H208")
        << arrow("M95,83 V212 Q95,262 208,270") << arrow("M362,280 H408");
    svg << "<g fill=\"#c8501e\">" << label(468, 185, "a broken rule") << label(468, 207, "ends the way") << "</g>";
    svg << "<path d=\"M430,220 L392,262\" stroke=\"#c8501e\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"/></svg>\n";
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
    draw_way(argv[1]);
    record_fall(argv[1]);
}
