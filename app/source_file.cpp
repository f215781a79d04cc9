#include "app/source_file.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "ir/diag/display_text.h"

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

// The 32 bytes 0x80 to 0x9F of Windows-1252; 0 where undefined.
constexpr std::array<char32_t, 32> windows1252 = {
    0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

char32_t fromWindows1252(unsigned char byte) {
  return byte >= 0x80 && byte < 0xA0 ? windows1252.at(byte - 0x80U) : byte;
}

void appendUtf8(std::string& out, char32_t c) {
  if (c < 0x80) {
    out += static_cast<char>(c);
  } else if (c < 0x800) {
    out += static_cast<char>(0xC0U | (c >> 6U));
    out += static_cast<char>(0x80U | (c & 0x3FU));
  } else {
    out += static_cast<char>(0xE0U | (c >> 12U));
    out += static_cast<char>(0x80U | ((c >> 6U) & 0x3FU));
    out += static_cast<char>(0x80U | (c & 0x3FU));
  }
}

std::string transcoded(const std::string& bytes) {
  std::string out;
  out.reserve(bytes.size() + bytes.size() / 8);
  for (const char byte : bytes) {
    appendUtf8(out, fromWindows1252(static_cast<unsigned char>(byte)));
  }
  return out;
}

/// Control characters that no editor and no card punch leaves in a program. Form feed and Ctrl-Z
/// occur in old decks.
bool binaryByte(unsigned char byte) {
  const bool control =
      byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r' && byte != '\f' && byte != 0x1A;
  return control || byte == 0x7F || (byte >= 0x80 && fromWindows1252(byte) == 0);
}

struct Survey {
  std::optional<std::size_t> firstBinary;  ///< a byte that is text in no encoding known here
  std::optional<std::size_t> firstNotUtf8;
};

Survey survey(const std::string& bytes) {
  Survey found;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto byte = static_cast<unsigned char>(bytes[at]);
    const CodePoint c = byte < 0x80 ? CodePoint{byte, 1} : decodeUtf8(bytes, at);
    if (c.length == 0 && !found.firstNotUtf8) {
      found.firstNotUtf8 = at;
    }
    if (c.length <= 1 && binaryByte(byte)) {
      found.firstBinary = at;
      return found;
    }
    at += c.length == 0 ? 1 : c.length;
  }
  return found;
}

std::string describeByte(unsigned char byte) {
  return byte == 0 ? "a NUL byte" : fmt::format("the byte {:#04x}", static_cast<unsigned>(byte));
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

Result<SourceText> decodeSource(const std::string& name, std::string bytes) {
  SourceText source;
  if (bytes.starts_with("\xEF\xBB\xBF")) {
    bytes.erase(0, 3);
  }
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    return fail(diag::InputNotText, name, "a UTF-16 byte order mark", std::uint64_t{0})
        .withHelp("save it as UTF-8");
  }
  const Survey found = survey(bytes);
  if (found.firstBinary) {
    const auto byte = static_cast<unsigned char>(bytes[*found.firstBinary]);
    return fail(diag::InputNotText, name, describeByte(byte),
                static_cast<std::uint64_t>(*found.firstBinary));
  }
  if (found.firstNotUtf8) {
    const auto byte = static_cast<unsigned char>(bytes[*found.firstNotUtf8]);
    source.warnings.push_back(fail(diag::InputNotUtf8, name,
                                   static_cast<std::uint64_t>(*found.firstNotUtf8),
                                   static_cast<unsigned>(byte)));
    bytes = transcoded(bytes);
  }
  source.text = std::move(bytes);
  return source;
}

}  // namespace arelem::app
