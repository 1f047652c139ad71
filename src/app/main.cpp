#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "files/interrupt.hpp"

/// The program `flying`: see `flying --help`.
int main(int argc, char** argv)
{
    flying::let_writing_fail();
    int status = flying::status::k_failed;
    try {
        status = flying::run_command_line(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("flying: out of memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "flying: %s\n", error.what());
    }

    // What waits for a full disk or a closed pipe fails only here
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
        if (status == 0) std::fprintf(stderr, "flying: standard output: %s\n", std::strerror(errno));
        return status == 0 ? flying::status::k_failed : status;
    }
    return status;
}
