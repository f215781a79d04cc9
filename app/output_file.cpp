#include "app/output_file.h"

#include <cerrno>
#include <csignal>
#include <sstream>
#include <system_error>

#include <unistd.h>

#include "backend/atomic_file.h"
#include "backend/file_stream.h"
#include "ir/diag/output.h"

namespace arelem::app {

namespace {
/// The reader of a pipe has seen enough: end as every filter does, without a message.
[[noreturn]] void endAsFilter() {
  backend::AtomicFile::removeTemporaries();
  std::signal(SIGPIPE, SIG_DFL);
  std::raise(SIGPIPE);
  ::_exit(128 + SIGPIPE);
}

class NamedOutput : public OutputFile {
 public:
  NamedOutput(std::string path, backend::AtomicFile file)
      : path_(std::move(path)), file_(std::move(file)) {}
  std::ostream& stream() override { return file_.stream(); }
  Result<std::uint64_t> complete() override { return file_.complete(); }
  Result<std::string> commit(bool partial) override {
    const std::string suffix = partial ? ".partial" : "";
    if (std::optional<Failure> failure = file_.commit(suffix)) {
      return *std::move(failure);
    }
    return path_ + suffix;
  }

 private:
  std::string path_;
  backend::AtomicFile file_;
};

/// Nothing goes to standard output before the result is complete.
class StandardOutput : public OutputFile {
 public:
  std::ostream& stream() override { return stream_; }
  Result<std::uint64_t> complete() override {
    return static_cast<std::uint64_t>(stream_.view().size());
  }
  Result<std::string> commit(bool partial) override {
    if (partial) {
      return std::string{};
    }
    backend::FileStreamBuffer out(STDOUT_FILENO);
    const std::string_view bytes = stream_.view();
    out.sputn(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.pubsync();
    const int error = out.error();
    if (error == EPIPE) {
      endAsFilter();
    }
    if (error != 0) {
      return fail(diag::OutputOpen, "standard output", std::generic_category().message(error));
    }
    return std::string("-");
  }

 private:
  std::ostringstream stream_;
};
}  // namespace

Result<std::unique_ptr<OutputFile>> openOutput(const std::string& path) {
  if (path == "-") {
    return std::unique_ptr<OutputFile>(std::make_unique<StandardOutput>());
  }
  Result<backend::AtomicFile> file = backend::AtomicFile::create(path);
  if (!file) {
    return file.takeFailure();
  }
  return std::unique_ptr<OutputFile>(std::make_unique<NamedOutput>(path, *std::move(file)));
}

}  // namespace arelem::app
