#pragma once

namespace flying {

/// Read the command line, do what it asks, return the exit status. Complaints go to standard error.
[[nodiscard]] int run_command_line(int argc, char** argv);

} // namespace flying
