#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <sys/time.h>

#include "support/listener.hpp"

namespace {

// Eight times what the longest solution takes, and a second or two for most answers
constexpr std::int64_t k_most_steps = 500'000'000;

// Of the processor, for a loop in which nothing is to be counted: while (true) {}. More than the steps take.      [s]
constexpr time_t k_most_seconds = 5;

std::int64_t steps = 0;         // blocks of code since the test case began
const char* test_case = "none"; // its name

/// Says what doctest would of a test case that threw, and ends the program: an answer that counts here is not made to
/// be unwound.
[[noreturn]] void give_up(const char* why)
{
    std::printf("TEST CASE:  %s\n\nERROR: test case THREW exception: %s\n\n", test_case, why);
    std::fflush(stdout);
    std::_Exit(1);
}

/// What the processor's timer calls. The answer, which it interrupts, never goes on.
void time_is_up(int)
{
    give_up("it was not done after 5 seconds; has it a loop with nothing in it?");
}

/// Counts anew in each test case.
struct Steps : flying::testing::Listener
{
    explicit Steps(const doctest::ContextOptions&) {}
    void test_case_start(const doctest::TestCaseData& data) override
    {
        steps = 0;
        test_case = data.m_name;
        const itimerval limit{{0, 0}, {k_most_seconds, 0}};
        std::signal(SIGVTALRM, time_is_up);
        setitimer(ITIMER_VIRTUAL, &limit, nullptr);
    }
};

} // namespace

REGISTER_LISTENER("steps", 1, Steps);

/// Ends an answer that comes to no end. Exercises are compiled with -fsanitize-coverage=trace-pc, so that each block of
/// their code, up to the next branch, calls this. Steps are counted, not seconds: an answer ends at the same place on
/// every machine, but for an empty loop, which has no code to count.
extern "C" void __sanitizer_cov_trace_pc() // NOLINT(bugprone-reserved-identifier)
{
    if (++steps > k_most_steps) give_up("it was not done after 500 million steps");
}
