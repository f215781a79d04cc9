// fuzz TARGET [--rounds N | --seconds S] [--seed N] [--keep FILE] FOLDER...
//
// Runs every file below the folders that suits the target, then changed copies of them, through the
// target. The bytes in work are written to FILE first, so that a crash leaves its input there. What
// takes longer than `slowest` is a failure too.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "tests/fuzz/mutate.h"
#include "tests/fuzz/targets.h"

namespace {
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
constexpr double slowest = 10.0;  // seconds, with sanitizers

struct Plan {
  const arelem::fuzz::Target* target = nullptr;
  std::uint64_t rounds = 0;
  double seconds = 0.0;
  std::uint64_t seed = 1;
  std::string keep;
  std::vector<std::string> folders;
};

std::vector<std::string> readCorpus(const arelem::fuzz::Target& target,
                                    const std::vector<std::string>& folders) {
  std::vector<fs::path> paths;
  for (const std::string& folder : folders) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (std::count(target.suffixes.begin(), target.suffixes.end(),
                     entry.path().extension().string()) > 0) {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const fs::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    std::string bytes = std::move(text).str();
    if (!target.compiledTo.empty()) {
      bytes = arelem::fuzz::compiled(bytes, target.compiledTo);
    }
    if (!bytes.empty()) {
      texts.push_back(std::move(bytes));
    }
  }
  return texts;
}

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

bool runOne(const Plan& plan, const std::string& text) {
  if (!plan.keep.empty()) {
    std::ofstream(plan.keep, std::ios::binary) << text;
  }
  // Of this process: others on the machine do not count.
  const std::clock_t start = std::clock();
  plan.target->run(text);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  if (seconds <= slowest) {
    return true;
  }
  std::cerr << "a text of " << text.size() << " bytes took " << seconds << " s\n";
  return false;
}

int run(const Plan& plan) {
  const std::vector<std::string> corpus = readCorpus(*plan.target, plan.folders);
  if (corpus.empty()) {
    std::cerr << "no files for this target in the folders\n";
    return 2;
  }
  const auto start = Clock::now();
  bool good = true;
  for (const std::string& text : corpus) {
    good = runOne(plan, text) && good;
  }
  arelem::fuzz::Mutator mutator(corpus, plan.seed);
  std::uint64_t rounds = 0;
  while (good && (rounds < plan.rounds || since(start) < plan.seconds)) {
    good = runOne(plan, mutator.next());
    ++rounds;
  }
  std::cout << corpus.size() << " texts and " << rounds << " changed ones in " << since(start)
            << " s\n";
  return good ? 0 : 1;
}
}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  Plan plan;
  for (const arelem::fuzz::Target& target : arelem::fuzz::targets()) {
    plan.target = !words.empty() && words[0] == target.name ? &target : plan.target;
  }
  for (std::size_t i = 1; i < words.size(); ++i) {
    const bool option = words[i].starts_with("--") && i + 1 < words.size();
    if (option && words[i] == "--rounds") {
      plan.rounds = std::stoull(words[++i]);
    } else if (option && words[i] == "--seconds") {
      plan.seconds = std::stod(words[++i]);
    } else if (option && words[i] == "--seed") {
      plan.seed = std::stoull(words[++i]);
    } else if (option && words[i] == "--keep") {
      plan.keep = words[++i];
    } else {
      plan.folders.push_back(words[i]);
    }
  }
  if (plan.target == nullptr || plan.folders.empty()) {
    std::cerr << "fuzz TARGET [--rounds N | --seconds S] [--seed N] [--keep FILE] FOLDER...\n"
                 "targets:";
    for (const arelem::fuzz::Target& target : arelem::fuzz::targets()) {
      std::cerr << ' ' << target.name;
    }
    std::cerr << '\n';
    return 2;
  }
  return run(plan);
}
