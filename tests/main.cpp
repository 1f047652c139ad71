#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>

#include "support/listener.hpp"

namespace {

int started = 0; // test cases that any filter has let through

/// Counts what runs.
struct Count : flying::testing::Listener
{
    explicit Count(const doctest::ContextOptions&) {}
    void test_case_start(const doctest::TestCaseData&) override { ++started; }
};

} // namespace

REGISTER_LISTENER("count", 1, Count);

/// As doctest's own, but a name that no test case has is a failure: CTest asks for each by its name, and a name that it
/// cut in two at a semicolon would otherwise pass without a test.
int main(int argc, char** argv)
{
    doctest::Context context(argc, argv);
    const int status = context.run();
    if (context.shouldExit() || started > 0 || argc == 1) return status;
    std::fputs("no test case of that name\n", stderr);
    return 1;
}
