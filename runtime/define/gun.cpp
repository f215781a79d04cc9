// GUN definitions. Lengths are given in the unit of the part program and kept in mm.
#include "runtime/spray/gun.h"

#include <charconv>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "ir/diag/spray.h"
#include "runtime/define/resolve.h"
#include "runtime/spray/calibration.h"

namespace arelem::define {

using spray::Gun;

namespace {
constexpr double degree = std::numbers::pi / 180.0;
constexpr double mostLead = 10.0;  // s; guns take some hundredths of one

std::optional<Failure> require(std::string_view what,
                               double value,
                               bool good,
                               std::string_view rule) {
  if (good && std::isfinite(value)) {
    return std::nullopt;
  }
  return fail(diag::GunOption, what, value, rule);
}

/// Sets one option from its values; the pattern has made sure that they are there.
std::optional<Failure> setOption(Gun& gun, const Arguments& given, std::size_t at) {
  const double value = given.scalar(at + 1);
  switch (given.word(at)) {
    case Word::STNDOF:
      gun.standOff = value * given.millimeters();
      return require("the stand-off", value, value > 0.0, "above 0");
    case Word::FLOW:
      gun.flow = value * spray::literPerMinute;
      return require("the flow", value, value > 0.0, "above 0 l/min");
    case Word::EFFIC:
      gun.efficiency = value;
      return require("the transfer efficiency", value, value > 0.0 && value <= 1.0,
                     "above 0 and at most 1");
    case Word::SPEED:
      gun.speed = value;
      return require("the speed", value, value > 0.0, "above 0 mm/s");
    case Word::OUTPUT:
      gun.output = static_cast<int>(value);
      return require("the output", value, value >= 1.0 && value <= 9999.0 && value == gun.output,
                     "a whole number from 1 to 9999");
    default: {  // LEAD
      gun.leadOn = value;
      gun.leadOff = given.scalar(at + 2);
      const auto [least, most] = std::minmax(gun.leadOn, gun.leadOff);
      return require("a lead time", least < 0.0 ? least : most, least >= 0.0 && most <= mostLead,
                     "from 0 to 10 s");
    }
  }
}

/// The options from parameter `at` on.
std::optional<Failure> setOptions(Gun& gun,
                                  const Arguments& given,
                                  std::size_t at,
                                  std::string_view noun) {
  std::set<Word> seen;
  while (at < given.count()) {
    const Word word = given.word(at);
    if (!seen.insert(word).second) {
      return fail(diag::GunOptionExtra, noun, fmt::format("{} twice", spell(word)),
                  "each option stands once");
    }
    if (word == Word::FLOW && gun.kind == Gun::Kind::calibrated) {
      return fail(diag::GunOptionExtra, noun, std::string("FLOW"),
                  "the flow is that of the pressure and the valve");
    }
    if (auto failure = setOption(gun, given, at)) {
      return failure;
    }
    at += given.is(at, Word::LEAD) ? 3 : 2;
  }
  return std::nullopt;
}

/// Finishes a gun: its options, then its footprint from them.
Result<Resolved> finished(Gun gun,
                          const Arguments& given,
                          std::size_t options,
                          std::string_view noun,
                          const std::function<void(Gun&)>& footprint) {
  if (auto failure = setOptions(gun, given, options, noun)) {
    return *std::move(failure);
  }
  if (gun.spreads() && gun.standOff == 0.0) {
    return fail(diag::GunOptionMissing, noun, "STNDOF, its distance from the work");
  }
  footprint(gun);
  if (auto failure = require("half the width of the footprint", gun.footprint.across,
                             gun.footprint.across > 0.0, "above 0 mm")) {
    return *std::move(failure);
  }
  return Resolved(gun.canon());
}

void nothingMore(Gun& /*gun*/) {}

/// Whether a line begins, behind blanks and quotation marks, like a number.
bool beginsAsNumber(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\"'");
  return first != std::string_view::npos &&
         std::string_view("+-.0123456789").find(line[first]) != std::string_view::npos;
}

/// Two columns of numbers, separated by commas, semicolons or blanks; a first line that begins
/// with a word is a heading, lines that begin with # are comments.
Result<std::vector<std::pair<double, double>>> columnsOf(std::string_view text) {
  std::vector<std::pair<double, double>> rows;
  std::size_t number = 0;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    const bool comment =
        line.find_first_not_of(" \t") == line.find('#') || (rows.empty() && !beginsAsNumber(line));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    ++number;
    std::array<double, 3> values{};
    std::size_t count = 0;
    bool good = true;
    while (good && count < values.size()) {
      const std::size_t begin = line.find_first_not_of(" \t\r,;");
      if (begin == std::string_view::npos) {
        break;
      }
      line.remove_prefix(begin);
      const auto [next, error] =
          std::from_chars(line.data(), line.data() + line.size(), values[count]);
      good = error == std::errc() && std::isfinite(values[count]);
      line.remove_prefix(static_cast<std::size_t>(next - line.data()));
      ++count;
    }
    if (count == 0 || (comment && !good)) {
      continue;
    }
    if (!good || count != 2) {
      return fail(diag::ProfileTable, fmt::format("no two numbers in line {}", number),
                  "a place and a film in each line");
    }
    rows.emplace_back(values[0], values[1]);
  }
  return rows;
}

