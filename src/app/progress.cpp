#include "app/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <unistd.h>

#include "app/clock.hpp"

namespace flying {

namespace {

constexpr double k_patience = 0.4; ///< before the first line [s]
constexpr double k_pause = 0.1;    ///< between lines [s]

/// "42 s", "3 min 20 s", "2 h 05 min"
std::string duration(double seconds)
{
    if (!(seconds < 360000.0)) return "more than 100 h";
    const long whole = static_cast<long>(seconds + 0.5);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

} // namespace

Progress::Progress(Wish wish, double until)
    : is_shown_(wish == Wish::show && isatty(STDERR_FILENO) == 1),
      until_(until),
      started_(seconds_now()),
      written_(started_ + k_patience - k_pause)
{
}

Progress::~Progress()
{
    if (has_written_) std::fputs("\r\x1b[K", stderr);
}

void Progress::update(double time, long events)
{
    if (!is_shown_) return;
    const double now = seconds_now();
    if (now - written_ < k_pause) return;
    written_ = now;
    has_written_ = true;

    const double spent = now - started_;
    const double share = until_ > 0.0 ? std::clamp(time / until_, 0.0, 1.0) : 1.0;
    const std::string left = share > 0.0 ? duration(spent * (1.0 - share) / share) + " left" : "";
    const std::string rate = fmt::format("{:.3g}", static_cast<double>(events) / spent);
    fmt::print(stderr, "\r{:3.0f} %   {:.4g} of {:g} s   {} events/s   {}\x1b[K", 100.0 * share, time, until_, rate,
               left);
    std::fflush(stderr);
}

} // namespace flying
