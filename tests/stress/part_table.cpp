#include "stress.hpp"

#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "15-breaking-it/row.hpp"
#include "table/trials.hpp"

namespace flying::stress {
namespace {

using breaking::Row;
using breaking::Table;

std::string machine()
{
    std::ifstream file("/proc/cpuinfo");
    std::string name = "unknown processor";
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("model name")) {
            name = line.substr(line.find(':') + 2);
            break;
        }
    }
    return fmt::format("{}, {} cores", name, std::thread::hardware_concurrency());
}

std::string today()
{
    const std::time_t now = std::time(nullptr);
    char text[16];
    std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
    return text;
}

std::vector<Trial> all_trials()
{
    std::vector<Trial> all;
    for (const auto& some : {trials_of_flight(), trials_of_rest(), trials_of_crowds(), trials_of_corners(),
                             trials_of_links(), trials_of_doors(), trials_of_bits(), trials_of_length()})
        all.insert(all.end(), some.begin(), some.end());
    std::stable_sort(all.begin(), all.end(), [](const Trial& a, const Trial& b) { return a.number < b.number; });
    return all;
}

/// `seconds` so far, to which those of this call come.
Row try_one(const Trial& trial, const Share& share, double seconds)
{
    Row row;
    row.number = trial.number;
    row.name = trial.name;
    row.measure = trial.measure;
    row.bound = trial.bound;
    row.at_least = trial.at_least;
    row.elsewhere = trial.elsewhere;
    const std::clock_t started = std::clock();
    try {
        const Reached reached = trial.run(share);
        row.reached = reached.value;
        row.amount = reached.amount;
        row.remark = reached.remark;
        row.is_whole = reached.is_whole;
        row.holds = trial.at_least ? reached.value >= trial.bound : reached.value <= trial.bound;
    } catch (const std::exception& error) {
        row.remark = error.what();
    }
    row.seconds = seconds + static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
    return row;
}

} // namespace

void run_table(const Job& job, Tally& tally)
{
    // A row that holds and is whole is not tried again: delete the file for that
    const std::string folder = FLYING_SOURCE_DIR "/out/stress";
    const std::string path = folder + "/table.jsonl";
    std::filesystem::create_directories(folder);
    Table table = breaking::read_table_file(path).value_or(Table{});
    if (table.run.date.empty()) {
        table.run = {today(), machine(), FLYING_COMPILER};
        std::ofstream(path, std::ios::binary) << breaking::line_of("run", table.run) << '\n';
    }
    for (const Trial& trial : all_trials()) {
        if (job.row != 0 && job.row != trial.number) continue;
        const Row* before = table.row(trial.name);
        if (before && before->holds && before->is_whole) {
            tally.note(fmt::format("        {:>2} {}: done before", trial.number, trial.name));
            continue;
        }
        tally.progress(fmt::format("table: {} {}", trial.number, trial.name));
        const Row row = try_one(trial, {static_cast<double>(job.count), folder}, before ? before->seconds : 0.0);
        std::ofstream(path, std::ios::binary | std::ios::app) << breaking::line_of("row", row) << '\n';
        table.put(row);
        tally.result(row.holds, fmt::format("{:>2} {}: {} {:.3g}, {} {:.3g} asked; {}{}{}", row.number, row.name,
                                            row.measure, row.reached, row.at_least ? "at least" : "at most", row.bound,
                                            row.amount, row.remark.empty() ? "" : "; " + row.remark,
                                            row.is_whole ? "" : " (to be gone on with)"));
    }
}

} // namespace flying::stress
