// The command `generate`: writes a scene of the kind that is asked for.

#include <fmt/format.h>

#include <algorithm>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "scene/fault.hpp"
#include "scene/generate_words.hpp"

namespace flying {

namespace {

/// A member's name as an option: "max_spin" is "--max-spin".
std::string as_option(std::string member)
{
    std::replace(member.begin(), member.end(), '_', '-');
    return "--" + member;
}

} // namespace

int generate_to_stdout(const std::string& kind, const GenerateOptions& options, const std::string& command)
{
    const Expected<std::string> text = generate_text(kind, options, command);
    if (!text) {
        for (Fault fault : text.faults()) {
            if (!fault.place.empty()) fault.place = as_option(fault.place);
            std::replace(fault.expected.begin(), fault.expected.end(), '_', '-');
            complain(format_fault(fault));
        }
        return status::k_usage;
    }
    fmt::print("{}", text.value());
    return status::k_done;
}

} // namespace flying
