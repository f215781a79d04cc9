#include "app/source_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ir/diag/files.h"

namespace arelem::app {

namespace {
/// Closes a file descriptor that is not standard input.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path)
      : fd_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  ~Descriptor() {
    if (fd_ > STDIN_FILENO) {
      ::close(fd_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }

 private:
  int fd_;
};

/// Why this file may not be read, or nothing. Standard input may be a pipe or a terminal.
std::optional<std::string> objection(int fd, bool standardInput) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) {
    return std::strerror(errno);
  }
  if (S_ISDIR(status.st_mode)) {
    return "it is a folder";
  }
  if (!standardInput && !S_ISREG(status.st_mode)) {
    return "it is a device or a pipe; `-` reads from standard input";
  }
  return std::nullopt;
}

}  // namespace

std::string displayName(const std::string& path) {
  return path == "-" ? "<stdin>" : path;
}

Result<std::string> readBytes(const std::string& path, const Limits& limits) {
  const auto refuse = [&](const std::string& reason) {
    return fail(diag::InputUnreadable, displayName(path), reason);
  };
  const Descriptor file(path);
  if (file.get() < 0) {
    return refuse(std::strerror(errno));
  }
  if (const auto reason = objection(file.get(), path == "-")) {
    return refuse(*reason);
  }
  std::string bytes;
  std::array<char, 1U << 16U> block{};
  while (true) {
    const ssize_t got = ::read(file.get(), block.data(), block.size());
    if (got == 0) {
      return bytes;
    }
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      return refuse(std::strerror(errno));
    }
    if (bytes.size() + static_cast<std::size_t>(got) > limits.bytes) {
      return fail(diag::InputTooLarge, displayName(path), limits.bytes);
    }
    bytes.append(block.data(), static_cast<std::size_t>(got));
  }
}

std::optional<Failure> objectionToText(const std::string& path, std::string_view bytes) {
  const std::string name = displayName(path);
  for (const std::string_view mark : {"\xFF\xFE", "\xFE\xFF"}) {
    if (bytes.starts_with(mark)) {
      return fail(diag::InputNotText, name, "a UTF-16 byte order mark", std::uint64_t{0})
          .withHelp("save it as UTF-8");
    }
  }
  const std::size_t nul = bytes.find('\0');
  if (nul != std::string_view::npos) {
    return fail(diag::InputNotText, name, "a NUL byte", static_cast<std::uint64_t>(nul));
  }
  return std::nullopt;
}

}  // namespace arelem::app
