#pragma once

namespace flying {

/// Measures the stages of a step, one after another, with a clock that is lent; without one it costs nothing.
class Stopwatch
{
public:
    explicit Stopwatch(double (*seconds)()) : seconds_(seconds), since_(seconds ? seconds() : 0.0) {}

    /// Add what has passed since the last stop.
    void stop(double& sum)
    {
        if (!seconds_) return;
        const double now = seconds_();
        sum += now - since_;
        since_ = now;
    }

private:
    double (*seconds_)();
    double since_;
};

} // namespace flying
