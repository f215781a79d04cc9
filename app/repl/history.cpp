#include "app/repl/history.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "backend/atomic_file.h"

namespace arelem::app::repl {

namespace {
constexpr std::size_t mostLines = 5000;
constexpr std::uintmax_t mostBytes = 16'000'000;

std::string environment(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): read once at the start
  return value == nullptr ? "" : value;
}
}  // namespace

std::string History::usualPath() {
  const std::string state = environment("XDG_STATE_HOME");
  const std::string home = environment("HOME");
  if (!state.empty()) {
    return state + "/arelem/history";
  }
  return home.empty() ? "" : home + "/.local/state/arelem/history";
}

History::History(std::string path) : path_(std::move(path)) {
  if (path_.empty()) {
    return;
  }
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path(), error);
  if (error) {
    complain(error.message());
    return;
  }
  read();
}

void History::read() {
  std::error_code error;
  if (!std::filesystem::exists(path_, error)) {
    return;
  }
  if (!std::filesystem::is_regular_file(path_, error) ||
      std::filesystem::file_size(path_, error) > mostBytes) {
    complain("it is no file of a history");
    return;
  }
  std::ifstream in(path_);
  for (std::string line; std::getline(in, line);) {
    lines_.push_back(line);
  }
  if (lines_.size() <= 2 * mostLines) {
    return;
  }
  lines_.erase(lines_.begin(), lines_.end() - mostLines);
  auto file = backend::AtomicFile::create(path_);
  if (file) {
    for (const std::string& line : lines_) {
      file->stream() << line << '\n';
    }
    if (const auto failure = file->commit()) {
      complain(failure->message);
    }
  }
}

void History::add(const std::string& line) {
  if (path_.empty() || line.empty() || (!lines_.empty() && lines_.back() == line)) {
    return;
  }
  lines_.push_back(line);
  // One write of a whole line: two sessions do not mix their letters.
  const int file = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) {
    complain(std::generic_category().message(errno));
    return;
  }
  const std::string text = line + '\n';
  const ssize_t written = ::write(file, text.data(), text.size());
  const int reason = written < 0 ? errno : ENOSPC;
  ::close(file);
  if (written != static_cast<ssize_t>(text.size())) {
    complain(std::generic_category().message(reason));
  }
}

void History::complain(const std::string& what) {
  complaint_ = "the history file `" + path_ + "` cannot be kept: " + what +
               "; the session goes on without it";
  path_.clear();
}

std::optional<std::string> History::complaint() {
  std::optional<std::string> text = std::move(complaint_);
  complaint_.reset();
  return text;
}

}  // namespace arelem::app::repl
