// The stress table of the kept run. Nothing is tried here: every line comes from measured.jsonl.

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>

#include "row.hpp"

using namespace flying::breaking;

namespace {

/// Words in lines of 96 characters, behind so many spaces.
void print(const std::string& text, std::size_t indent)
{
    std::string line(indent, ' ');
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (line.size() + word.size() + 1 > 96) {
            std::printf("%s\n", line.c_str());
            line = std::string(indent, ' ');
        }
        line += (line.back() == ' ' ? "" : " ") + word;
    }
    std::printf("%s\n", line.c_str());
}

} // namespace

int main()
{
    const auto table = read_table_file(FLYING_MEASURED);
    if (!table) {
        std::fprintf(stderr, "%s: found no table; expected the file of a run of ./course stress table\n",
                     FLYING_MEASURED);
        return 1;
    }
    std::printf("Run of %s\n%s\n%s\n\n", table->run.date.c_str(), table->run.machine.c_str(),
                table->run.compiler.c_str());
    int holds = 0;
    int long_ones = 0;
    for (const Row& row : table->rows) {
        const char* verdict = !row.holds ? "falls short" : row.is_whole ? "holds" : "holds so far";
        std::printf("%2d  %s: %s\n", row.number, row.name.c_str(), verdict);
        char text[160];
        std::snprintf(text, sizeof text, "%s: %.3g; asked: %s %.3g", row.measure.c_str(), row.reached,
                      row.at_least ? "at least" : "at most", row.bound);
        print(text, 4);
        if (!row.amount.empty()) print("tried: " + row.amount, 4);
        if (!row.remark.empty()) print("seen: " + row.remark, 4);
        if (!row.elsewhere.empty()) print("elsewhere: " + row.elsewhere, 4);
        holds += row.holds ? 1 : 0;
        long_ones += row.is_whole ? 0 : 1;
    }
    std::printf("\nrows = %zu\nrows that hold = %d\nrows that fall short = %zu\nrows still on their way = %d\n",
                table->rows.size(), holds, table->rows.size() - static_cast<std::size_t>(holds), long_ones);
    double seconds = 0.0;
    for (const Row& row : table->rows) seconds += row.seconds;
    std::printf("minutes of computing = %.0f\n", seconds / 60.0);
    const auto value = [&](const char* label, const char* name) {
        const Row* row = table->row(name);
        std::printf("%s = %.3g\n", label, row ? row->reached : 0.0);
    };
    value("heaviest ratio", "a heavy box on a light one");
    value("tallest stack", "a stack of boxes");
    value("energy change", "energy over a billion collisions");
    value("lowest step", "a low step on the way");
    value("off on tiles", "over flush tiles");
    value("heap overlap", "a heap of masses 1 : 1e4, sizes 1 : 20");
    value("speed left in a heap", "the same heap comes to rest");
    value("momentum gained", "towers on a smooth floor");
    value("energy of squares", "touching at the start, e = 1");
    return 0;
}
