#include <regex>

#include "house.hpp"

namespace house {

namespace {

/// A class, while it is read.
struct Class
{
    std::string name;
    std::string place; ///< file and line of its head
    int depth = 0;     ///< of braces about it
    bool is_private = false;
    int functions = 0; ///< private ones
    int members = 0;   ///< of its objects
};

/// Counts a declaration of a class, as far as the brace or semicolon that ends it.
void count(Class& one, const std::string& declaration)
{
    static const std::regex k_no_member(R"(^\s*((using|friend|static_assert|struct|class|union|enum|typedef)\b[^]*)?)");
    static const std::regex k_arguments(R"(<[^<>]*>)"); // of templates
    static const std::regex k_function(R"(\(|\boperator\b)");
    static const std::regex k_pointer(R"(\(\*\w+\))"); // to a function
    static const std::regex k_static(R"(\bstatic\b)");
    if (std::regex_match(declaration, k_no_member)) return;
    std::string head = declaration;
    for (std::string before; before != head;) {
        before = head;
        head = std::regex_replace(head, k_arguments, "");
    }
    head = head.substr(0, head.find('='));
    if (std::regex_search(head, k_function) && !std::regex_search(head, k_pointer)) {
        if (one.is_private) ++one.functions;
    } else if (!std::regex_search(head, k_static)) ++one.members;
}

/// Reads the classes of a file, one character after the other, and hands out each as it ends.
class Reader
{
public:
    explicit Reader(const Source& source) : source_(source) {}

    template <typename Visit>
    void for_each_class(const Visit& visit)
    {
        for (line_ = 0; line_ < source_.code.size(); ++line_) {
            if (source_.code[line_].starts_with("#")) continue;
            for (const char c : source_.code[line_] + "\n") {
                if (c == '{') begin();
                else if (c == '}') end(visit);
                else if (c == ';') {
                    if (is_in_class()) count(open_.back(), text_);
                    text_.clear();
                } else if (c != ':' || !changes_access()) text_ += c;
            }
        }
    }

private:
    /// Between the braces of a class, and in none of its functions.
    [[nodiscard]] bool is_in_class() const { return !open_.empty() && depth_ == open_.back().depth + 1; }

    [[nodiscard]] bool changes_access()
    {
        static const std::regex k_access(R"(\s*(public|protected|private)\s*)");
        std::smatch match;
        if (!is_in_class() || !std::regex_match(text_, match, k_access)) return false;
        open_.back().is_private = match[1].str() == "private";
        text_.clear();
        return true;
    }

    void begin()
    {
        static const std::regex k_class(
            R"((enum\s+)?\b(class|struct)\s+(?:alignas\s*\(\d+\)\s*)?(\w+)(\s+final)?(\s*:[^;]*)?\s*$)");
        std::smatch match;
        if (std::regex_search(text_, match, k_class) && !match[1].matched) {
            open_.push_back(
                {match[3].str(), source_.path + ":" + std::to_string(line_ + 1), depth_, match[2].str() == "class"});
        } else if (is_in_class()) count(open_.back(), text_);
        text_.clear();
        ++depth_;
    }

    template <typename Visit>
    void end(const Visit& visit)
    {
        --depth_;
        text_.clear();
        if (open_.empty() || depth_ != open_.back().depth) return;
        visit(open_.back());
        open_.pop_back();
    }

    const Source& source_;
    std::vector<Class> open_; // the innermost last
    std::string text_;        // since the last declaration ended
    std::size_t line_ = 0;
    int depth_ = 0;
};

} // namespace

std::vector<std::string> class_faults(const std::vector<Source>& sources, int most_functions, int most_members)
{
    std::vector<std::string> faults;
    for (const Source& source : sources) {
        Reader(source).for_each_class([&](const Class& one) {
            const auto complain = [&](int found, int most, const std::string& what) {
                if (found <= most) return;
                faults.push_back(one.place + ": " + one.name + " has " + std::to_string(found) + " " + what +
                                 ", at most " + std::to_string(most));
            };
            complain(one.functions, most_functions, "private functions");
            complain(one.members, most_members, "members");
        });
    }
    return faults;
}

} // namespace house
