#include "backend/robot/machine.h"

#include <cmath>
#include <set>

#include <toml++/toml.h>

#include "ir/diag/robot.h"

namespace arelem::robot {

namespace {
constexpr double longest = 1e6;  // mm
constexpr double fullTurn = 360.0;

/// One table of the file. Remembers the first thing that is wrong, and which keys were asked for.
class Table {
 public:
  Table(const toml::table& table,
        std::string path,
        std::string_view file,
        std::optional<Failure>& failure)
      : table_(table), path_(std::move(path)), file_(file), failure_(failure) {}

  void number(std::string_view key, double& value, double low, double high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const auto found = node->value<double>();
    if (!found || !(*found >= low && *found <= high)) {
      wrong(*node, key, fmt::format("a number from {:g} to {:g}", low, high));
      return;
    }
    value = *found;
  }
  void whole(std::string_view key, int& value, int low, int high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const auto found = node->value_exact<std::int64_t>();
    if (!found || *found < low || *found > high) {
      wrong(*node, key, fmt::format("a whole number from {} to {}", low, high));
      return;
    }
    value = static_cast<int>(*found);
  }
  void flag(std::string_view key, bool& value) {
    if (const toml::node* node = find(key)) {
      const auto found = node->value_exact<bool>();
      found ? void(value = *found) : wrong(*node, key, "true or false");
    }
  }
  void text(std::string_view key, std::string& value) {
    if (const toml::node* node = find(key)) {
      const auto found = node->value_exact<std::string>();
      found ? void(value = *found) : wrong(*node, key, "a text in quotes");
    }
  }
  /// One of the given words; its place in the list.
  void choice(std::string_view key,
              std::size_t& value,
              std::initializer_list<std::string_view> words) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const auto found = node->value_exact<std::string>();
    std::size_t at = 0;
    std::string known;
    for (const std::string_view word : words) {
      if (found && *found == word) {
        value = at;
        return;
      }
      known += (known.empty() ? "\"" : ", \"") + std::string(word) + "\"";
      ++at;
    }
    wrong(*node, key, "one of " + known);
  }
  template <std::size_t count>
  void list(std::string_view key, std::array<double, count>& values, double low, double high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const toml::array* array = node->as_array();
    bool good = array != nullptr && array->size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
      const auto found = array->get(i)->value<double>();
      good = found && *found >= low && *found <= high;
      values[i] = good ? *found : values[i];
    }
    if (!good) {
      wrong(*node, key, fmt::format("a list of {} numbers from {:g} to {:g}", count, low, high));
    }
  }
  void range(std::string_view key, Range& value, double low, double high) {
    std::array<double, 2> both{value.low, value.high};
    list(key, both, low, high);
    if (both[0] > both[1]) {
      wrong(*find(key), key, "two numbers, the smaller first");
    }
    value = {both[0], both[1]};
  }
  /// A table in this one; null when absent.
  const toml::table* table(std::string_view key) {
    const toml::node* node = find(key);
    if (node != nullptr && node->as_table() == nullptr) {
      wrong(*node, key, "a table [" + std::string(key) + "]");
    }
    return node == nullptr ? nullptr : node->as_table();
  }
  /// Nothing else may stand in it.
  void close() {
    for (const auto& [key, node] : table_) {
      if (asked_.count(std::string(key.str())) == 0 && !failure_) {
        std::string known;
        for (const std::string& one : asked_) {
          known += (known.empty() ? "" : ", ") + one;
        }
        failure_ = fail(diag::MachineKey, file_, key.source().begin.line,
                        path_ + std::string(key.str()), known);
      }
    }
  }

 private:
  const toml::node* find(std::string_view key) {
    asked_.insert(std::string(key));
    return table_.get(key);
  }
  void wrong(const toml::node& node, std::string_view key, const std::string& wanted) {
    if (!failure_) {
      failure_ = fail(diag::MachineValue, file_, node.source().begin.line, path_ + std::string(key),
                      wanted);
    }
  }

  const toml::table& table_;
  std::string path_;
  std::string_view file_;
  std::optional<Failure>& failure_;
  std::set<std::string> asked_;
};

class Reader {
 public:
  Reader(const toml::table& root, std::string_view file) : root_(root), file_(file) {}

