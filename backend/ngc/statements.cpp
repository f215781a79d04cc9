#include "backend/ngc/statements.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/ngc.h"

namespace arelem::backend::ngc {

namespace {
constexpr int secondsDecimals = 3;
constexpr int speedDecimals = 1;
constexpr double secondsOfAMinute = 60.0;
constexpr double highestCode = 999.0;

bool isWhole(double number) {
  return number == std::floor(number);
}
}  // namespace

void Statements::accept(const cl::Post& post, const Span& origin) {
  origin_ = origin;
  switch (post.word) {
    case Word::SPINDL:
      return spindle(post);
    case Word::COOLNT:
      return coolant(post);
    case Word::CUTCOM:
      return compensation(post);
    case Word::LOADTL:
    case Word::TURRET:
      return tool(post);
    case Word::SELCTL:
    case Word::TOOLNO:
      return nextTool(post);
    case Word::DELAY:
      return delay(post);
    case Word::AUXFUN:
    case Word::PREFUN:
      return function(post);
    case Word::STOP:
      return line("M0");
    case Word::OPSTOP:
      return line("M1");
    default:
      break;
  }
  if (spell(post.word) == "SPRAY") {
    return spray(post);
  }
  ignored(spell(post.word), written(post), origin);
}

void Statements::line(std::string_view code) {
  block_.code(code);
  block_.end();
}

void Statements::ignored(std::string_view word, std::string_view statement, const Span& origin) {
  if (warned_.insert(std::string(word)).second) {
    sink_.accept(diagnose(origin, diag::NgcWordIgnored, statement));
  }
  block_.comment(statement);
}

void Statements::refuse(const cl::Post& post, std::string why) {
  sink_.accept(at(origin_, fail(diag::NgcStatement, written(post), std::move(why))));
}

/// What a statement says beyond its codes.
void Statements::passed(std::string text) {
  if (!text.empty() && text.back() != '/') {
    ignored(text, text, origin_);
  }
}

void Statements::spindle(const cl::Post& post) {
  Parameters given(post);
  const std::string range = given.takePair("RANGE");
  const bool stops = !given.take({"OFF"}).empty();
  given.take({"RPM"});
  const std::string_view way = given.take({"CLW", "CW", "CCLW", "CCW"});
  const bool starts = !given.take({"ON"}).empty() || !way.empty();
  const std::optional<double> turns = stops ? std::nullopt : given.takeNumber();
  if (const std::string rest = given.rest(); !rest.empty()) {
    return refuse(post, fmt::format("`{}` has no code; it takes turns a minute, RPM, CLW, CCLW, ON "
                                    "and OFF",
                                    rest));
  }
  if (stops) {
    moves_.setSpindle(Moves::Spindle::off);
    line("M5");
    return passed("SPINDL/" + range);
  }
  if (!turns && (!starts || !(moves_.spindle() > 0.0))) {
    return refuse(post, starts ? "no speed came before it" : "it has no speed");
  }
  if (turns && *turns == 0.0) {
    return refuse(post, "0 turns are no speed; SPINDL/OFF stops the spindle");
  }
  if (turns && *turns < 0.0 && (way == "CLW" || way == "CW")) {
    return refuse(post,
                  fmt::format("a speed below 0 turns counterclockwise, and {} the other way", way));
  }
  if (turns) {
    moves_.setSpindle(std::abs(*turns));
    block_.number('S', std::abs(*turns), speedDecimals);
    counter_ = counter_ || *turns < 0.0;
  }
  counter_ = way.empty() ? counter_ : way == "CCLW" || way == "CCW";
  moves_.setSpindle(counter_ ? Moves::Spindle::counterclockwise : Moves::Spindle::clockwise);
  line(counter_ ? "M4" : "M3");
  passed("SPINDL/" + range);
}

void Statements::coolant(const cl::Post& post) {
  Parameters given(post);
  const bool off = !given.take({"OFF"}).empty();
  const bool mist = !given.take({"MIST"}).empty();
  const bool flood = !given.take({"FLOOD"}).empty();
  const bool on = !given.take({"ON"}).empty();
  const std::string rest = given.rest();
  if (off) {
    line("M9");
  } else if (mist || flood || (on && rest.empty())) {
    if (mist) {
      line("M7");
    }
    if (flood || !mist) {
      line("M8");
    }
  } else {
    return ignored(written(post), written(post), origin_);
  }
  passed("COOLNT/" + rest);
}

/// The path is what the CL says: that of the tool end, offset by CUTTER already, or the contour.
void Statements::compensation(const cl::Post& post) {
  Compensation& control = moves_.compensation();
  const bool wasOn = control.isOn();
  if (auto failure = control.accept(post)) {
    sink_.accept(at(origin_, *std::move(failure)));
  } else if (!wasOn && control.isOn() && moves_.cutter() > 0.0) {
    sink_.accept(diagnose(origin_, diag::NgcOffsetTwice, moves_.cutter(), control.reg()));
    block_.comment(fmt::format("D{}: WEAR ONLY, THE PATH IS OF CUTTER {:.6g}", control.reg(),
                               moves_.cutter()));
  }
}

/// AUXFUN/n and PREFUN/n: the codes Mn and Gn of the control, as the program says.
void Statements::function(const cl::Post& post) {
  Parameters given(post);
  const auto number = given.takeNumber();
  if (!number || *number < 0.0 || *number > highestCode || !given.rest().empty()) {
    return refuse(post, "it takes one code from 0 to 999");
  }
  line(fmt::format("{}{:g}", post.word == Word::AUXFUN ? 'M' : 'G', *number));
  block_.forgetAll();
}

void Statements::tool(const cl::Post& post) {
  Parameters given(post);
  const std::optional<double> adjusted = given.takeNumberAfter("ADJUST");
  const auto number = given.takeNumber();
  if (!number || *number < 1.0 || !isWhole(*number)) {
    return refuse(post, "it takes the whole number of a tool first");
  }
  if (moves_.compensation().isOn()) {
    return refuse(post, "CUTCOM is on; a control changes tools without it");
  }
  moves_.compensation().finish();
  moves_.compensation().setTool(static_cast<long long>(*number));
  const double height = adjusted.value_or(*number);
  if (height < 0.0 || !isWhole(height)) {
    return refuse(post, "ADJUST takes the whole number of a length offset");
  }
  line(fmt::format("T{} M6", static_cast<long long>(*number)));
  if (control_.toolLength) {
    line(fmt::format("G43 H{}", static_cast<long long>(height)));
  }
  // Where the changer leaves the axes is not known.
  block_.forgetAxes();
  passed(std::string(spell(post.word)) + "/" + given.rest());
}

/// The tool of the next change; LOADTL or TURRET changes it. What follows the number describes it.
void Statements::nextTool(const cl::Post& post) {
  Parameters given(post);
  const auto number = given.takeNumber();
  if (!number || *number < 1.0 || !isWhole(*number)) {
    return refuse(post, "it takes the whole number of a tool first");
  }
  line(fmt::format("T{}", static_cast<long long>(*number)));
}

void Statements::delay(const cl::Post& post) {
  Parameters given(post);
  const bool turns = !given.take({"REV"}).empty();
  const std::optional<double> value = given.takeNumber();
  if (!value || *value < 0.0 || !given.rest().empty()) {
    return refuse(post, "it takes the seconds to wait, 0 or more, or turns with REV");
  }
  const double speed = moves_.spindle();
  if (turns && !(speed > 0.0)) {
    return refuse(post, "the spindle has no speed");
  }
  block_.code("G4");
  block_.number('P', turns ? *value * secondsOfAMinute / speed : *value, secondsDecimals);
  block_.end();
}

/// SPRAY/ON,n and SPRAY/OFF,n: outputs that switch with the next move.
void Statements::spray(const cl::Post& post) {
  Parameters given(post);
  const std::string_view way = given.take({"ON", "OFF"});
  const double number = given.takeNumber().value_or(1.0);
  if (way.empty() || !isWhole(number) || number < 1.0 || !given.rest().empty()) {
    return refuse(post, "it takes ON or OFF and the number of an output");
  }
  line(fmt::format("{} P{}", way == "OFF" ? "M63" : "M62", static_cast<long long>(number) - 1));
}

}  // namespace arelem::backend::ngc
