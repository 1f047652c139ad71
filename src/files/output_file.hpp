#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "math/expected.hpp"

namespace flying {

/// A file that appears whole or not at all: what is written goes to a temporary file in the same folder, which takes
/// the asked name only in `commit`. Until then an older file of that name stays as it was. A device or a pipe, which
/// can't be replaced, is written to at once.
///
/// Faults are placed at the path and hold the system's reason.
class OutputFile
{
public:
    /// Make the temporary file.
    /// path  a link is followed: it stays, and the file that it names is replaced
    [[nodiscard]] static Expected<OutputFile> open(const std::string& path);

    OutputFile(OutputFile&&) noexcept;
    OutputFile& operator=(OutputFile&&) noexcept;
    /// Takes away the temporary file of an output that was not committed.
    ~OutputFile();

    /// Add bytes. They may wait in memory until `finish`.
    [[nodiscard]] std::optional<Fault> write(std::string_view bytes);

    /// Everything down to the disk. No more writing then.
    [[nodiscard]] std::optional<Fault> finish();

    /// Give the finished file its name.
    [[nodiscard]] std::optional<Fault> commit();

    /// As asked for.
    [[nodiscard]] const std::string& path() const;
    /// Where the bytes are until `commit`: for another program to write to, before `finish`.
    [[nodiscard]] const std::string& temporary_path() const;
    /// A device or a pipe.
    [[nodiscard]] bool is_special() const;
    /// Written so far.  [bytes]
    [[nodiscard]] long size() const;

private:
    struct Parts;
    explicit OutputFile(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

} // namespace flying
