#include "ir/hole/cycle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ir/diag/ngc.h"

namespace arelem::hole {

namespace {
/// A cycle has at most so many pecks a hole: each is several moves where they are written out.
constexpr double mostPecks = 10000.0;

class Reader {
 public:
  explicit Reader(const cl::Post& post) : values_(post.arguments) {}

  Result<Cycle> read() {
    const std::string type = spelling(0);
    if (type == "DEEP" || type == "DEEP2") {
      cycle_.kind = Cycle::Kind::peck;
    } else if (type == "BRKCHP") {
      cycle_.kind = Cycle::Kind::chip;
    } else if (type == "BORE" || type == "REAM") {
      cycle_.kind = Cycle::Kind::bore;
    } else if (type == "TAP") {
      cycle_.kind = Cycle::Kind::tap;
    } else if (type != "DRILL" && type != "FACE") {
      return fail(diag::NgcCycle, "/" + type +
                                      " has no canned cycle here; there are DRILL, FACE, "
                                      "REAM, BORE, TAP, DEEP and BRKCHP");
    }
    for (next_ = 1; next_ < values_.size();) {
      if (!item()) {
        return fail(diag::NgcCycle,
                    fmt::format("has something else than a number after `{}`", spelling(next_)));
      }
    }
    return checked();
  }

 private:
  [[nodiscard]] std::string spelling(std::size_t i) const {
    if (i >= values_.size()) {
      return "";
    }
    if (const Word* word = std::get_if<Word>(&values_[i])) {
      return std::string(spell(*word));
    }
    const std::string* text = std::get_if<std::string>(&values_[i]);
    return text == nullptr ? "" : *text;
  }
  [[nodiscard]] const double* number(std::size_t i) const {
    return i < values_.size() ? std::get_if<double>(&values_[i]) : nullptr;
  }

  /// A keyword with its number, or the next number of the positional form.
  bool item() {
    if (const double* value = number(next_)) {
      ++next_;
      positional(*value);
      return true;
    }
    const std::string word = spelling(next_);
    const bool isUnit =
        word == "IPM" || word == "MMPM" || word == "IPR" || word == "MMPR" || word == "MMPS";
    if (isUnit) {
      cycle_.feedUnit = *findWord(word);
      cycle_.feedHasUnit = true;
      ++next_;
      if (const double* feed = number(next_); feed != nullptr && !cycle_.feed) {
        cycle_.feed = *feed;
        ++next_;
      }
      return true;
    }
    if (word == "DEEP") {  // NX: DRILL,DEEP
      cycle_.kind = Cycle::Kind::peck;
    }
    if (word == "G98" || word == "G99") {
      retracts_ = 0;  // CAMWorks: the retract height follows the clearance, twice
    }
    if (word == "DEEP" || word == "MANUAL" || word == "AUTO" || word == "G98" || word == "G99") {
      ++next_;  // the height between holes, where no number tells it: the clearance
      return true;
    }
    const double* value = number(next_ + 1);
    if (word == "RTRCTO" && value == nullptr) {
      cycle_.returns = spelling(next_ + 1) == "AUTO";
      ++next_;
      return true;
    }
    if (value == nullptr) {
      return false;
    }
    keyed(word, *value);
    next_ += 2;
    if (const double* later = number(next_); word == "PECKING" && later != nullptr) {
      keyed("SUBPECK", *later);  // CAMWorks: PECKING, first, later ones
      ++next_;
    }
    return true;
  }

  void keyed(const std::string& word, double value) {
    if (word == "DEPTH" || word == "FEDTO") {
      cycle_.depth = value;
      hasDepth_ = true;
    } else if (word == "CLEAR" || word == "RAPTO") {
      cycle_.clearance = value;
      hasClearance_ = true;
    } else if (word == "RTRCTO" || word == "RETURN") {
      cycle_.retract = value;
      cycle_.returns = word == "RETURN" && value == 0.0;  // Creo: to its retract plane
    } else if (word == "DWELL") {
      cycle_.dwell = value;
      hasDwell_ = value != 0.0;
    } else if (word == "STEP" || word == "INCR" || word == "1STPECK" || word == "PECKING") {
      cycle_.step = value;
      cycle_.kind = cycle_.kind == Cycle::Kind::chip ? cycle_.kind : Cycle::Kind::peck;
    } else if (word == "SUBPECK") {
      cycle_.step = value > 0.0 ? std::min(cycle_.step, value) : cycle_.step;
    } else if (unknown_.empty()) {
      unknown_ = word;
    }
  }

  void positional(double value) {
    if (!hasDepth_) {
      cycle_.depth = value;
      hasDepth_ = true;
    } else if (!cycle_.feed) {
      cycle_.feed = value;
    } else if (!hasClearance_) {
      cycle_.clearance = value;
      hasClearance_ = true;
    } else if (retracts_ < mostRetracts) {
      cycle_.retract = value;
      ++retracts_;
    } else {
      unknown_ = "one number more than depth, feed and clearance";
    }
  }

