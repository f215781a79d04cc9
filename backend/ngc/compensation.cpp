#include "backend/ngc/compensation.h"

#include <cmath>

#include "backend/ngc/parameters.h"
#include "ir/diag/ngc.h"

namespace arelem::backend::ngc {

namespace {
constexpr double highestRegister = 9999.0;
}

std::optional<Failure> Compensation::accept(const cl::Post& post) {
  const auto refused = [&](std::string why) -> std::optional<Failure> {
    return fail(diag::NgcStatement, written(post), std::move(why));
  };
  Parameters given(post);
  const bool off = !given.take({"OFF"}).empty();
  const bool on = !given.take({"ON"}).empty();
  const std::string_view side = given.take({"LEFT", "RIGHT"});
  given.take({"XYPLAN"});
  const std::optional<double> number = given.takeNumber();
  if (const std::string rest = given.rest(); !rest.empty()) {
    return refused(
        fmt::format("`{}` has no code; it takes LEFT, RIGHT, ON or OFF, XYPLAN, and the "
                    "number of a register",
                    rest));
  }
  if (off) {
    wanted_.reset();
    return std::nullopt;
  }
  if (side.empty() && !(on && last_)) {
    return refused(on ? "no LEFT or RIGHT came before it" : "it has no side: LEFT or RIGHT");
  }
  State state = side.empty() ? *last_ : State{side == "LEFT", tool_};
  if (number) {
    if (!(*number >= 1.0 && *number <= highestRegister) || *number != std::floor(*number)) {
      return refused(fmt::format("a register is a whole number from 1 to {:g}", highestRegister));
    }
    state.reg = static_cast<long long>(*number);
  }
  if (state.reg == 0) {
    return refused("no register, and no LOADTL whose number it could be");
  }
  if (wanted_ && *wanted_ != state) {
    return refused("the path is offset to another side or by another register: CUTCOM/OFF first");
  }
  wanted_ = last_ = state;
  return std::nullopt;
}

void Compensation::put() {
  if (!isPending()) {
    return;
  }
  written_ = wanted_;
  block_.code(!wanted_ ? "G40" : fmt::format("{} D{}", wanted_->left ? "G41" : "G42", reg()));
}

void Compensation::finish() {
  wanted_.reset();
  if (written_) {
    put();
    block_.end();
  }
}

}  // namespace arelem::backend::ngc
