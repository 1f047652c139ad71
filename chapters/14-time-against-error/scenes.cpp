// The scenes of the kept run: what is measured in each, against what, and why that.

#include <cstdio>
#include <sstream>

#include "record.hpp"

using namespace flying::work;

namespace {

/// Words in lines of 96 characters, the first behind a label.
void print(const std::string& label, const std::string& text)
{
    std::string line = label;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (line.size() + word.size() + 1 > 96) {
            std::printf("%s\n", line.c_str());
            line = std::string(10, ' ');
        }
        line += (line.empty() || line.back() == ' ' ? "" : " ") + word;
    }
    std::printf("%s\n", line.c_str());
}

} // namespace

int main()
{
    const auto records = read_kept_run(FLYING_MEASURED);
    if (!records) return 1;
    for (const DiagramRecord& diagram : records->diagrams) {
        std::printf("%s: %s; %d %s, %g s\n", diagram.name.c_str(), diagram.title.c_str(), diagram.bodies,
                    diagram.bodies == 1 ? "body" : "bodies", diagram.until);
        print("  error   ", diagram.measures.front());
        print("  truth   ", diagram.truth);
        print("  why     ", diagram.why);
        for (const CurveRecord& curve : diagram.curves) {
            if (!curve.why_not.empty()) print("  not     ", curve.engine + ": " + curve.why_not);
        }
    }
    return 0;
}
