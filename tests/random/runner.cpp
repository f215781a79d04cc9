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
#include "tests/random/times.h"

namespace arelem::scenes {

namespace {
/// Scenes that a pair may be ahead of another one.
constexpr std::uint64_t ahead = 10;
/// Scenes between two writings of the table.
constexpr std::uint64_t together = 100;

std::size_t kindOf(const std::string& text) {
  const auto* found = std::find(kinds.begin(), kinds.end(), text);
  if (found == kinds.end()) {
    throw std::runtime_error(fmt::format("no kind `{}`; kinds: {}", text, fmt::join(kinds, " ")));
  }
  return static_cast<std::size_t>(found - kinds.begin());
}

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

std::string_view word(Concern concern) {
  return concern == Concern::path ? "path" : "refusal";
}

/// A row of the list of failures.
std::string row(const Finding& finding) {
  const Fault& fault = *finding.worst();
  return fmt::format("{}\t{}\t{}\t{}\n", spell(finding.id), word(fault.concern), finding.outcome,
                     fault.text);
}

/// The inverse of it.
Finding findingOf(const std::string& line) {
  std::istringstream cells(line);
  std::string scene, concern, outcome, text;
  std::getline(cells, scene, '\t');
  std::getline(cells, concern, '\t');
  std::getline(cells, outcome, '\t');
  std::getline(cells, text);
  for (const Concern one : {Concern::path, Concern::refusal}) {
    if (concern == word(one)) {
      return {idOf(scene), outcome, {{one, text}}};
    }
  }
  throw std::runtime_error("not a row of the list of failures: " + line);
}

class Runner {
 public:
  explicit Runner(const Request& request)
      : request_(request), crew_(request.jobs), table_(request.seed) {
    if (counts() && !request.anew) {
      table_.read(request.table);
    }
    if (!request.commit.empty()) {
      table_.setCommit(request.commit);
    }
  }

  bool run() {
    if (!request_.only.empty()) {
      const SceneId id = idOf(request_.only);
      fmt::print("{}", drawScene(id).program({}));
      keep(id);
      std::fflush(stdout);
      tryAll(std::vector{id});
    } else if (request_.again) {
      repeat();
    } else {
      for (const Finding& finding : listed()) {
        known_.insert(spell(finding.id));
      }
      if (counts() && request_.anew && !request_.failures.empty()) {
        std::ofstream(request_.failures) << comments_;
      }
      rounds();
    }
    fmt::print("{}{}", request_.times ? times_.table() : "", table_.summary());
    return failed_ == 0;
  }

 private:
  /// A single scene is not counted.
  [[nodiscard]] bool counts() const { return !request_.table.empty() && request_.only.empty(); }

  /// The pairs that are asked for.
  [[nodiscard]] std::vector<std::size_t> pairs() const {
    if (!request_.pair.empty()) {
      return {pairOf(request_.pair)};
    }
    std::vector<bool> wanted(kinds.size(), request_.kinds.empty());
    for (const std::string& kind : request_.kinds) {
      wanted[kindOf(kind)] = true;
    }
    std::vector<std::size_t> all;
    for (std::size_t pair = 0; pair < pairCount; ++pair) {
      const SceneId id{0, pair, 0};
      if (wanted[id.part()] && wanted[id.drive()]) {
        all.push_back(pair);
      }
    }
    return all;
  }

  /// All pairs go on alike: those with the fewest scenes first.
  void rounds() {
    std::vector<std::uint64_t> next(pairCount, request_.first);
    const std::uint64_t end = request_.first + request_.each;
    std::uint64_t goal = end;
    for (const std::size_t pair : pairs()) {
      next[pair] = counts() ? table_.scenes(pair) : request_.first;
      goal = std::min(goal, next[pair]);
    }
    std::vector<SceneId> ids;
    while (goal < end) {
      goal = std::min(goal + ahead, end);
      for (const std::size_t pair : pairs()) {
        for (std::uint64_t number = next[pair]; number < goal; ++number) {
          ids.push_back({request_.seed, pair, number});
        }
        next[pair] = std::max(next[pair], goal);
      }
    }
    tryAll(ids);
  }

  /// Takes the findings of these scenes as they come, until the time is over.
  void tryAll(std::span<const SceneId> ids) {
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t unwritten = 0;
    crew_.tryAll(ids, [&](const Finding& finding) {
      table_.add(finding);
      take(finding);
      if (++unwritten >= together) {
        writeTable();
        unwritten = 0;
      }
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
      return !request_.minutes || spent.count() < 60.0 * *request_.minutes;
    });
    writeTable();
  }

  void writeTable() const {
    if (counts()) {
      table_.write(request_.table);
    }
  }

  void take(const Finding& finding) {
    times_.add(finding);
    if (!finding.wrong.empty()) {
      tell(finding);
    }
    if (finding.seconds > request_.slow) {
      fmt::print("scene {} takes {:.3f} s (motion {:.3f}, proof {:.3f}, moved {:.3f}): {}\n",
                 spell(finding.id), finding.seconds, finding.computing, finding.proving,
                 finding.moved, finding.outcome);
    }
    std::fflush(stdout);
  }

  void tell(const Finding& finding) {
    const bool known = !request_.anew && known_.contains(spell(finding.id));
    failed_ += known ? 0 : 1;
    fmt::print("scene {}{}:\n", spell(finding.id), known ? " (known to fail)" : "");
    for (const Fault& fault : finding.wrong) {
      fmt::print("  {}: {}\n", word(fault.concern), fault.text);
    }
    if (request_.only.empty()) {
      keep(finding.id);
    }
    if (counts() && !request_.failures.empty() && !request_.again && !known) {
      std::ofstream(request_.failures, std::ios::app) << row(finding);
    }
  }

  /// Program and files of a scene, as drawn and moved, into the folder that was asked for.
  void keep(const SceneId& id) const {
    if (request_.found.empty()) {
      return;
    }
    const Scene scene = drawScene(id);
    const std::string folder = request_.found + "/" + spell(id);
    write(scene, {}, folder + "/drawn");
    write(scene, scene.move, folder + "/moved");
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
      old.push_back(findingOf(line));
    }
    return old;
  }

  /// The listed failures once more: the table and the list then hold what is true now. Scenes of
  /// other seeds, and those far behind, are in the list only.
  void repeat() {
    const std::vector<Finding> old = listed();
    std::vector<SceneId> ids;
    for (const Finding& finding : old) {
      ids.push_back(finding.id);
    }
    std::vector<Finding> now;
    crew_.tryAll(ids, [&](const Finding& finding) {
      now.push_back(finding);
      take(finding);
      return true;
    });
    // Only now: a run that is stopped leaves table and list as they were.
    std::ofstream out(request_.failures);
    out << comments_;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i].seed == request_.seed && ids[i].number < table_.scenes(ids[i].pair)) {
        table_.remove(old[i]);
        table_.add(now[i]);
      }
      if (!now[i].wrong.empty()) {
        out << row(now[i]);
      }
    }
    writeTable();
  }

  const Request& request_;
  Crew crew_;
  Table table_;
  Times times_;
  std::set<std::string> known_;
  std::string comments_;
  std::uint64_t failed_ = 0;
};
}  // namespace

bool run(const Request& request) {
  return Runner(request).run();
}

}  // namespace arelem::scenes
