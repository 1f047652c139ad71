#pragma once

namespace flying {

/// One line on a terminal, written over again as the work goes on: part done, simulated time, rate, time left. Nothing
/// where standard error is no terminal or quiet was asked for, nor in runs too short to wait for.
class Progress
{
public:
    enum class Wish
    {
        show,
        quiet
    };

    /// until  end of the run  [s]
    Progress(Wish wish, double until);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Leaves the line empty.
    ~Progress();

    /// Call as often as you like; it writes ten times a second.
    /// time    simulated so far  [s]
    /// events  handled so far
    void update(double time, long events);

private:
    bool is_shown_ = false;
    bool has_written_ = false;
    double until_ = 0.0;
    double started_ = 0.0;
    double written_ = 0.0;
};

} // namespace flying
