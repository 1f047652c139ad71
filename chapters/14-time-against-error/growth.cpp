// How time grows with the number of bodies, in numbers. Nothing is measured here: every line comes from growth.jsonl.

#include <cstdio>

#include "record.hpp"

using namespace flying::work;

namespace {

/// The exponent over the larger half of the sizes.
double exponent(const std::vector<std::pair<double, double>>& points)
{
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t k = points.size() / 2; k < points.size(); ++k) {
        x.push_back(points[k].first);
        y.push_back(points[k].second);
    }
    return slope(x, y).value_or(0.0);
}

/// Bytes per body of an engine's largest run; 0 where the file doesn't say.
double bytes_of(const GrowthRecord& growth, const std::string& engine)
{
    const auto found = growth.bytes_per_body.find(engine);
    return found == growth.bytes_per_body.end() ? 0.0 : found->second;
}

} // namespace

int main()
{
    const auto read = read_kept_run(FLYING_GROWTH);
    if (!read) return 1;
    const Records& records = *read;
    std::printf("Run of %s\n", records.run.date.c_str());
    print_with_what(records.run);

    std::printf("\n%-42s %8s %8s %9s %9s\n", "", "exponent", "most", "seconds", "memory");
    for (const GrowthRecord& growth : records.growths) {
        std::printf("%s, %s\n", growth.title.c_str(), growth.what.c_str());
        for (const auto& [engine, points] : growth.curves) {
            std::printf("    %-38s %8.2f %8.0f %7.2g s %6.2f GB\n", engine.c_str(), exponent(points),
                        points.back().first, points.back().second,
                        1e-9 * bytes_of(growth, engine) * points.back().first);
        }
    }

    std::printf("\n");
    for (const GrowthRecord& growth : records.growths) {
        for (const auto& [engine, points] : growth.curves)
            std::printf("exponent of %s, %s = %.2f\n", growth.name.c_str(), engine.c_str(), exponent(points));
        const auto& [size, seconds] = growth.curves.at("flying").back();
        std::printf("most %s = %.0f\n", growth.name.c_str(), size);
        std::printf("seconds for the most %s = %.3g s\n", growth.name.c_str(), seconds);
        std::printf("bytes for each of the most %s = %.0f\n", growth.name.c_str(), bytes_of(growth, "flying"));
    }
    return 0;
}
