#include "backend/atomic_file.h"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <random>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "backend/file_stream.h"
#include "backend/temporary_file.h"
#include "ir/diag/output.h"

namespace arelem::backend {

struct AtomicFile::State {
  State(std::string targetPath, std::string temporaryPath, int fd)
      : target(std::move(targetPath)),
        temporary(temporaryPath),
        descriptor(fd),
        buffer(fd),
        out(&buffer) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { close(); }
  /// A FIFO, /dev/null or a stream of the process: no temporary.
  [[nodiscard]] bool direct() const { return temporary.path().empty(); }
  /// errno of close, or 0.
  int close() {
    const int fd = descriptor;
    descriptor = -1;
    return fd >= 0 && ::close(fd) != 0 ? errno : 0;
  }

  std::string target;
  TemporaryFile temporary;
  int descriptor;
  FileStreamBuffer buffer;
  std::ostream out;
};

namespace {
constexpr int attempts = 100;
constexpr std::size_t longestName =
    200;  ///< of a file; leaves room for the ending of the temporary
constexpr mode_t ordinaryMode = 0666;

std::string words(int error) {
  return std::generic_category().message(error);
}

Failure cannotOpen(const std::string& path, int error) {
  return fail(diag::OutputOpen, path, words(error));
}

/// The process's own streams: opening the file behind them would cut it off or replace it.
bool isStreamName(const std::string& path) {
  return path == "/dev/stdout" || path == "/dev/stderr" || path.starts_with("/dev/fd/") ||
         path.starts_with("/proc/self/fd/");
}

/// The process's own stream itself, not a second opening with its own place in the file.
int openDirect(const std::string& path) {
  if (path == "/dev/stdout" || path == "/dev/stderr") {
    return ::dup(path == "/dev/stdout" ? STDOUT_FILENO : STDERR_FILENO);
  }
  return ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
}

std::string_view describe(mode_t mode) {
  if (S_ISDIR(mode)) {
    return "a folder";
  }
  return S_ISSOCK(mode) ? "a socket" : "a device";
}

bool isNullDevice(const struct stat& status) {
  struct stat null {};
  return S_ISCHR(status.st_mode) && ::stat("/dev/null", &null) == 0 &&
         null.st_rdev == status.st_rdev;
}

/// The file a chain of symbolic links ends at, so that the rename replaces the file and not the
/// link.
std::string resolved(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr),
                                                         &std::free);
  return real ? std::string(real.get()) : path;
}

/// A name beside the target that no other process chooses: process id and random digits.
std::string temporaryName(const std::string& target) {
  std::random_device device;
  const std::size_t slash = target.rfind('/');
  const std::size_t begin = slash == std::string::npos ? 0 : slash + 1;
  return fmt::format("{}.{}.{}-{:08x}.tmp", target.substr(0, begin),
                     target.substr(begin, longestName), ::getpid(), device());
}

/// Opens a new file; nothing is ever overwritten or followed.
int openTemporary(const std::string& target, std::string& name) {
  int fd = -1;
  for (int i = 0; i < attempts && fd < 0; ++i) {
    name = temporaryName(target);
    fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, ordinaryMode);
    if (fd < 0 && errno != EEXIST) {
      break;
    }
  }
  return fd;
}

/// Brings the entry of a renamed file to the disk; a file system that cannot is no failure of ours.
void syncFolder(const std::string& target) {
  const std::size_t slash = target.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : target.substr(0, slash + 1);
  const int fd = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd >= 0) {
    ::fsync(fd);
    ::close(fd);
  }
}
}  // namespace

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) {
    return cannotOpen(path, errno);
  }
  struct stat link {};
  if (!exists && ::lstat(path.c_str(), &link) == 0) {
    return fail(diag::OutputNotAFile, path, "a symbolic link to nothing");
  }
  const bool direct =
      isStreamName(path) || (exists && (S_ISFIFO(status.st_mode) || isNullDevice(status)));
  if (direct) {
    const int fd = openDirect(path);
    if (fd < 0) {
      return cannotOpen(path, errno);
    }
    return AtomicFile(std::make_unique<State>(path, "", fd));
  }
  if (exists && !S_ISREG(status.st_mode)) {
    return fail(diag::OutputNotAFile, path, describe(status.st_mode));
  }
  if (exists && ::access(path.c_str(), W_OK) != 0) {
    return cannotOpen(path, errno);
  }
  const std::string target = exists ? resolved(path) : path;
  std::string temporary;
  const int fd = openTemporary(target, temporary);
  if (fd < 0) {
    return cannotOpen(path, errno);
  }
  if (exists) {
    ::fchmod(fd, status.st_mode & 07777U);
  }
  return AtomicFile(std::make_unique<State>(target, temporary, fd));
}

AtomicFile::AtomicFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
AtomicFile::AtomicFile(AtomicFile&&) noexcept = default;
AtomicFile& AtomicFile::operator=(AtomicFile&&) noexcept = default;
AtomicFile::~AtomicFile() = default;

std::ostream& AtomicFile::stream() {
  return state_->out;
}

Result<std::uint64_t> AtomicFile::complete() {
  if (state_->descriptor < 0) {
    return state_->buffer.written();
  }
  state_->out.flush();
  int error = state_->buffer.error();
  if (error == 0 && !state_->out.good()) {
    error = EIO;
  }
  if (error == 0 && !state_->direct() && ::fsync(state_->descriptor) != 0) {
    error = errno;
  }
  const int closing = state_->close();
  error = error == 0 ? closing : error;
  if (error != 0) {
    return fail(diag::OutputWrite, state_->target, state_->buffer.written(), words(error));
  }
  return state_->buffer.written();
}

std::optional<Failure> AtomicFile::commit(const std::string& suffix) {
  Result<std::uint64_t> bytes = complete();
  const std::unique_ptr<State> state = std::move(state_);  // removes the temporary on every way out
  if (!bytes) {
    return bytes.takeFailure();
  }
  if (state->direct()) {
    return std::nullopt;
  }
  const std::string name = state->target + suffix;
  if (::rename(state->temporary.path().c_str(), name.c_str()) != 0) {
    return fail(diag::OutputReplace, name, words(errno));
  }
  state->temporary.release();
  syncFolder(name);
  return std::nullopt;
}

void AtomicFile::removeTemporaries() {
  TemporaryFile::removeAll();
}

}  // namespace arelem::backend
