#include "scene/fault.hpp"

#include <algorithm>

namespace flying {

std::string format_fault(const Fault& fault)
{
    std::string line = fault.place;
    if (!fault.place.empty()) line += ": ";
    if (fault.expected.empty()) return line + fault.found;
    if (!fault.found.empty()) line += "found " + fault.found + ", ";
    return line + "expected " + fault.expected;
}

std::string format_faults(const Faults& faults)
{
    std::string lines;
    for (const Fault& fault : faults) lines += format_fault(fault) + "\n";
    return lines;
}

namespace {

/// Letters to change, leave out, add or swap with their neighbour to get from one word to the other.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    // Three rows of the table of distances between the words' beginnings: of i - 2, i - 1 and i letters of `a`
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = last;
        last = row;
    }
    return last[b.size()];
}

} // namespace

std::string nearest_word(std::string_view word, const std::vector<std::string>& known)
{
    // A word this long was not meant for any of ours, and comparing it would take its time
    constexpr std::size_t k_longest = 40;
    if (word.empty() || word.size() > k_longest) return {};

    std::string nearest;
    std::size_t least = std::max<std::size_t>(1, word.size() / 3) + 1;
    for (const std::string& candidate : known) {
        // A word that is cut short, such as pos, is nearer than any slip
        const bool is_cut = word.size() >= 3 && candidate.starts_with(word);
        const std::size_t distance = is_cut ? 0 : edit_distance(word, candidate);
        if (distance < least) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

} // namespace flying
