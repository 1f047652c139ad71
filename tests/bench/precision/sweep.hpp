#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "14-time-against-error/record.hpp"
#include "engine.hpp"

namespace flying::bench {

struct SweepOptions
{
    int repeats = 30;
    double most = 0.5;             ///< a setting whose run takes longer is left out, and all finer steps [s]
    double least = 1e-3;           ///< shorter runs are made many at a time, until they take so long together [s]
    std::vector<double> hertz;     ///< steps a second, ascending [1/s]
    double (*seconds)() = nullptr; ///< a clock of computing [s]
};

/// Every engine with every setting, on one scene: first once, to look; then all in turn, to measure time.
/// tell  is told what is going on
[[nodiscard]] work::DiagramRecord sweep(const Trial& trial, std::span<const Engine> engines,
                                        const SweepOptions& options,
                                        const std::function<void(const std::string&)>& tell);

/// A file of records that grows line by line: each as soon as it is measured, so that a run can go on where it was cut
/// off.
class RecordFile
{
public:
    /// Opens a file of a run like this one and keeps its whole lines, or begins a new one.
    /// Fails, with a message that says what to do, where the file is of another run or no such file at all.
    [[nodiscard]] static Expected<RecordFile> open(const std::string& path, const work::RunRecord& run);

    [[nodiscard]] const work::Records& records() const { return records_; }
    [[nodiscard]] bool has_diagram(const std::string& name) const { return records_.diagram(name) != nullptr; }
    [[nodiscard]] bool has_growth(const std::string& name) const;
    [[nodiscard]] bool has_skips(const std::string& scene) const;

    void add(const work::DiagramRecord& record);
    void add(const work::GrowthRecord& record);
    void add(const work::SkipsRecord& record);

private:
    RecordFile(std::string path, work::Records records) : path_(std::move(path)), records_(std::move(records)) {}
    void append(const std::string& line) const;

    std::string path_;
    work::Records records_;
};

} // namespace flying::bench
