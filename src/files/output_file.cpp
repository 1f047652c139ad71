#include "files/output_file.hpp"

#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

#include "files/interrupt.hpp"

namespace flying {

namespace {

constexpr std::size_t k_buffer = std::size_t{1} << 18;

Fault fault(const std::string& path, int error)
{
    // "No such file or directory" would seem to speak of the file, which is not expected to exist
    const std::string folder = std::filesystem::path(path).parent_path().string();
    std::error_code ignored;
    if (error == ENOENT && !folder.empty() && !std::filesystem::exists(folder, ignored)) {
        return {path, "no directory " + folder, "one that exists"};
    }
    return {path, std::strerror(error), ""};
}

/// The name behind all links; the path itself where there is nothing yet.
std::string behind_links(const std::string& path)
{
    char* const real = realpath(path.c_str(), nullptr);
    if (!real) return path;
    std::string result(real);
    std::free(real);
    return result;
}

std::string folder_of(const std::string& path)
{
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return "./";
    return path.substr(0, slash + 1);
}

/// A name of our own beside the target; hidden, and never longer than names may be.
std::string temporary_name(const std::string& target, int attempt)
{
    const std::string name = target.substr(target.rfind('/') + 1).substr(0, 100);
    return folder_of(target) + "." + name + "." + std::to_string(getpid()) + "." + std::to_string(attempt) + ".part";
}

/// An entry in a folder is itself data of that folder.
void flush_folder(const std::string& folder)
{
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    fsync(descriptor);
    close(descriptor);
}

} // namespace

struct OutputFile::Parts
{
    std::string path;
    std::string target;    ///< behind links
    std::string temporary; ///< empty for a special file, and once committed
    std::string buffer;
    int descriptor = -1;
    long size = 0;
    bool is_special = false;

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts()
    {
        if (descriptor >= 0) close(descriptor);
        if (temporary.empty()) return;
        unlink(temporary.c_str());
        forget_on_interrupt(temporary.c_str());
    }

    std::optional<Fault> flush()
    {
        std::string_view left = buffer;
        while (!left.empty()) {
            const ssize_t written = ::write(descriptor, left.data(), left.size());
            if (written < 0 && errno == EINTR) continue;
            if (written < 0) return fault(path, errno);
            left.remove_prefix(static_cast<std::size_t>(written));
        }
        buffer.clear();
        return std::nullopt;
    }
};

OutputFile::OutputFile(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
OutputFile::OutputFile(OutputFile&&) noexcept = default;
OutputFile& OutputFile::operator=(OutputFile&&) noexcept = default;
OutputFile::~OutputFile() = default;

Expected<OutputFile> OutputFile::open(const std::string& path)
{
    auto parts = std::make_unique<Parts>();
    parts->path = path;
    if (path.empty()) return Fault{"", "an empty file name", ""};
    if (path.back() == '/') return fault(path, EISDIR);

    // Never replace a device or a pipe, nor a folder
    struct stat existing = {};
    const bool exists = stat(path.c_str(), &existing) == 0;
    if (!exists && errno != ENOENT) return fault(path, errno);
    if (exists && S_ISDIR(existing.st_mode)) return fault(path, EISDIR);
    if (exists && !S_ISREG(existing.st_mode)) {
        parts->is_special = true;
        parts->descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        if (parts->descriptor < 0) return fault(path, errno);
        return OutputFile(std::move(parts));
    }

    // An older file that may not be written to isn't to be replaced either
    if (exists && access(path.c_str(), W_OK) != 0) return fault(path, errno);
    parts->target = behind_links(path);
    const HeldInterrupts held; // or one that comes before the file is known to them would leave it there
    for (int attempt = 0; parts->descriptor < 0; ++attempt) {
        std::string name = temporary_name(parts->target, attempt);
        parts->descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (parts->descriptor < 0 && (errno != EEXIST || attempt == 1000)) return fault(path, errno);
        if (parts->descriptor >= 0) parts->temporary = std::move(name);
    }
    remove_on_interrupt(parts->temporary.c_str());
    if (exists) fchmod(parts->descriptor, existing.st_mode & 0777);
    return OutputFile(std::move(parts));
}

std::optional<Fault> OutputFile::write(std::string_view bytes)
{
    parts_->buffer.append(bytes);
    parts_->size += static_cast<long>(bytes.size());
    if (parts_->buffer.size() < k_buffer) return std::nullopt;
    return parts_->flush();
}

std::optional<Fault> OutputFile::finish()
{
    if (std::optional<Fault> full = parts_->flush()) return full;
    struct stat written = {};
    if (!parts_->is_special && fstat(parts_->descriptor, &written) == 0) parts_->size = written.st_size;
    const bool is_safe = parts_->is_special || fsync(parts_->descriptor) == 0;
    const int error = errno;
    const bool is_closed = close(parts_->descriptor) == 0;
    parts_->descriptor = -1;
    if (!is_safe) return fault(parts_->path, error);
    if (!is_closed) return fault(parts_->path, errno);
    return std::nullopt;
}

std::optional<Fault> OutputFile::commit()
{
    if (parts_->is_special) return std::nullopt;
    if (rename(parts_->temporary.c_str(), parts_->target.c_str()) != 0) return fault(parts_->path, errno);
    forget_on_interrupt(parts_->temporary.c_str());
    parts_->temporary.clear();
    flush_folder(folder_of(parts_->target));
    return std::nullopt;
}

const std::string& OutputFile::path() const
{
    return parts_->path;
}
const std::string& OutputFile::temporary_path() const
{
    return parts_->temporary;
}
bool OutputFile::is_special() const
{
    return parts_->is_special;
}
long OutputFile::size() const
{
    return parts_->size;
}

} // namespace flying
