#pragma once

namespace flying {

/// Adds the time of its own life to a sum, where a clock was lent.
class StageTimer
{
public:
    /// seconds  the clock, or null [s]
    StageTimer(double (*seconds)(), double& sum) : seconds_(seconds), sum_(sum), start_(seconds ? seconds() : 0.0) {}
    ~StageTimer()
    {
        if (seconds_) sum_ += seconds_() - start_;
    }
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    double (*seconds_)();
    double& sum_;
    double start_;
};

} // namespace flying
