#include "runtime/interpret/post_arguments.h"

#include <algorithm>
#include <array>
#include <span>

#include "ir/diag/curves.h"

namespace arelem::runtime::interpret {

namespace {
// What each word takes: the processor's manuals, ISO 4343 and the files of CAM systems together,
// since a word that any of them writes is no fault.
constexpr std::array feed = {Word::IPM,    Word::IPR,  Word::MMPM, Word::MMPR, Word::INVERS,
                             Word::MAXIPM, Word::AUTO, Word::STEP, Word::ON,   Word::OFF,
                             Word::LENGTH, Word::LOCK, Word::LOW,  Word::HIGH, Word::RAPID,
                             Word::MULTRD, Word::SCALE};
constexpr std::array spindle = {Word::ON,   Word::OFF,   Word::RPM,    Word::SFM,    Word::CLW,
                                Word::CCLW, Word::CW,    Word::CCW,    Word::RANGE,  Word::MAXRPM,
                                Word::LOW,  Word::HIGH,  Word::MEDIUM, Word::RADIUS, Word::LOCK,
                                Word::AUTO, Word::FRONT, Word::REAR,   Word::MAIN,   Word::SIDE,
                                Word::BOTH, Word::REV};
constexpr std::array coolant = {Word::ON,   Word::OFF,    Word::FLOOD, Word::MIST, Word::TAPKUL,
                                Word::THRU, Word::AIR,    Word::LOW,   Word::HIGH, Word::MEDIUM,
                                Word::AUTO, Word::FRONT,  Word::REAR,  Word::LEFT, Word::RIGHT,
                                Word::BOTH, Word::SPINDL, Word::TOOL,  Word::ALL};
constexpr std::array compensation = {
    Word::LEFT,   Word::RIGHT,  Word::ON,     Word::OFF,    Word::XYPLAN, Word::YZPLAN,
    Word::ZXPLAN, Word::LENGTH, Word::RADIUS, Word::ADJUST, Word::XAXIS,  Word::YAXIS,
    Word::ZAXIS,  Word::PLUS,   Word::MINUS,  Word::NORMAL, Word::PERPTO, Word::CIRCLE,
    Word::NOW,    Word::NEXT,   Word::TOOL,   Word::CUTTER, Word::AUTO,   Word::ALL};
constexpr std::array toolChange = {
    Word::LENGTH, Word::ADJUST, Word::SETOOL, Word::ATANGL, Word::AUTO,  Word::CLW,  Word::CCLW,
    Word::LOW,    Word::MEDIUM, Word::HIGH,   Word::IN,     Word::OUT,   Word::NOW,  Word::NEXT,
    Word::ON,     Word::OFF,    Word::TURRET, Word::HOLDER, Word::FRONT, Word::REAR, Word::LEFT,
    Word::RIGHT,  Word::XAXIS,  Word::YAXIS,  Word::ZAXIS,  Word::TOOL,  Word::ALL,  Word::MODIFY,
    Word::RADIUS, Word::CUTTER, Word::MAIN,   Word::SIDE,   Word::STEP};
constexpr std::array pause = {Word::REV, Word::RPM, Word::ON, Word::OFF, Word::AUTO};

/// None where the word is not looked at.
std::span<const Word> taken(Word word) {
  switch (word) {
    case Word::FEDRAT:
      return feed;
    case Word::SPINDL:
      return spindle;
    case Word::COOLNT:
      return coolant;
    case Word::CUTCOM:
      return compensation;
    case Word::LOADTL:
    case Word::SELCTL:
    case Word::TURRET:
      return toolChange;
    case Word::DELAY:
      return pause;
    default:
      return {};
  }
}
}  // namespace

void checkPostArguments(State& state, Word word, const Items& items) {
  const std::span<const Word> known = taken(word);
  for (const Item& item : items) {
    const Word* argument = std::get_if<Word>(&item.value);
    if (!known.empty() && argument != nullptr &&
        std::find(known.begin(), known.end(), *argument) == known.end()) {
      state.report(diagnose(item.span, diag::PostArgument, spell(word), spell(*argument)));
    }
  }
}

}  // namespace arelem::runtime::interpret
