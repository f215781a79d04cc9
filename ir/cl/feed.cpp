#include "ir/cl/feed.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "ir/cl/post_word.h"
#include "ir/words/units.h"

namespace arelem::cl {

namespace {
constexpr double secondsOfAMinute = 60.0;
constexpr double partUnit = 0.0;  // in the table below: the number counts lengths of the part

/// Some are no words of the vocabulary, but of files of CAM systems.
struct UnitRow {
  std::string_view name;
  Feed::Per per;
  double factor;
};
constexpr std::array units = {
    UnitRow{"IPM", Feed::Per::minute, millimetersOfAnInch},
    UnitRow{"IPR", Feed::Per::turn, millimetersOfAnInch},
    UnitRow{"MMPM", Feed::Per::minute, 1.0},
    UnitRow{"MMPR", Feed::Per::turn, 1.0},
    UnitRow{"MMPS", Feed::Per::minute, secondsOfAMinute},
    UnitRow{"PERMIN", Feed::Per::minute, partUnit},
    UnitRow{"PERREV", Feed::Per::turn, partUnit},
    UnitRow{"INVERS", Feed::Per::move, 1.0},
};

std::string_view spelling(const Value& value) {
  const Word* word = std::get_if<Word>(&value);
  const std::string* text = std::get_if<std::string>(&value);
  return word != nullptr ? spell(*word) : text != nullptr ? std::string_view(*text) : "a surface";
}

FeedReading none(std::string_view what) {
  return {std::nullopt, fmt::format("{}: it takes one number, and IPM, IPR, MMPM, MMPR, MMPS, "
                                    "PERMIN, PERREV or INVERS for its unit",
                                    what)};
}
}  // namespace

FeedReading readFeed(const Post& feedRate, double millimeters) {
  const double* number = nullptr;
  const UnitRow* unit = nullptr;
  for (const Value& value : feedRate.arguments) {
    if (const double* found = std::get_if<double>(&value)) {
      if (number != nullptr) {
        return none("several numbers");
      }
      number = found;
      continue;
    }
    const auto* row = std::find_if(units.begin(), units.end(),
                                   [&](const UnitRow& one) { return one.name == spelling(value); });
    if (row == units.end() || unit != nullptr) {
      return none(row == units.end() ? fmt::format("`{}`", spelling(value)) : "several units");
    }
    unit = row;
  }
  if (number == nullptr) {
    return none("no number");
  }
  const double factor = unit != nullptr ? unit->factor : partUnit;
  return {Feed{*number * (factor == partUnit ? millimeters : factor),
               unit != nullptr ? unit->per : Feed::Per::minute},
          ""};
}

double turnsBehind(const Post& spindle, double before) {
  constexpr std::array others = {"OFF", "SFM", "SMM", "ORIENT", "LOCK", "MAXRPM"};
  for (const Value& value : spindle.arguments) {
    if (!std::holds_alternative<double>(value) &&
        std::find(others.begin(), others.end(), spelling(value)) != others.end()) {
      return 0.0;
    }
  }
  const double* number = firstNumber(spindle);
  return std::abs(number != nullptr ? *number : before);  // below 0: counterclockwise
}

}  // namespace arelem::cl
