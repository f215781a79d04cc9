#include "tests/random/table.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

namespace arelem::scenes {

namespace {
constexpr std::string_view commitsHead = "# motion as of ";
constexpr std::string_view head =
    "# part, drive, scenes, computed, refused with a cause, of these confirmed by a search of its "
    "own, failed by their path, failed by their refusal, refusals by code\n";

std::size_t kindOf(const std::string& name) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == name) {
      return i;
    }
  }
  throw std::runtime_error("no kind " + name);
}
}  // namespace

void Table::count(const Finding& finding, std::uint64_t change) {
  Row& row = rows_[finding.id.pair];
  row.scenes += change;
  if (const Fault* const fault = finding.worst()) {
    (fault->concern == Concern::path ? row.paths : row.refusals) += change;
  } else if (finding.outcome == "computed") {
    row.computed += change;
  } else {
    row.refused += change;
    row.codes[finding.outcome] += change;
    row.confirmed += finding.confirmed ? change : 0;
  }
}

void Table::add(const Finding& finding) {
  count(finding, 1);
}

void Table::remove(const Finding& finding) {
  count(finding, ~std::uint64_t{0});  // one less, modulo 2^64
}

void Table::setCommit(const std::string& commit) {
  if (std::ranges::find(commits_, commit) == commits_.end()) {
    commits_.push_back(commit);
  }
}

void Table::read(const std::string& path) {
  std::ifstream in(path);
  if (!in) {
    return;
  }
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string part, drive, code;
    if (line.starts_with("# seed ")) {
      if (line != fmt::format("# seed {}", seed_)) {
        throw std::runtime_error(path + " is of another seed: " + line);
      }
      continue;
    }
    if (line.starts_with(commitsHead)) {
      std::istringstream commits(line.substr(commitsHead.size()));
      commits_.assign(std::istream_iterator<std::string>(commits), {});
    }
    if (line.empty() || line[0] == '#') {
      continue;
    }
    cells >> part >> drive;
    Row& row = rows_[kindOf(part) * kinds.size() + kindOf(drive)];
    if (!(cells >> row.scenes >> row.computed >> row.refused >> row.confirmed >> row.paths >>
          row.refusals)) {
      throw std::runtime_error(path + ": not a row: " + line);
    }
    while (cells >> code) {
      const std::size_t colon = code.find(':');
      if (colon == std::string::npos) {
        throw std::runtime_error(path + ": not a count: " + code);
      }
      row.codes[code.substr(0, colon)] = std::stoull(code.substr(colon + 1));
    }
  }
}

void Table::write(const std::string& path) const {
  std::string text = fmt::format("# seed {}\n", seed_);
  if (!commits_.empty()) {
    text += fmt::format("{}{}\n", commitsHead, fmt::join(commits_, " "));
  }
  text += head;
  for (std::size_t pair = 0; pair < pairCount; ++pair) {
    const Row& row = rows_[pair];
    if (row.scenes == 0) {
      continue;
    }
    const SceneId id{seed_, pair, 0};
    text +=
        fmt::format("{}\t{}\t{}\t{}\t{}\t{}\t{}\t{}\t", kinds[id.part()], kinds[id.drive()],
                    row.scenes, row.computed, row.refused, row.confirmed, row.paths, row.refusals);
    const char* space = "";
    for (const auto& [code, count] : row.codes) {
      if (count > 0) {
        text += fmt::format("{}{}:{}", space, code, count);
        space = " ";
      }
    }
    text += "\n";
  }
  // A run that is stopped leaves the old table or the new one.
  const std::string beside = path + ".new";
  std::ofstream(beside) << text;
  std::filesystem::rename(beside, path);
}

std::string Table::summary() const {
  Row all;
  for (const Row& row : rows_) {
    all.scenes += row.scenes;
    all.computed += row.computed;
    all.refused += row.refused;
    all.confirmed += row.confirmed;
    all.paths += row.paths;
    all.refusals += row.refusals;
    for (const auto& [code, count] : row.codes) {
      all.codes[code] += count;
    }
  }
  std::string text = fmt::format(
      "{} scenes: {} computed, {} refused ({} confirmed), {} failed by their path, {} by their "
      "refusal\n",
      all.scenes, all.computed, all.refused, all.confirmed, all.paths, all.refusals);
  for (const auto& [code, count] : all.codes) {
    text += fmt::format("{:9d} {}\n", count, code);
  }
  return text;
}

}  // namespace arelem::scenes
