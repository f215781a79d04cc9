#include "tests/random/runner.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/random/crew.h"
#include "tests/random/table.h"

namespace arelem::scenes {

namespace {
/// Scenes of every pair between two writings of the table.
constexpr std::uint64_t roundLength = 5;

std::size_t pairOf(const std::string& text) {
  const std::size_t comma = text.find(',');
  for (std::size_t pair = 0; pair < pairCount; ++pair) {
    const SceneId id{0, pair, 0};
    if (comma != std::string::npos && text.substr(0, comma) == kinds[id.part()] &&
        text.substr(comma + 1) == kinds[id.drive()]) {
      return pair;
    }
  }
  throw std::runtime_error(
      fmt::format("no pair `{}`; kinds: {}", text, fmt::join(kinds, " ")));
}

/// The inverse of spell(id).
SceneId idOf(const std::string& text) {
  const std::size_t colon = text.find(':'), comma = text.rfind(',');
  if (colon == std::string::npos || comma == std::string::npos || comma < colon) {
    throw std::runtime_error("no scene `" + text + "`; it is SEED:PART,DRIVE,NUMBER");
  }
  return {std::stoull(text.substr(0, colon)), pairOf(text.substr(colon + 1, comma - colon - 1)),
          std::stoull(text.substr(comma + 1))};
}

void write(const Scene& scene, const Similarity& to, const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/scene.apt") << scene.program(to);
  writeFiles(scene, to, folder + "/");
}

class Runner {
 public:
  explicit Runner(const Request& request)
      : request_(request), crew_(request.jobs), table_(request.seed) {
    if (!request.table.empty()) {
      table_.read(request.table);
    }
  }

  bool run() {
    if (!request_.only.empty()) {
      const SceneId id = idOf(request_.only);
      fmt::print("{}", drawScene(id).program({}));
      take(crew_.tryAll(std::vector{id}));
    } else if (request_.again) {
      repeat();
    } else {
      rounds();
    }
    fmt::print("{}", table_.summary());
    return failed_ == 0;
  }

 private:
  void rounds() {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t low = request_.pair.empty() ? 0 : pairOf(request_.pair);
    const std::size_t high = request_.pair.empty() ? pairCount : low + 1;
    for (;;) {
      std::vector<SceneId> ids;
      for (std::uint64_t k = 0; k < roundLength; ++k) {
        for (std::size_t pair = low; pair < high; ++pair) {
          const std::uint64_t number = next(pair) + k;
          if (number < request_.first + request_.each) {
            ids.push_back({request_.seed, pair, number});
          }
        }
      }
      if (ids.empty()) {
        return;
      }
      done_ += roundLength;
      take(crew_.tryAll(ids));
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      if (request_.minutes && spent.count() > 60.0 * *request_.minutes) {
        return;
      }
    }
  }

  /// The first number that was not run. With a table, that behind its scenes.
  std::uint64_t next(std::size_t pair) const {
    return request_.table.empty() ? request_.first + done_ : table_.scenes(pair);
  }

  void take(const std::vector<Finding>& findings) {
    for (const Finding& finding : findings) {
      table_.add(finding);
      if (!finding.wrong.empty()) {
        tell(finding);
      }
      if (finding.seconds > request_.slow) {
        fmt::print("scene {} takes {:.2f} s: {}\n", spell(finding.id), finding.seconds,
                   finding.outcome);
      }
    }
    if (!request_.table.empty()) {
      table_.write(request_.table);
    }
    std::fflush(stdout);
  }

  void tell(const Finding& finding) {
    ++failed_;
    fmt::print("scene {}:\n", spell(finding.id));
    for (const std::string& text : finding.wrong) {
      fmt::print("  {}\n", text);
    }
    if (!request_.found.empty()) {
      const Scene scene = drawScene(finding.id);
      const std::string folder = request_.found + "/" + spell(finding.id);
      write(scene, {}, folder + "/drawn");
      write(scene, scene.move, folder + "/moved");
    }
    if (!request_.failures.empty() && !request_.again) {
      std::ofstream(request_.failures, std::ios::app)
          << spell(finding.id) << "\t" << finding.outcome << "\t" << finding.wrong.front() << "\n";
    }
  }

  /// The listed failures once more: the table and the list then hold what is true now.
  void repeat() {
    std::vector<SceneId> ids;
    std::vector<Finding> old;
    std::ifstream in(request_.failures);
    std::string line, comments;
    while (std::getline(in, line)) {
      std::istringstream cells(line);
      std::string scene, outcome;
      if (line.empty() || line[0] == '#') {
        comments += line + "\n";
        continue;
      }
      std::getline(cells, scene, '\t');
      std::getline(cells, outcome, '\t');
      ids.push_back(idOf(scene));
      old.push_back({ids.back(), outcome, {"failed"}});
    }
    in.close();
    for (const Finding& finding : old) {
      table_.remove(finding);
    }
    const std::vector<Finding> findings = crew_.tryAll(ids);
    std::ofstream out(request_.failures);
    out << comments;
    for (const Finding& finding : findings) {
      if (!finding.wrong.empty()) {
        out << spell(finding.id) << "\t" << finding.outcome << "\t" << finding.wrong.front()
            << "\n";
      }
    }
    take(findings);
  }

  const Request& request_;
  Crew crew_;
  Table table_;
  std::uint64_t done_ = 0, failed_ = 0;
};
}  // namespace

bool run(const Request& request) {
  return Runner(request).run();
}

}  // namespace arelem::scenes
