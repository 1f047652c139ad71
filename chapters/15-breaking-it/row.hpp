#pragma once

#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// What a run of the stress table wrote down: one object a line, so that a run that was cut off keeps every line but the last.
namespace flying::breaking {


/// Where and with what everything in a file was measured: its first line.
struct TableRun
{
    std::string date;     ///< when it began
    std::string machine;  ///< the processor, and how many cores it has
    std::string compiler; ///< with version and flags
};

/// One attempt to break the simulator, and how far it got.
struct Row
{
    int number = 0;        ///< rows of one number belong together
    std::string name;      ///< what was tried
    std::string measure;   ///< what `reached` is, with its unit
    double reached = 0.0;
    double bound = 0.0;    ///< what it should be
    bool at_least = false; ///< `reached` should be at least the bound; else at most
    std::string elsewhere; ///< the best that is known of other engines
    std::string amount;    ///< how much was tried
    std::string remark;    ///< what else was seen, or why it falls short; may be empty
    bool holds = false;
    bool is_whole = true;  ///< all that the row asks for was tried; a long one may still be on its way
    double seconds = 0.0;  ///< of computing, over all calls [s]
};



NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TableRun, date, machine, compiler)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Row, number, name, measure, reached, bound, at_least, elsewhere, amount, remark, holds, is_whole, seconds)

/// Everything that a file holds. A row that was written again replaces the one before.
struct Table
{
    TableRun run;
    std::vector<Row> rows; ///< in the order of their numbers

    [[nodiscard]] const Row* row(const std::string& name) const
    {
        for (const Row& one : rows)
            if (one.name == name) return &one;
        return nullptr;
    }

    void put(const Row& row)
    {
        for (Row& one : rows) {
            if (one.name != row.name) continue;
            one = row;
            return;
        }
        auto place = rows.begin();
        while (place != rows.end() && place->number <= row.number) ++place;
        rows.insert(place, row);
    }
};


/// The table in a text of lines. What follows the last end of a line was cut off and is left out.
/// Nothing where a whole line is no record, or the first is not that of a run.
[[nodiscard]] inline std::optional<Table> read_table(const std::string& text)
{
    Table table;
    std::size_t begin = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
        const nlohmann::json line = nlohmann::json::parse(text.substr(begin, end - begin), nullptr, false);
        if (!line.is_object() || (begin == 0) != line.contains("run")) return std::nullopt;
        if (line.contains("run")) line.at("run").get_to(table.run);
        if (line.contains("row")) table.put(line.at("row").get<Row>());
        begin = end + 1;
    }
    return begin == 0 ? std::nullopt : std::optional(table);
}


/// The same from a file; nothing where it can't be read.
[[nodiscard]] inline std::optional<Table> read_table_file(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    return read_table(std::string(std::istreambuf_iterator<char>(file), {}));
}

/// One line of a file, without its end.
template <typename Record>
[[nodiscard]] std::string line_of(const char* kind, const Record& record)
{
    return nlohmann::json{{kind, record}}.dump();
}

} // namespace flying::breaking