  Result<Machine> read() {
    machine_.file = file_;
    Table top(root_, "", file_, failure_);
    top.text("name", machine_.name);
    top.number("speed", machine_.speed, 0.0, longest);
    top.number("rapid", machine_.rapid, 1e-3, longest);
    top.number("acceleration", machine_.acceleration, 1e-3, longest);
    top.number("interval", machine_.interval, 1e-3, 10.0);
    top.number("blend", machine_.blend, 1e-3, 1.0);
    with(top, "frame", [&](Table& t) { frame(t); });
    with(top, "scara", [&](Table& t) { scara(t); });
    with(top, "pantograph", [&](Table& t) { pantograph(t); });
    with(top, "elbow", [&](Table& t) { elbow(t); });
    with(top, "tilt", [&](Table& t) { tilt(t); });
    with(top, "vplus", [&](Table& t) { vplus(t); });
    top.close();
    if (failure_) {
      return *std::move(failure_);
    }
    return std::move(machine_);
  }

 private:
  template <class Function>
  void with(Table& top, std::string_view key, Function&& function) {
    if (const toml::table* found = top.table(key)) {
      Table inner(*found, std::string(key) + ".", file_, failure_);
      function(inner);
      inner.close();
    }
  }
  void frame(Table& t) {
    std::array<double, 3> shift{};
    t.list("shift", shift, -longest, longest);
    t.list("angles", machine_.frame.angles, -fullTurn, fullTurn);
    machine_.frame.shift = {shift[0], shift[1], shift[2]};
  }
  void scara(Table& t) {
    Scara& s = machine_.scara.emplace();
    t.number("link1", s.link1, 1.0, longest);
    t.number("link2", s.link2, 1.0, longest);
    t.range("joint1", s.joint1, -fullTurn, fullTurn);
    t.range("joint2", s.joint2, -180.0, 180.0);
    t.range("joint4", s.joint4, -4 * fullTurn, 4 * fullTurn);
    t.range("height", s.height, -longest, longest);
    t.number("stretch", s.stretch, 0.5, 1.0);
    t.flag("lefty", s.lefty);
  }
  void pantograph(Table& t) {
    Pantograph& p = machine_.pantograph.emplace();
    t.number("ratio", p.ratio, 1e-3, 1e3);
    t.number("counts_per_mm", p.countsPerMillimeter, 0.0, 1e9);
    t.number("counts_per_turn", p.countsPerTurn, 0.0, 1e9);
    t.range("actuator", p.actuator, 0.0, longest);
    t.range("turn", p.turn, -fullTurn, fullTurn);
    t.list("speed", p.speed, 1e-3, longest);
    t.list("acceleration", p.acceleration, 1e-3, longest);
  }
  void elbow(Table& t) {
    Elbow& e = machine_.elbow.emplace();
    t.number("link", e.link, 1.0, longest);
    t.number("counts_per_turn", e.countsPerTurn, 1.0, 1e9);
    t.range("elbow", e.elbow, 0.0, 90.0);
    t.range("turn", e.turn, -fullTurn, fullTurn);
    t.list("speed", e.speed, 1e-3, longest);
    t.list("acceleration", e.acceleration, 1e-3, longest);
  }
  void tilt(Table& t) {
    TiltAxis& axis = machine_.tilt.emplace();
    t.number("most", axis.most, 0.1, 90.0);
    t.number("step", axis.step, 1e-3, 10.0);
    t.whole("first_output", axis.firstOutput, 1, 505);
    std::size_t coding = 0;
    t.choice("coding", coding, {"sign-magnitude", "twos-complement"});
    axis.signMagnitude = coding == 0;
  }
  void vplus(Table& t) {
    VplusStyle& style = machine_.vplus;
    std::size_t format = 0;
    t.choice("format", format, {"program", "path-s", "path-b"});
    style.format = static_cast<VplusStyle::Format>(format);
    std::size_t signal = 0;
    t.choice("signal", signal, {"stop", "fly"});
    style.onTheFly = signal == 1;
    t.flag("crlf", style.crlf);
    t.flag("control_z", style.controlZ);
    t.whole("columns", style.columns, 60, 148);
  }

  const toml::table& root_;
  std::string_view file_;
  Machine machine_;
  std::optional<Failure> failure_;
};
}  // namespace

int tiltWord(const TiltAxis& axis, double degrees) {
  const int steps = static_cast<int>(std::lround(degrees / axis.step));
  return axis.signMagnitude ? (steps < 0 ? 128 - steps : steps) : steps & 255;
}

double tiltAngle(const TiltAxis& axis, int word) {
  const int low = word & 127;
  const bool negative = (word & 128) != 0;
  const int steps = !negative ? low : axis.signMagnitude ? -low : low - 128;
  return steps * axis.step;
}

Result<Machine> readMachine(std::string_view text, std::string_view file) {
  try {
    const toml::table root = toml::parse(text, file);
    return Reader(root, file).read();
  } catch (const toml::parse_error& error) {
    return fail(diag::MachineSyntax, file, error.source().begin.line, error.source().begin.column,
                error.description());
  }
}

}  // namespace arelem::robot
