#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>

namespace {

int started = 0; // test cases that any filter has let through

/// Counts what runs.
class Count : public doctest::IReporter
{
public:
    explicit Count(const doctest::ContextOptions&) {}
    void test_case_start(const doctest::TestCaseData&) override { ++started; }

    void report_query(const doctest::QueryData&) override {}
    void test_run_start() override {}
    void test_run_end(const doctest::TestRunStats&) override {}
    void test_case_reenter(const doctest::TestCaseData&) override {}
    void test_case_end(const doctest::CurrentTestCaseStats&) override {}
    void test_case_exception(const doctest::TestCaseException&) override {}
    void subcase_start(const doctest::SubcaseSignature&) override {}
    void subcase_end() override {}
    void log_assert(const doctest::AssertData&) override {}
    void log_message(const doctest::MessageData&) override {}
    void test_case_skipped(const doctest::TestCaseData&) override {}
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
