#include "files/interrupt.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <string_view>
#include <unistd.h>

namespace flying {

namespace {

// A handler may touch only what is lock-free
static_assert(std::atomic<const char*>::is_always_lock_free && std::atomic<int>::is_always_lock_free);
constexpr std::array<int, 3> k_ends = {SIGINT, SIGTERM, SIGHUP};
std::atomic<int> g_signal{0};
std::array<std::atomic<const char*>, 16> g_temporaries{};

/// What a handler may print: formatting may allocate, and so may not be called here.
void say(std::string_view line)
{
    // Where standard error is closed, there is nowhere to report to
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, line.data(), line.size());
}

void note(int signal)
{
    if (g_signal.exchange(signal) == 0) return;
    for (const auto& path : g_temporaries) {
        if (const char* name = path.load()) unlink(name);
    }
    say("flying: stopped at once; unfinished files are removed\n");
    _exit(128 + signal);
}

void replace(const char* from, const char* to)
{
    for (auto& path : g_temporaries) {
        const char* expected = from;
        if (path.compare_exchange_strong(expected, to)) return;
    }
}

} // namespace

void let_writing_fail()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void watch_for_interrupts()
{
    struct sigaction action = {};
    action.sa_handler = note;
    sigemptyset(&action.sa_mask);
    for (const int signal : k_ends) {
        // A program started under nohup, or in the background by a script, stays deaf
        struct sigaction before = {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

int interrupted()
{
    return g_signal.load();
}

HeldInterrupts::HeldInterrupts()
{
    sigset_t ends;
    sigemptyset(&ends);
    for (const int signal : k_ends) sigaddset(&ends, signal);
    sigprocmask(SIG_BLOCK, &ends, &before_);
}

HeldInterrupts::~HeldInterrupts()
{
    sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void remove_on_interrupt(const char* path)
{
    replace(nullptr, path);
}
void forget_on_interrupt(const char* path)
{
    replace(path, nullptr);
}

} // namespace flying