  Result<Cycle> checked() {
    if (!unknown_.empty()) {
      return fail(diag::NgcCycle, "has `" + unknown_ + "`, which no canned cycle takes");
    }
    cycle_.retract = std::max(cycle_.clearance, cycle_.retract);
    cycle_.depth = std::abs(cycle_.depth);  // some systems write the way down, some its length
    if (!(cycle_.depth > 0.0) || !(cycle_.clearance > 0.0)) {
      return fail(diag::NgcCycle, fmt::format("has depth {} and clearance {}; a depth that is not "
                                              "0 and a clearance above 0 are needed",
                                              cycle_.depth, cycle_.clearance));
    }
    const bool pecks = cycle_.kind == Cycle::Kind::peck || cycle_.kind == Cycle::Kind::chip;
    if (pecks && !(cycle_.step > 0.0)) {
      return fail(diag::NgcCycle,
                  fmt::format("has a step of {}; STEP above 0 is needed", cycle_.step));
    }
    if (pecks && cycle_.depth / cycle_.step > mostPecks) {
      return fail(diag::NgcCycle, fmt::format("has {:.6g} pecks a hole; {:.6g} is the most",
                                              cycle_.depth / cycle_.step, mostPecks));
    }
    if (pecks ? hasDwell_ : cycle_.step != 0.0) {
      return fail(diag::NgcCycle, pecks
                                      ? std::string("has DWELL, which no cycle of pecks takes")
                                      : std::string("has a step, which only DEEP and BRKCHP take"));
    }
    if (hasDwell_ && cycle_.kind == Cycle::Kind::tap) {
      return fail(diag::NgcCycle, std::string("/TAP has DWELL, which no control waits for in it"));
    }
    if (hasDwell_ && !(cycle_.dwell >= 0.0)) {
      return fail(diag::NgcCycle, fmt::format("has a dwell of {} seconds", cycle_.dwell));
    }
    if (hasDwell_) {
      cycle_.kind = cycle_.kind == Cycle::Kind::bore ? Cycle::Kind::boreDwell : Cycle::Kind::dwell;
    }
    return cycle_;
  }

  const std::vector<cl::Value>& values_;
  std::size_t next_ = 1;
  Cycle cycle_;
  static constexpr int mostRetracts = 2;
  int retracts_ = mostRetracts;  ///< retract heights without a word that were read
  bool hasDepth_ = false;
  bool hasDwell_ = false;
  bool hasClearance_ = false;
  std::string unknown_;
};

}  // namespace

Result<Cycle> readCycle(const cl::Post& post) {
  return Reader(post).read();
}

Cycle cycleFrom(const Cycle& cycle, std::optional<double> height) {
  Cycle here = cycle;
  if (cycle.returns && height) {
    here.retract = std::max(cycle.clearance, *height);
  }
  return here;
}

namespace {
const Word* firstWord(const cl::Post& post) {
  return post.arguments.empty() ? nullptr : std::get_if<Word>(&post.arguments[0]);
}
bool ends(const cl::Post& post) {
  const Word* first = firstWord(post);
  const bool clears =  // SolidWorks CAM, before a cycle
      post.arguments.size() == 1 && std::get_if<std::string>(&post.arguments[0]) != nullptr &&
      std::get<std::string>(post.arguments[0]) == "CLEAR";
  return clears || (first != nullptr && (*first == Word::OFF || *first == Word::NOMORE));
}
}  // namespace

std::optional<Failure> objectionToDrilling(const cl::Post& post) {
  if (ends(post)) {
    return std::nullopt;
  }
  return fail(diag::NgcCycle,
              std::string("drills, which this output has no moves for: its holes would be lost"));
}

Result<Cycles::Change> Cycles::read(const cl::Post& post) {
  const Word* first = firstWord(post);
  if (ends(post)) {
    paused_ = first != nullptr && *first == Word::NOMORE ? std::optional(on_) : std::nullopt;
    on_ = false;
    return Change::ended;
  }
  const std::optional<bool> paused = std::exchange(paused_, std::nullopt);
  if (first != nullptr && *first == Word::ON) {
    if (paused && !*paused) {
      return Change::none;  // AVOID of a pattern that is not drilled
    }
    on_ = true;
    return last_ ? Change::resumed : Change::none;  // CAMWorks: the head of a cycle that follows
  }
  const auto* text =
      post.arguments.empty() ? nullptr : std::get_if<std::string>(&post.arguments[0]);
  if (text != nullptr && *text == "INIT") {
    return Change::none;  // Fusion's head of a cycle that follows
  }
  Result<Cycle> cycle = readCycle(post);
  if (!cycle) {
    return cycle.takeFailure();
  }
  last_ = *cycle;
  on_ = true;
  return Change::begun;
}

std::optional<Failure> Cycles::objection() {
  if (!on_ || last_) {
    return std::nullopt;
  }
  on_ = false;
  return fail(diag::NgcCycle, std::string("/ON has no cycle before it nor behind it"));
}

std::optional<cl::Post> feedOf(const Cycle& cycle) {
  if (!cycle.feed) {
    return std::nullopt;
  }
  cl::Post feed{Word::FEDRAT, "", {*cycle.feed}};
  if (cycle.feedHasUnit) {
    feed.arguments.emplace_back(cycle.feedUnit);
  }
  return feed;
}

}  // namespace arelem::hole
