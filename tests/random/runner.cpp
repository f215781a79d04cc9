#include "tests/random/runner.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "tests/random/crew.h"
#include "tests/random/table.h"

namespace arelem::scenes {

namespace {
/// Time of every pair between two writings of the table, seconds. Pairs whose scenes take longer
/// get fewer of them.
constexpr double sliceSeconds = 0.2;
/// Pairs between two writings of the table.
constexpr std::size_t together = 10;

std::size_t pairOf(const std::string& text) {
  const std::size_t comma = text.find(',');
  for (std::size_t pair = 0; pair < pairCount; ++pair) {
    const SceneId id{0, pair, 0};
    if (comma != std::string::npos && text.substr(0, comma) == kinds[id.part()] &&
        text.substr(comma + 1) == kinds[id.drive()]) {
      return pair;
    }
  }
  throw std::runtime_error(fmt::format("no pair `{}`; kinds: {}", text, fmt::join(kinds, " ")));
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

/// A row of the list of failures.
std::string row(const Finding& finding) {
  return spell(finding.id) + "\t" + finding.outcome + "\t" + finding.wrong.front() + "\n";
}

class Runner {
 public:
  explicit Runner(const Request& request)
      : request_(request), crew_(request.jobs), table_(request.seed) {
    if (counts()) {
      table_.read(request.table);
    }
  }

  bool run() {
    if (!request_.only.empty()) {
      const SceneId id = idOf(request_.only);
      fmt::print("{}", drawScene(id).program({}));
      take(crew_.tryAll(std::vector{Slice{id}}));
    } else if (request_.again) {
      repeat();
    } else {
      for (const Finding& finding : listed()) {
        known_.insert(spell(finding.id));
      }
      rounds();
    }
    fmt::print("{}", table_.summary());
    return failed_ == 0;
  }

 private:
  /// A single scene is not counted.
  [[nodiscard]] bool counts() const { return !request_.table.empty() && request_.only.empty(); }

  void rounds() {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t low = request_.pair.empty() ? 0 : pairOf(request_.pair);
    const std::size_t high = request_.pair.empty() ? pairCount : low + 1;
    std::vector<std::uint64_t> next(pairCount, request_.first);
    for (std::size_t pair = low; pair < high && counts(); ++pair) {
      next[pair] = table_.scenes(pair);
    }
    const std::uint64_t end = request_.first + request_.each;
    for (;;) {
      std::vector<Slice> slices;
      for (std::size_t pair = low; pair < high; ++pair) {
        if (next[pair] < end) {
          slices.push_back({{request_.seed, pair, next[pair]}, end - next[pair], sliceSeconds});
        }
      }
      if (slices.empty()) {
        return;
      }
      for (std::size_t i = 0; i < slices.size(); i += together) {
        const std::span<const Slice> some(&slices[i], std::min(together, slices.size() - i));
        const std::vector<Finding> findings = crew_.tryAll(some);
        for (const Finding& finding : findings) {
          next[finding.id.pair] = finding.id.number + 1;
        }
        take(findings);
      }
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      if (request_.minutes && spent.count() > 60.0 * *request_.minutes) {
        return;
      }
    }
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
    if (counts()) {
      table_.write(request_.table);
    }
    std::fflush(stdout);
  }

  void tell(const Finding& finding) {
    const bool known = known_.contains(spell(finding.id));
    failed_ += known ? 0 : 1;
    fmt::print("scene {}{}:\n", spell(finding.id), known ? " (known to fail)" : "");
    for (const std::string& text : finding.wrong) {
      fmt::print("  {}\n", text);
    }
    if (!request_.found.empty()) {
      const Scene scene = drawScene(finding.id);
      const std::string folder = request_.found + "/" + spell(finding.id);
      write(scene, {}, folder + "/drawn");
      write(scene, scene.move, folder + "/moved");
    }
    if (counts() && !request_.failures.empty() && !request_.again && !known) {
      std::ofstream(request_.failures, std::ios::app) << row(finding);
    }
  }

  /// The scenes of the list of failures, with their outcomes then. Comments are kept.
  std::vector<Finding> listed() {
    std::vector<Finding> old;
    std::ifstream in(request_.failures);
    std::string line;
    while (std::getline(in, line)) {
      if (line.empty() || line[0] == '#') {
        comments_ += line + "\n";
        continue;
      }
      std::istringstream cells(line);
      std::string scene, outcome;
      std::getline(cells, scene, '\t');
      std::getline(cells, outcome, '\t');
      old.push_back({idOf(scene), outcome, {"failed"}});
    }
    return old;
  }

  /// The listed failures once more: the table and the list then hold what is true now.
  void repeat() {
    std::vector<Slice> slices;
    for (const Finding& finding : listed()) {
      slices.push_back({finding.id});
      table_.remove(finding);
    }
    const std::vector<Finding> findings = crew_.tryAll(slices);
    std::ofstream out(request_.failures);
    out << comments_;
    for (const Finding& finding : findings) {
      if (!finding.wrong.empty()) {
        out << row(finding);
      }
    }
    take(findings);
  }

  const Request& request_;
  Crew crew_;
  Table table_;
  std::set<std::string> known_;
  std::string comments_;
  std::uint64_t failed_ = 0;
};
}  // namespace

bool run(const Request& request) {
  return Runner(request).run();
}

}  // namespace arelem::scenes
