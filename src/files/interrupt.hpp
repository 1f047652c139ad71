#pragma once

#include <csignal>

namespace flying {

/// Let writing to what is closed or full fail by an error in place of a signal.
void let_writing_fail();

/// From now on, take note of the signals that ask for an end (Ctrl-C, TERM, HUP) in place of ending at once; for code
/// that calls `interrupted` often. A second such signal ends the program at once, its temporary files removed, and says
/// so: impatient hands send it, and `timeout`, which signals its child and then the whole group.
void watch_for_interrupts();

/// The signal that asked for an end; 0 while none has.
[[nodiscard]] int interrupted();

/// Lets the signals that ask for an end wait for as long as it lives.
class HeldInterrupts
{
public:
    HeldInterrupts();
    HeldInterrupts(const HeldInterrupts&) = delete;
    HeldInterrupts& operator=(const HeldInterrupts&) = delete;
    ~HeldInterrupts();

private:
    sigset_t before_;
};

/// Remove this file where a signal ends the program at once.
/// path  stays where it is until `forget_on_interrupt`
void remove_on_interrupt(const char* path);
void forget_on_interrupt(const char* path);

} // namespace flying
