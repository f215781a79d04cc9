#include "app/output_file.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <sstream>

#include "app/temporary_files.h"
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace arelem::app {

namespace {
namespace fs = std::filesystem;

Failure refusal(const std::string& path, int number) {
  return fail(diag::OutputUnwritable, path == "-" ? "standard output" : path,
              std::strerror(number));
}

/// Writes all bytes; 0 or the error number.
int writeAll(int fd, const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t done = ::write(fd, bytes, size);
    if (done < 0 && errno == EINTR) {
      continue;
    }
    if (done < 0) {
      return errno;
    }
    bytes += done;
    size -= static_cast<std::size_t>(done);
  }
  return 0;
}

/// A stream buffer on a file descriptor that remembers the first error.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int fd) : fd_(fd), block_(1U << 16U) {
    setp(block_.data(), block_.data() + block_.size());
  }
  [[nodiscard]] int error() const { return error_; }
  [[nodiscard]] std::uint64_t written() const { return written_; }

 protected:
  int_type overflow(int_type c) override {
    if (sync() != 0) {
      return traits_type::eof();
    }
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(c);
      pbump(1);
    }
    return traits_type::not_eof(c);
  }
  int sync() override {
    const auto size = static_cast<std::size_t>(pptr() - pbase());
    if (error_ == 0) {
      error_ = writeAll(fd_, pbase(), size);
      written_ += size;
    }
    setp(block_.data(), block_.data() + block_.size());
    return error_ == 0 ? 0 : -1;
  }

 private:
  int fd_;
  int error_ = 0;
  std::uint64_t written_ = 0;
  std::vector<char> block_;
};

/// A regular file: temporary name, fsync, rename.
class AtomicOutput : public OutputFile {
 public:
  AtomicOutput(std::string path, std::string temporary, int fd)
      : path_(std::move(path)),
        temporary_(std::move(temporary)),
        fd_(fd),
        buffer_(fd),
        stream_(&buffer_) {}
  ~AtomicOutput() override {
    if (fd_ >= 0) {
      ::close(fd_);
    }
    removeTemporary(temporary_);
  }

  std::ostream& stream() override { return stream_; }

  Result<std::uint64_t> complete() override {
    stream_.flush();
    if (buffer_.error() != 0) {
      return refusal(path_, buffer_.error());
    }
    if (::fsync(fd_) != 0 && errno != EINVAL) {
      return refusal(path_, errno);
    }
    const int closed = ::close(std::exchange(fd_, -1));
    if (closed != 0) {
      return refusal(path_, errno);
    }
    return buffer_.written();
  }

  Result<std::string> commit(bool partial) override {
    const std::string name = partial ? path_ + ".partial" : path_;
    if (::rename(temporary_.c_str(), name.c_str()) != 0) {
      return refusal(name, errno);
    }
    forgetTemporary(temporary_);
    return name;
  }

 private:
  std::string path_, temporary_;
  int fd_;
  DescriptorBuffer buffer_;
  std::ostream stream_;
};

/// Standard output, a device or a pipe: nothing goes there before the result is complete.
class MemoryOutput : public OutputFile {
 public:
  explicit MemoryOutput(std::string path) : path_(std::move(path)) {}
  std::ostream& stream() override { return stream_; }

  Result<std::uint64_t> complete() override {
    return static_cast<std::uint64_t>(stream_.view().size());
  }

  Result<std::string> commit(bool partial) override {
    if (partial) {
      return std::string{};
    }
    const int fd = path_ == "-" ? STDOUT_FILENO : ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd < 0) {
      return refusal(path_, errno);
    }
    int error = writeAll(fd, stream_.view().data(), stream_.view().size());
    if (fd != STDOUT_FILENO && ::close(fd) != 0 && error == 0) {
      error = errno;
    }
    if (error == EPIPE) {  // the reader has seen enough: end as a filter does, without a message
      std::signal(SIGPIPE, SIG_DFL);
      removeTemporaries();
      std::raise(SIGPIPE);
    }
    if (error != 0) {
      return refusal(path_, error);
    }
    return path_;
  }

 private:
  std::string path_;
  std::ostringstream stream_;
};

/// The file that a symbolic link leads to: the link itself must stay.
std::string linkTarget(const std::string& path) {
  std::error_code error;
  return fs::is_symlink(path, error) ? fs::weakly_canonical(path, error).string() : path;
}
}  // namespace

Result<std::unique_ptr<OutputFile>> openOutput(const std::string& path) {
  struct stat status {};
  const bool exists = path != "-" && ::stat(path.c_str(), &status) == 0;
  if (path == "-" || (exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode))) {
    return std::unique_ptr<OutputFile>(std::make_unique<MemoryOutput>(path));
  }
  if (exists && S_ISDIR(status.st_mode)) {
    return refusal(path, EISDIR);
  }
  const fs::path target = linkTarget(path);
  const std::string temporary =
      (target.parent_path() / fmt::format(".{}.{}.part", target.filename().string(), ::getpid()))
          .string();
  const mode_t mode = exists ? status.st_mode & 0777U : 0666U;
  const int fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (fd < 0) {
    return refusal(path, errno);
  }
  rememberTemporary(temporary);
  return std::unique_ptr<OutputFile>(
      std::make_unique<AtomicOutput>(target.string(), temporary, fd));
}

}  // namespace arelem::app
