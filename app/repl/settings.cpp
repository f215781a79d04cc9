// :set
#include <array>
#include <charconv>
#include <cmath>

#include "app/repl/console.h"

#include "ir/diag/display_text.h"

namespace arelem::app::repl {

namespace {
struct Setting {
  std::string_view name;
  std::string_view what;
  std::string (*show)(const Console&);
  /// False for a value that it does not take.
  bool (*take)(Console&, const std::string&);
};

bool onOff(const std::string& text, bool& value) {
  if (text != "on" && text != "off") {
    return false;
  }
  value = text == "on";
  return true;
}

bool number(const std::string& text, double& value, bool zero) {
  double read = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  const bool good = error == std::errc{} && end == text.data() + text.size() &&
                    std::isfinite(read) && (read > 0.0 || (zero && read == 0.0));
  value = good ? read : value;
  return good;
}

std::string shown(bool value) {
  return value ? "on" : "off";
}

constexpr std::array settings = {
    Setting{"color", "colors on or off", [](const Console& c) { return shown(c.style.color); },
            [](Console& c, const std::string& t) { return onOff(t, c.style.color); }},
    Setting{"exact", "exact canonical numbers below the readable form: on or off",
            [](const Console& c) { return shown(c.style.exact); },
            [](Console& c, const std::string& t) { return onOff(t, c.style.exact); }},
    Setting{"digits", "significant digits of the readable form, 1 to 17",
            [](const Console& c) { return std::to_string(c.style.digits); },
            [](Console& c, const std::string& t) {
              double n = 0.0;
              const bool good = number(t, n, false) && n <= 17.0 && n == std::floor(n);
              c.style.digits = good ? static_cast<int>(n) : c.style.digits;
              return good;
            }},
    Setting{"velocity", "mm/s, of the machine of :time",
            [](const Console& c) { return fmt::format("{}", c.machine.limits.velocity); },
            [](Console& c, const std::string& t) {
              return number(t, c.machine.limits.velocity, false);
            }},
    Setting{"acceleration", "mm/s2",
            [](const Console& c) { return fmt::format("{}", c.machine.limits.acceleration); },
            [](Console& c, const std::string& t) {
              return number(t, c.machine.limits.acceleration, false);
            }},
    Setting{
        "jerk", "mm/s3", [](const Console& c) { return fmt::format("{}", c.machine.limits.jerk); },
        [](Console& c, const std::string& t) { return number(t, c.machine.limits.jerk, false); }},
    Setting{"deviation", "mm by which corners may be rounded; 0: the tool stops in each",
            [](const Console& c) { return fmt::format("{}", c.machine.deviation); },
            [](Console& c, const std::string& t) { return number(t, c.machine.deviation, true); }},
};
}  // namespace

std::vector<std::string> settingNames() {
  std::vector<std::string> names;
  for (const Setting& s : settings) {
    names.emplace_back(s.name);
  }
  return names;
}

std::string set(Console& console, const std::string& rest) {
  if (rest.empty()) {
    for (const Setting& s : settings) {
      console.out << fmt::format("{:<14}{:<8}{}\n", s.name, s.show(console), s.what);
    }
    return "";
  }
  const std::size_t blank = rest.find_first_of(" \t=");
  const std::string name = rest.substr(0, blank);
  std::string value = blank == std::string::npos ? "" : rest.substr(blank);
  value.erase(0, std::min(value.find_first_not_of(" \t="), value.size()));
  for (const Setting& s : settings) {
    if (s.name == name) {
      if (!value.empty() && !s.take(console, value)) {
        return fmt::format("`{}` is no value of {}: {}", displayText(value), name, s.what);
      }
      console.out << fmt::format("{} {}\n", name, s.show(console));
      return "";
    }
  }
  return "there is no setting `" + displayText(name) + "`; :set lists them";
}

}  // namespace arelem::app::repl
