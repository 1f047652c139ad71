#include <fstream>
#include <string>

#include "pendulum/large.hpp"

int main(int argc, char** argv)
{
    if (argc != 2) return 2;
    std::ofstream svg(std::string(argv[1]) + "/late.svg");
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 300 160\" width=\"300\"><polyline fill=\"none\" "
           "stroke=\"#1f6fb4\" points=\"";
    for (int k = 1; k < 60; ++k) {
        const double theta = 0.05 * k;
        svg << 5 * k << ',' << 160.0 - 40.0 * pendulum::large_period(1.0, 9.81, theta) / pendulum::small_period(1.0, 9.81) << ' ';
    }
    svg << "\"/></svg>\n";
}
