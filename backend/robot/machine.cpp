#include "backend/robot/machine.h"

#include <cmath>

#include "backend/robot/machine_table.h"
#include "ir/diag/robot.h"

namespace arelem::robot {

namespace {
constexpr double longest = longestLength;

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
    top.with("frame", [&](Table& t) { frame(t); });
    top.with("scara", [&](Table& t) { scara(t); });
    top.with("pantograph", [&](Table& t) { pantograph(t); });
    top.with("elbow", [&](Table& t) { elbow(t); });
    top.with("tilt", [&](Table& t) { tilt(t); });
    top.with("vplus", [&](Table& t) { vplus(t); });
    top.with("envelope", [&](Table& t) { envelope(t); });
    top.with("g97", [&](Table& t) { g97(t); });
    readControl(top, machine_);
    top.close();
    if (failure_) {
      return *std::move(failure_);
    }
    return std::move(machine_);
  }

 private:
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
    // Seven bits of the word hold the number of steps.
    constexpr double mostSteps = 127.0;
    if (!failure_ && std::round(axis.most / axis.step) > mostSteps) {
      t.wrong("most", fmt::format("at most {:g} times `step`, {:g}: more does not fit in the word",
                                  mostSteps, mostSteps * axis.step));
    }
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
    t.number("approach", style.approach, 0.0, longest);
    if (t.has("tool")) {
      t.list("tool", style.tool.emplace(), -longest, longest);
    }
  }

  void envelope(Table& t) {
    Envelope& e = machine_.envelope.emplace();
    t.range("x", e.sides[0], -longest, longest);
    t.range("y", e.sides[1], -longest, longest);
    t.range("z", e.sides[2], -longest, longest);
    std::array<double, 3> center{};
    t.list("center", center, -longest, longest);
    e.center = {center[0], center[1], center[2]};
    t.range("reach", e.reach, 0.0, longest);
    t.number("lean", e.lean, 0.0, 180.0);
  }
  void g97(Table& t) {
    G97Style& style = machine_.g97;
    t.whole("program", style.program, 1, 9999);
    t.flag("program_line", style.programLine);
    t.whole("blocks", style.blocks, 2, 9999);
    std::size_t choice = 0;
    t.choice("wrist", choice, {"N", "F"});
    style.flipped = choice == 1;
    choice = 0;
    t.choice("arm", choice, {"F", "B"});
    style.back = choice == 1;
    t.wholes("turns", style.turns, -1, 1, 3);
    choice = 0;
    t.choice("angles", choice, {"moving", "fixed"});
    style.fixedAxes = choice == 1;
    choice = 0;
    t.choice("roll", choice, {"zero", "upright"});
    style.uprightRoll = choice == 1;
    choice = 0;
    t.choice("coordinates", choice, {"work", "base"});
    style.inBase = choice == 1;
    std::array<double, 3> tool{};
    t.list("tool", tool, -longest, longest);
    style.tool = {tool[0], tool[1], tool[2]};
    t.wholes("outputs", style.outputs, 1, 9999);
    t.text("s63", style.s63);
    t.texts("words", style.words);
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
