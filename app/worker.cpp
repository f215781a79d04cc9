#include "app/worker.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace arelem::app {

namespace {
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds poll{5};
constexpr int tallyDescriptor = 3;
/// More of what one job says is cut off.
constexpr std::size_t mostMessages = 1'000'000;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string contents(std::FILE* file) {
  std::string text;
  std::rewind(file);
  std::array<char, 4096> buffer{};
  for (std::size_t n = 1; n > 0 && text.size() < mostMessages;) {
    n = std::fread(buffer.data(), 1, buffer.size(), file);
    text.append(buffer.data(), n);
  }
  return text;
}

/// One process at work.
struct Worker {
  pid_t process = 0;
  std::size_t index = 0;
  Clock::time_point since;
  File messages, tally;
};

/// Signals of the worker are its own again: the batch blocks them for its watching thread.
bool spawn(Worker& worker, const std::vector<std::string>& words) {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&files);
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  sigset_t usual;
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, ::fileno(worker.messages.get()), STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&files, ::fileno(worker.tally.get()), tallyDescriptor);
  std::vector<char*> arguments;
  for (const std::string& word : words) {
    arguments.push_back(const_cast<char*>(word.c_str()));  // exec() changes no argument
  }
  arguments.push_back(nullptr);
  const int error = posix_spawn(&worker.process, "/proc/self/exe", &files, &attributes,
                                arguments.data(), ::environ);
  posix_spawn_file_actions_destroy(&files);
  posix_spawnattr_destroy(&attributes);
  return error == 0;
}

ExitCode codeOf(int status) {
  return WIFEXITED(status) ? static_cast<ExitCode>(WEXITSTATUS(status)) : ExitCode::internalError;
}

class Pool {
 public:
  Pool(const std::vector<std::string>& inputs,
       const std::vector<std::string>& options,
       const InterruptFlag& interrupted,
       const JobCall& done)
      : options_(options), interrupted_(interrupted), done_(done), ended_(inputs.size(), false) {
    for (const std::string& input : inputs) {
      results_.emplace_back().input = input;
    }
  }

  std::vector<JobResult> run(std::size_t atOnce) {
    bool told = false;
    while (next_ < results_.size() || !atWork_.empty()) {
      if (interrupted_ && !told) {
        told = true;
        abandon();
      }
      while (!told && next_ < results_.size() && atWork_.size() < atOnce) {
        start(next_++);
      }
      if (!collect() && !atWork_.empty()) {
        std::this_thread::sleep_for(poll);
      }
    }
    return std::move(results_);
  }

 private:
  void start(std::size_t index) {
    Worker worker;
    worker.index = index;
    worker.since = Clock::now();
    worker.messages.reset(std::tmpfile());
    worker.tally.reset(std::tmpfile());
    std::vector<std::string> words = {"arelem", "compile"};
    words.insert(words.end(), options_.begin(), options_.end());
    words.insert(words.end(),
                 {"--tally", fmt::format("{}", tallyDescriptor), "--", results_[index].input});
    if (!worker.messages || !worker.tally || !spawn(worker, words)) {
      results_[index].code = ExitCode::internalError;
      results_[index].messages = "arelem: error: no process can be started for the job\n";
      finish(index);
      return;
    }
    atWork_.push_back(std::move(worker));
  }

  /// Takes in what has ended; false when nothing has.
  bool collect() {
    bool any = false;
    for (std::size_t i = 0; i < atWork_.size();) {
      int status = 0;
      if (::waitpid(atWork_[i].process, &status, WNOHANG) == 0) {
        ++i;
        continue;
      }
      any = true;
      take(atWork_[i], status);
      atWork_.erase(atWork_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return any;
  }

  void take(const Worker& worker, int status) {
    JobResult& result = results_[worker.index];
    result.code = codeOf(status);
    result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result.seconds = std::chrono::duration<double>(Clock::now() - worker.since).count();
    result.messages = contents(worker.messages.get());
    if (result.signal != 0) {
      result.messages +=
          fmt::format("arelem: error: the job was ended by signal {}\n", result.signal);
    }
    const std::string tally = contents(worker.tally.get());
    unsigned long long errors = 0, warnings = 0, vectors = 0;
    if (std::sscanf(tally.c_str(), "%llu %llu %llu", &errors, &warnings, &vectors) == 3) {
      result.errors = errors;
      result.warnings = warnings;
      result.cutVectors = vectors;
    }
    finish(worker.index);
  }

  void finish(std::size_t index) {
    ended_[index] = true;
    while (shown_ < ended_.size() && ended_[shown_]) {
      done_(shown_, results_[shown_]);
      ++shown_;
    }
  }

  void abandon() {
    for (const Worker& worker : atWork_) {
      ::kill(worker.process, SIGTERM);
    }
    for (; next_ < results_.size(); ++next_) {
      results_[next_].code = ExitCode::interrupted;
      ended_[next_] = true;
    }
  }

  const std::vector<std::string>& options_;
  const InterruptFlag& interrupted_;
  const JobCall& done_;
  std::vector<JobResult> results_;
  std::vector<bool> ended_;
  std::vector<Worker> atWork_;
  std::size_t next_ = 0;
  std::size_t shown_ = 0;
};
}  // namespace

std::vector<std::string> optionsOnly(const CLI::App& app,
                                     const std::vector<std::string>& words,
                                     const std::vector<std::string>& without) {
  std::vector<std::string> kept;
  for (std::size_t i = 0; i < words.size() && words[i] != "--"; ++i) {
    const std::string& word = words[i];
    if (word.size() < 2 || word[0] != '-') {
      continue;  // an input
    }
    const bool isLong = word[1] == '-';
    const std::size_t equals = word.find('=');
    const std::string name = isLong ? word.substr(0, equals) : word.substr(0, 2);
    const CLI::Option* option = app.get_option_no_throw(name);
    const bool attached = isLong ? equals != std::string::npos : word.size() > 2;
    const bool takesNext = option != nullptr && option->get_items_expected_max() > 0 && !attached;
    const bool dropped = std::find(without.begin(), without.end(), name) != without.end();
    if (!dropped) {
      kept.push_back(word);
    }
    if (takesNext && i + 1 < words.size()) {
      ++i;
      if (!dropped) {
        kept.push_back(words[i]);
      }
    }
  }
  return kept;
}

std::vector<JobResult> runWorkers(const std::vector<std::string>& inputs,
                                  const std::vector<std::string>& options,
                                  std::size_t atOnce,
                                  const InterruptFlag& interrupted,
                                  const JobCall& done) {
  return Pool(inputs, options, interrupted, done).run(std::max<std::size_t>(1, atOnce));
}

bool writeTally(int descriptor,
                std::uint64_t errors,
                std::uint64_t warnings,
                std::uint64_t cutVectors) {
  const std::string line = fmt::format("{} {} {}\n", errors, warnings, cutVectors);
  return ::write(descriptor, line.data(), line.size()) == static_cast<ssize_t>(line.size());
}

}  // namespace arelem::app
