#include "app/report_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flying {

namespace {

/// "812 bytes", "12.4 kB", "3.1 MB"
std::string size_text(long bytes)
{
    if (bytes < 1000) return fmt::format("{} bytes", bytes);
    if (bytes < 1000000) return fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3);
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

/// "1 234 567".
/// number  >= 0
std::string grouped(long number)
{
    const std::string digits = std::to_string(number);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
        text += digits[i];
    }
    return text;
}

std::string energy_text(const Report& report)
{
    const double total = report.energy.total();
    std::string text = fmt::format("{:.9g} J", total);
    if (report.initial_total != 0.0) {
        const double change = (total - report.initial_total) / std::abs(report.initial_total);
        text += fmt::format(", changed by {:.2g} of what it was", change);
    } else if (total != 0.0) {
        text += ", at the start 0 J";
    }
    return text;
}

/// How often bodies changed hands, and at what cost; each hand-over is in the JSON report.
[[nodiscard]] std::string handovers_text(const Report& report)
{
    long to_rest = 0;
    long to_events = 0;
    long bounces = 0;
    double cost = 0.0;
    for (const Handover& handover : report.handovers) {
        const long bodies = static_cast<long>(handover.bodies.size());
        (handover.to == Handover::To::rest ? to_rest : to_events) += bodies;
        if (handover.ends_bounces) ++bounces;
        cost += handover.energy_change;
    }
    std::string text = fmt::format("{} to rest, {} back to flight, energy changed by {:.3g} J", grouped(to_rest),
                                   grouped(to_events), cost);
    if (bounces > 0) text += fmt::format("; {} bounced without number to their end", grouped(bounces));
    return text;
}

/// How islands were solved, and what was done to them besides.
[[nodiscard]] std::string rest_text(const RestAccount& rest)
{
    return fmt::format("  islands at rest: {} swept, {} unsolved, {} in parts, {} projected, {} limited by {:.3g} J; {} in all\n",
                       grouped(rest.swept), grouped(rest.unsolved), grouped(rest.parts), grouped(rest.projected),
                       grouped(rest.limited), rest.energy_limited, grouped(rest.islands));
}

} // namespace

std::string report_text(const Scene& scene, const Report& report, const RunSeconds& seconds,
                        const std::vector<OutputFile*>& files)
{
    std::string text = scene.title.empty() ? "" : scene.title + "\n";
    const auto add = [&text](const char* key, const std::string& value) {
        text += fmt::format("  {:<16}{}\n", key, value);
    };
    add("time", fmt::format("{:.9g} s, engine {}", report.time, report.engine));
    add("events", fmt::format("{}, collisions {}", grouped(report.events), grouped(report.collisions)));
    if (!report.handovers.empty()) add("handed over", handovers_text(report));
    add("energy", energy_text(report));
    for (const std::string& warning : report.warnings) add("warning", warning);
    add("deepest overlap", fmt::format("{:.3g} m", report.max_overlap));
    add("hash", fmt::format("{:016x}", report.hash));
    add("took", fmt::format("{:.3g} s, the engine {:.3g} s of it", seconds.wall, seconds.engine));
    for (const OutputFile* file : files) {
        add("wrote", file->is_special() ? file->path() : fmt::format("{} ({})", file->path(), size_text(file->size())));
    }
    return text;
}

std::string stats_text(const Report& report, const RunSeconds& seconds)
{
    const double engine = std::max(seconds.engine, 1e-9);
    std::string text =
        fmt::format("  {:<20}{:>16}{:>14}{:>9}{:>12}\n", "stage", "count", "seconds", "share", "ns each");
    for (const StageCost& stage : report.stages) {
        const double each = stage.count > 0 ? stage.seconds / static_cast<double>(stage.count) * 1e9 : 0.0;
        text += fmt::format("  {:<20}{:>16}{:>14.6f}{:>7.1f} %{:>12.0f}\n", stage.name, grouped(stage.count),
                            stage.seconds, 100.0 * stage.seconds / engine, each);
    }
    text += fmt::format("  {:<36}{:>14.6f}{:>7.1f} %\n", "engine", seconds.engine, 100.0);
    text += fmt::format("  {:<36}{:>14.6f}\n", "drawing and writing", std::max(0.0, seconds.wall - seconds.engine));
    if (report.rest) text += rest_text(*report.rest);
    text += fmt::format("  {:.4g} events/s, {:.4g} collisions/s\n", static_cast<double>(report.events) / engine,
                        static_cast<double>(report.collisions) / engine);
    return text;
}

} // namespace flying
