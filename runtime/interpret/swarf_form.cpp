#include "runtime/interpret/swarf_form.h"

#include <cmath>
#include <string_view>

#include "ir/diag/interpret.h"
#include "runtime/path/swarf_pose.h"

namespace arelem::runtime::interpret {

namespace {
constexpr std::string_view vtlaxsForms =
    "its forms are VTLAXS/ON,side,degrees,d,r,side[,ZSMALL] and VTLAXS/OFF,side,degrees, where a "
    "side is LEFT or RIGHT";
constexpr std::string_view wcornForm = "its form is WCORN/side,degrees,side,degrees,h[,n]";

/// Reads a pattern of the parameters: s side, n number, from `at` on.
bool reads(const Items& items, std::size_t at, std::string_view pattern) {
  if (items.size() != at + pattern.size()) {
    return false;
  }
  for (const char kind : pattern) {
    const Item& item = items[at++];
    const bool fits =
        kind == 'n' ? item.number() != nullptr : item.is(Word::LEFT) || item.is(Word::RIGHT);
    if (!fits) {
      return false;
    }
  }
  return true;
}

/// What is wrong with the numbers, or "".
std::string wrongTilt(double degrees) {
  return degrees >= 0.0 && degrees < path::steepestSwarf
             ? ""
             : fmt::format("a tilt of {:.6g} degrees", degrees);
}

std::string wrongTool(const Items& items) {
  const double diameter = *items[3].number();
  const double corner = *items[4].number();
  if (!(diameter > 0.0) || corner < 0.0 || corner > diameter / 2.0) {
    return fmt::format("a cutter of diameter {:.6g} with a corner radius of {:.6g}", diameter,
                       corner);
  }
  return items.size() > 6 && corner > 0.0
             ? fmt::format("ZSMALL and a corner radius of {:.6g}", corner)
             : "";
}
}  // namespace

bool checkSwarf(State& state, Word word, const Items& items) {
  constexpr std::string_view rule =
      "tilts go from 0 to less than 80 degrees, r from 0 to half of d, ZSMALL needs r 0";
  const auto refuse = [&](std::string what, std::string_view why) {
    state.report(
        diagnose(state.statement->span, diag::SwarfForm, spell(word), std::move(what), why));
    return false;
  };
  std::string wrong;
  if (word == Word::WCORN) {
    if (!reads(items, 0, "snsnn") && !reads(items, 0, "snsnnn")) {
      return refuse(describe(items), wcornForm);
    }
    constexpr double mostSteps = 1000.0;
    const double steps = items.size() > 5 ? *items[5].number() : 1.0;
    if (!(*items[4].number() > 0.0) || steps < 1.0 || steps > mostSteps ||
        steps != std::floor(steps)) {
      return refuse(fmt::format("a height of {:.6g} and {:.6g} steps", *items[4].number(), steps),
                    "the height is positive, the steps a whole number from 1 to 1000");
    }
    wrong = wrongTilt(*items[1].number()) + wrongTilt(*items[3].number());
  } else if (!items.empty() && items[0].is(Word::ON)) {
    const bool deep = items.size() == 7 && items[6].is(Word::ZSMALL);
    const Items plain(items.begin(), items.end() - (deep ? 1 : 0));
    if (!reads(plain, 1, "snnns")) {
      return refuse(describe(items), vtlaxsForms);
    }
    wrong = wrongTilt(*items[2].number());
    wrong = wrong.empty() ? wrongTool(items) : wrong;
  } else if (items.empty() || !items[0].is(Word::OFF) || !reads(items, 1, "sn")) {
    return refuse(describe(items), vtlaxsForms);
  } else {
    wrong = wrongTilt(*items[2].number());
  }
  return wrong.empty() || refuse(std::move(wrong), rule);
}

}  // namespace arelem::runtime::interpret
