#include "backend/vplus/program_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "backend/vplus/name.h"
#include "ir/diag/robot.h"

namespace arelem::vplus {

namespace {
constexpr std::size_t indent = 2;
constexpr int mostDecimals = 3;
}  // namespace

std::string numberText(double value) {
  // A V+ real has 24 bits: further digits would not be read.
  int decimals = mostDecimals;
  for (double most = 1e4; decimals > 0 && std::abs(value) >= most; most *= 10.0) {
    --decimals;
  }
  std::string text = fmt::format("{:.{}f}", value, decimals);
  return std::strtod(text.c_str(), nullptr) == 0.0 ? fmt::format("{:.{}f}", 0.0, decimals) : text;
}

std::string speedText(double value) {
  return value < 1.0 ? fmt::format("{:.6f}", value) : numberText(value);
}

std::string transText(const Vec3& point, const robot::Euler& angles) {
  std::string roll = numberText(angles.roll);
  if (roll == "-180.000") {
    roll.erase(0, 1);
  }
  std::string yaw = numberText(angles.yaw);
  if (yaw == "-180.000") {
    yaw.erase(0, 1);
  }
  return fmt::format("TRANS({}, {}, {}, {}, {}, {})", numberText(point.x()), numberText(point.y()),
                     numberText(point.z()), yaw, numberText(angles.pitch), roll);
}

std::optional<Failure> ProgramLines::add(std::string text) {
  const std::size_t columns = indent + text.size();
  if (columns > longestLine) {
    return fail(diag::VplusLineLength, columns, longestLine);
  }
  lines_.push_back(std::move(text));
  return std::nullopt;
}

void ProgramLines::comment(std::string text) {
  const std::size_t most = static_cast<std::size_t>(style_.columns) - indent - 2;
  do {
    const std::size_t cut = text.size() <= most ? text.size() : text.rfind(' ', most);
    const std::size_t length = cut == std::string::npos || cut == 0 ? most : cut;
    lines_.push_back("; " + text.substr(0, length));
    text.erase(0, std::min(text.size(), text.find_first_not_of(' ', length)));
  } while (!text.empty());
}

std::string ProgramLines::text(std::string_view name, const robot::Frame& frame) const {
  const std::string end = style_.crlf ? "\r\n" : "\n";
  std::string text = ".PROGRAM " + programName(name) + "()" + end;
  text += "  ; made by arelem from CL data" + end;
  text += "  AUTO f" + end;
  const auto& angles = frame.angles;
  text += "  SET f = " + transText(frame.shift, {angles[0], angles[1], angles[2]}) + end;
  if (style_.tool) {
    const auto& t = *style_.tool;
    text += "  TOOL " + transText({t[0], t[1], t[2]}, {t[3], t[4], t[5]}) + end;
  }
  text += "  ACCEL 100, 100" + end;
  for (const std::string& line : lines_) {
    text += "  " + line + end;
  }
  text += "  BREAK" + end + "  RETURN" + end + ".END" + end;
  if (style_.controlZ) {
    text += "\f\x1a";
  }
  return text;
}

}  // namespace arelem::vplus