Result<Resolved> gunOfRows(std::vector<std::pair<double, double>> rows,
                           const Arguments& given,
                           std::size_t options) {
  for (auto& [place, film] : rows) {
    place *= given.millimeters();
  }
  Result<spray::Profile::Measured> measured = spray::Profile::table(rows);
  if (!measured) {
    return measured.takeFailure();
  }
  Gun gun;
  gun.kind = Gun::Kind::table;
  gun.footprint = {measured->halfWidth, measured->halfWidth};
  gun.table = measured->profile.points();
  return finished(std::move(gun), given, options, "TABLE", nothingMore);
}
}  // namespace

Result<Resolved> gunOfEllipse(const Arguments& given) {
  Gun gun;
  gun.footprint = {given.scalar(1) * given.millimeters(), given.scalar(2) * given.millimeters()};
  if (auto failure = require("the half axis along the passes", gun.footprint.along,
                             gun.footprint.along > 0.0, "above 0")) {
    return *std::move(failure);
  }
  return finished(std::move(gun), given, 3, "ELLIPS", nothingMore);
}

Result<Resolved> gunOfCone(const Arguments& given) {
  Gun gun;
  gun.kind = Gun::Kind::cone;
  gun.angle = given.scalar(1) * degree;
  if (auto failure = require("the half angle", given.scalar(1),
                             given.scalar(1) > 0.0 && given.scalar(1) < 80.0,
                             "above 0 and below 80 degrees")) {
    return *std::move(failure);
  }
  return finished(std::move(gun), given, 2, "CONE", [](Gun& g) {
    const double radius = spray::coneRadius(g.standOff, g.angle);
    g.footprint = {radius, radius};
  });
}

Result<Resolved> gunOfFan(const Arguments& given) {
  Gun gun;
  gun.kind = Gun::Kind::fan;
  gun.angle = given.scalar(1) * degree / 2.0;
  if (auto failure = require("the angle of the fan", given.scalar(1),
                             given.scalar(1) > 0.0 && given.scalar(1) < 160.0,
                             "above 0 and below 160 degrees")) {
    return *std::move(failure);
  }
  const bool measured = given.is(2, Word::HEIGHT);
  if (measured) {
    gun.heightAtZero = given.scalar(3) * given.millimeters();
    gun.heightSlope = given.scalar(4);
    if (auto failure =
            require("the slope of the height", gun.heightSlope, gun.heightSlope > 0.0, "above 0")) {
      return *std::move(failure);
    }
  }
  return finished(std::move(gun), given, measured ? 5 : 2, "FAN", [](Gun& g) {
    const double half = g.heightSlope > 0.0 ? (g.standOff - g.heightAtZero) / g.heightSlope / 2.0
                                            : spray::coneRadius(g.standOff, g.angle);
    g.footprint = {0.0, half};
  });
}

Result<Resolved> gunOfCalibration(const Arguments& given) {
  const std::string& name = given.text(1);
  const bool isFile = name.ends_with(".toml");
  Result<std::string> text = given.fileText(isFile ? name : "guns/" + name + ".toml");
  if (!text) {
    return isFile ? text.takeFailure()
                  : text.takeFailure().withHelp(
                        "'" + name +
                        "' is looked up among the guns of the library, stdlib/guns: 'binks' is "
                        "one; the name of a file of your own ends in .toml");
  }
  Result<spray::Calibration> calibration = spray::readCalibration(*text, name);
  if (!calibration) {
    return calibration.takeFailure();
  }
  Result<spray::Setting> setting = spray::settingOf(*calibration, given.scalar(3), given.scalar(5));
  if (!setting) {
    return setting.takeFailure();
  }
  Gun gun;
  gun.kind = Gun::Kind::calibrated;
  gun.flow = setting->flow;
  gun.angle = setting->halfAngle;
  return finished(std::move(gun), given, 6, "CALIB", [](Gun& g) {
    const double radius = spray::coneRadius(g.standOff, g.angle);
    g.footprint = {radius, radius};
  });
}

Result<Resolved> gunOfTable(const Arguments& given) {
  std::vector<std::pair<double, double>> rows;
  std::size_t at = 1;
  for (; given.isScalar(at); at += 2) {
    rows.emplace_back(given.scalar(at), given.scalar(at + 1));
  }
  return gunOfRows(std::move(rows), given, at);
}

Result<Resolved> gunOfTableFile(const Arguments& given) {
  Result<std::string> text = given.fileText(given.text(1));
  if (!text) {
    return text.takeFailure();
  }
  Result<std::vector<std::pair<double, double>>> rows = columnsOf(*text);
  if (!rows) {
    return rows.takeFailure();
  }
  return gunOfRows(*std::move(rows), given, 2);
}

}  // namespace arelem::define
