#include "runtime/interpret/cl_statement.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/curves.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/motion.h"
#include "runtime/path/frame.h"

namespace arelem::runtime::interpret {

namespace {
constexpr std::string_view arcForms =
    "CIRCLE/x,y,z,i,j,k[,r[,...]][,TIMES,n][,CLOCKWISE], CIRCLE/x,y,z,r behind INDIRV and "
    "MOVARC/x,y,z,i,j,k,r[,ANGLE,degrees]";

bool isText(const Item& item, std::string_view text) {
  const auto* found = std::get_if<std::string>(&item.value);
  return found != nullptr && *found == text;
}

/// The numbers at the head, and what the words behind them say.
class ArcReader {
 public:
  ArcReader(State& state, const Items& items) : state_(state), items_(items) {}

  std::optional<Arc> read() {
    while (next_ < items_.size() && items_[next_].number() != nullptr) {
      numbers_.push_back(*items_[next_++].number());
    }
    Arc arc;
    const bool inPlane = numbers_.size() == 4;
    if (!inPlane && numbers_.size() < 6) {
      return std::nullopt;
    }
    arc.center = state_.systems.pointToBase({numbers_[0], numbers_[1], numbers_[2]});
    if (inPlane) {
      arc.radius = numbers_[3];
    } else {
      arc.axis = state_.systems.vectorToBase({numbers_[3], numbers_[4], numbers_[5]});
      arc.radius = numbers_.size() > 6 ? std::optional(numbers_[6]) : std::nullopt;
    }
    return words(arc) ? std::optional(arc) : std::nullopt;
  }
  [[nodiscard]] bool describesTool() const { return numbers_.size() > 7; }

 private:
  bool words(Arc& arc) {
    for (; next_ < items_.size(); ++next_) {
      const Item& item = items_[next_];
      if (item.is(Word::TIMES) || item.is(Word::ANGLE)) {
        const double* number = next_ + 1 < items_.size() ? items_[next_ + 1].number() : nullptr;
        if (number == nullptr) {
          return false;
        }
        if (item.is(Word::ANGLE)) {
          arc.sweepDegrees = *number;
        } else if (*number != std::floor(*number)) {
          return false;
        } else {
          constexpr double most = 1e6;  // far beyond what is taken
          arc.turns = static_cast<int>(std::clamp(*number, -1.0, most));
        }
        ++next_;
      } else if (item.is(Word::CLW) || item.is(Word::CW) || isText(item, "CLOCKWISE")) {
        arc.axis = -arc.axis.value_or(Vec3::Zero());
      } else if (!(item.is(Word::CCLW) || item.is(Word::CCW) || isText(item, "COUNTERCLOCKWISE"))) {
        return false;
      }
    }
    return true;
  }

  State& state_;
  const Items& items_;
  std::size_t next_ = 0;
  std::vector<double> numbers_;
};
}  // namespace

bool arcStatement(State& state, std::string_view word, const Items& items) {
  if (word != "CIRCLE" && word != "MOVARC") {
    return false;
  }
  ArcReader reader(state, items);
  if (const std::optional<Arc> arc = reader.read()) {
    if (reader.describesTool()) {
      state.ignore("what follows the radius of CIRCLE",
                   "it describes the tool that follows the arc");
    }
    state.emit(*arc);
  } else {
    state.report(diagnose(state.statement->span, diag::ArcForm, word, describe(items), arcForms));
  }
  return true;
}

void frameStatement(State& state, std::string_view word, const Items& items) {
  if (word == "OPFEATEND") {  // the tables of CAMWorks stand as before the operation
    state.carried.turned.setIdentity();
    state.carried.partAxis.reset();
  } else if (word == "TRNTYP") {
    state.carried.worldPlaces = !items.empty() && isText(items[0], "WORLD");
  }
  constexpr std::size_t numbers = 12;
  if (word != "CSYS" || !state.carried.worldPlaces || items.size() != numbers) {
    return;
  }
  Vec3 axis;
  for (int row = 0; row < 3; ++row) {
    const double* number = items[static_cast<std::size_t>(4 * row + 2)].number();
    if (number == nullptr) {
      return;
    }
    axis[row] = *number;
  }
  if (!isNull(axis)) {
    ToolAxis fixed;
    fixed.vector = axis;
    state.emit(fixed);
  }
}

bool checkFeed(State& state, std::string_view word, const Items& items) {
  if (word != "FEDRAT") {
    return true;
  }
  for (const Item& item : items) {
    if (const double* feed = item.number()) {
      if (!(*feed > 0.0)) {
        state.report(diagnose(item.span, diag::FeedNotPositive, *feed));
      }
      return *feed > 0.0;
    }
  }
  return true;
}

void turnTable(State& state, const cl::Post& post) {
  if (state.program.dialect != "cl" || post.word != Word::ROTABL) {
    return;
  }
  const std::optional<path::Affine> turn = path::turnOf(post);
  if (!turn) {
    return;
  }
  state.carried.turned = state.carried.turned * turn->linear;
  if (state.carried.partAxis) {
    ToolAxis fixed;
    fixed.vector = state.carried.turned.transpose() * *state.carried.partAxis;
    state.emit(fixed);
  }
}

Vec3 axisInFrame(State& state, const Vec3& axis) {
  if (state.program.dialect != "cl") {
    return axis;
  }
  state.carried.partAxis = axis;
  return state.carried.turned.transpose() * axis;
}

void checkFeedUnits(State& state, std::string_view word, const Items& items) {
  if ((word != "FEDRAT" && word != "CYCLE") || !state.carried.unit) {
    return;
  }
  const bool inches = *state.carried.unit == Word::INCHES || *state.carried.unit == Word::FEET;
  for (const Item& item : items) {
    const Word* unit = std::get_if<Word>(&item.value);
    if (unit == nullptr) {
      continue;
    }
    const bool metric = *unit == Word::MMPM || *unit == Word::MMPR;
    const bool imperial = *unit == Word::IPM || *unit == Word::IPR;
    if ((inches && imperial) || (!inches && metric)) {
      state.carried.toldOfUnits = false;  // the next one that does not fit is a change again
    } else if (metric || imperial) {
      if (!state.carried.toldOfUnits) {
        state.report(diagnose(state.statement->span, diag::MixedUnits, spell(*unit),
                              spell(*state.carried.unit)));
      }
      state.carried.toldOfUnits = true;
    }
  }
}

}  // namespace arelem::runtime::interpret
