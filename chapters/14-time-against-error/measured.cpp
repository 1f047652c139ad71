// What the kept run says, in numbers. Nothing is measured here: every line comes from measured.jsonl.

#include <cstdio>

#include <algorithm>

#include "record.hpp"

using namespace flying::work;

namespace {

std::vector<Point> of_peers(const DiagramRecord& diagram)
{
    std::vector<Point> all;
    for (const CurveRecord& curve : diagram.curves) {
        if (!is_peer(curve.engine)) continue;
        for (const Point& point : points_of(diagram, curve.engine)) all.push_back(point);
    }
    return all;
}

/// Our time over theirs, at the largest and at the smallest error that they reach.
struct Row
{
    std::string name;
    Point best_of_ours;
    double their_error = 0.0;
    std::optional<double> at_their_worst;
    std::optional<double> at_their_best;
    double worst = 0.0; ///< ratio over all their errors that we reach
};

Row row_of(const DiagramRecord& diagram)
{
    Row row;
    row.name = diagram.name;
    std::vector<Point> ours = our_points(diagram);
    row.best_of_ours =
        *std::min_element(ours.begin(), ours.end(), [](const Point& a, const Point& b) { return a.error < b.error; });

    const std::vector<Ratio> all = ratios(ours, of_peers(diagram));
    if (all.empty()) return row;
    row.at_their_worst = all.front().ours_over_theirs;
    row.at_their_best = all.back().ours_over_theirs;
    row.their_error = all.back().error;
    for (const Ratio& one : all) row.worst = std::max(row.worst, one.ours_over_theirs.value_or(0.0));

    return row;
}

std::string ratio_text(const std::optional<double>& ratio)
{
    if (!ratio) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", *ratio);
    return text;
}

/// That of a scene by its name; an empty one where the run has no such scene.
Row row_named(const Records& records, const std::string& name)
{
    const DiagramRecord* diagram = records.diagram(name);
    return diagram ? row_of(*diagram) : Row{};
}

} // namespace

int main()
{
    const auto read = read_kept_run(FLYING_MEASURED);
    if (!read) return 1;
    const Records& records = *read;
    std::printf("Run '%s' of %s, %d repeats\n", records.run.name.c_str(), records.run.date.c_str(),
                records.run.repeats);
    print_with_what(records.run);

    std::printf("\n%-17s %9s %9s %12s %11s %11s\n", "", "our error", "our time", "theirs, best", "over theirs",
                "over theirs");
    std::printf("%-17s %9s %9s %12s %11s %11s\n", "", "", "", "", "at worst", "at best");
    int won = 0;
    int reached = 0;
    for (const DiagramRecord& diagram : records.diagrams) {
        if (!is_race(diagram)) continue;
        const Row row = row_of(diagram);
        std::printf("%-17s %9.1e %7.1e s %12.1e %11s %11s\n", row.name.c_str(), row.best_of_ours.error,
                    row.best_of_ours.seconds, row.their_error, ratio_text(row.at_their_worst).c_str(),
                    ratio_text(row.at_their_best).c_str());
        reached += row.at_their_best ? 1 : 0;
        won += row.at_their_best && row.worst < 1.0 ? 1 : 0;
    }

    std::printf("\n");
    std::printf("scenes = %td\n", std::count_if(records.diagrams.begin(), records.diagrams.end(), is_race));
    std::printf("scenes reached = %d\n", reached);
    std::printf("scenes never slower = %d\n", won);
    std::printf("ratio discs = %.2g\n", row_named(records, "discs-0.1").at_their_best.value_or(0.0));
    std::printf("ratio polygons worst = %.2g\n", row_named(records, "polygons-0.4").worst);
    std::printf("ratio rocking worst = %.2g\n", row_named(records, "rocking-block").worst);
    std::printf("ratio rocking best = %.2g\n", row_named(records, "rocking-block").at_their_best.value_or(0.0));
    std::printf("ratio rolling worst = %.2g\n", row_named(records, "rolling").worst);
    std::printf("ratio sliding worst = %.2g\n", row_named(records, "slide-to-roll").worst);
    std::printf("ratio pile worst = %.2g\n", row_named(records, "pile").worst);
    std::printf("ratio galperin worst = %.2g\n", row_named(records, "galperin").worst);
    return 0;
}
