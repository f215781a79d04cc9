// STENCL: words to a statement of runtime/stencil, its tracks to actions.
#include "runtime/stencil/stencil.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "ir/diag/stencil.h"
#include "ir/space/stencil_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/angle.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/worded.h"
#include "runtime/spray/gun.h"

namespace arelem::runtime::interpret {

namespace {
using stencil::TiltRule;

/// Degrees; nozzles of flat fans have 15 to 120.
constexpr double narrowestFan = 5.0;
constexpr double widestFan = 165.0;
/// Letters, mm: lower ones have no width that programs can tell, higher ones no road.
constexpr double lowestLetter = 1.0;
constexpr double highestLetter = 1e6;
constexpr double radian = std::numbers::pi / 180.0;
constexpr std::string_view form =
    "STENCL/ 'TEXT', HEIGHT, h, {GUN, gun | FAN, deg [, c0, c1]} [, SPEED, mm per second "
    "[, largest] | FILM, mm] [, ORIGIN, point] [, ATANGL, deg] [, SPACE, w] [, NUMPTS, n] "
    "[, TILT, {OFF|TRAPZ|QUADR|BEST} [, largest [, degrees per second]]] [, LEAD, on, off] "
    "[, OUTPUT, n] [, ALPHAB, 'file'] [, COMPAT]";

/// Reads the parameters of STENCL from left to right. Lengths become mm.
class Reader : private WordedReader {
 public:
  Reader(const Items& items, double millimeters) : WordedReader(items), unit_(millimeters) {}

  Result<stencil::Statement> run() {
    if (auto failure = readText(made_.text)) {
      return *std::move(failure);
    }
    if (auto failure = whole()) {
      return *std::move(failure);
    }
    return std::move(made_);
  }

 private:
  [[nodiscard]] Failure wrong(std::string what, std::string rule) const override {
    return fail(diag::StencilForm, std::move(what), std::move(rule))
        .withHelp("the form is " + std::string(form));
  }
  [[nodiscard]] Failure refused(std::string_view name,
                                double value,
                                std::string_view rule) const override {
    return fail(diag::StencilNumber, name, value, rule);
  }

  /// What must stand together, and what not.
  std::optional<Failure> whole() {
    if (!has(Word::HEIGHT)) {
      return wrong("no HEIGHT", "HEIGHT is needed");
    }
    if (has(Word::GUN) == has(Word::FAN)) {
      return has(Word::GUN) ? wrong("both GUN and FAN", "one of them says what sprays")
                            : wrong("no GUN and no FAN", "one of them is needed");
    }
    const double height = made_.placement.height;
    if (!(height >= lowestLetter && height <= highestLetter)) {
      return fail(diag::StencilNumber, "HEIGHT in mm", height,
                  fmt::format("{:g} to {:g}", lowestLetter, highestLetter));
    }
    const stencil::FanGun& gun = made_.job.gun;
    if (!(gun.fan >= narrowestFan && gun.fan <= widestFan)) {
      return refused(
          "the angle of the fan", gun.fan,
          "5 to 165 degrees: a narrower fan would stand more than eleven widths over its "
          "line, a wider one on the ground");
    }
    if (has(Word::FILM)) {
      if (has(Word::SPEED)) {
        return wrong("both SPEED and FILM", "one follows from the other");
      }
      if (gun.flow <= 0.0) {
        return wrong("FILM without a GUN that has FLOW", "the flow says how fast a film is laid");
      }
    } else if (!has(Word::SPEED) && gun.speed <= 0.0) {
      return wrong("no SPEED", "SPEED is needed, or FILM, or a GUN that has SPEED");
    }
    // A word of the statement goes before one of the gun.
    if (has(Word::OUTPUT)) {
      made_.output = output_;
    }
    if (has(Word::LEAD)) {
      made_.job.gun.leadOn = leadOn_;
      made_.job.gun.leadOff = leadOff_;
    }
    if (largest_ > 0.0) {
      made_.job.gun.speed = largest_;
    }
    return std::nullopt;
  }

  std::optional<Failure> value(Word word) override {
    switch (word) {
      case Word::HEIGHT:
        return positive(word, made_.placement.height, unit_);
      case Word::FAN:
        return fan();
      case Word::GUN:
        return gun();
      case Word::FILM:
        return positive(word, made_.film);
      case Word::LEAD:
        return lead();
      case Word::OUTPUT:
        return output();
      case Word::ORIGIN:
        return origin();
      case Word::ATANGL:
        return number(word, made_.placement.angle);
      case Word::SPACE:
        return space();
      case Word::TILT:
        return tilt();
      case Word::NUMPTS:
        return points();
      case Word::SPEED:
        return speed();
      case Word::ALPHAB:
        return fileName(word, made_.alphabet);
      case Word::COMPAT:
        made_.job.asSource = true;
        return std::nullopt;
      default:
        return meaningless(word);
    }
  }

  /// FAN, deg [, c0, c1]: the full angle, and a measured height = c0 + c1 width.
  std::optional<Failure> fan() {
    stencil::FanGun& fan = made_.job.gun;
    if (auto failure = number(Word::FAN, fan.fan)) {
      return failure;
    }
    if (!more()) {
      return std::nullopt;
    }
    if (auto failure = number(Word::FAN, fan.heightAtZero, unit_)) {
      return failure;
    }
    if (auto failure = number(Word::FAN, fan.heightSlope)) {
      return failure;
    }
    return fan.heightSlope > 0.0
               ? std::nullopt
               : std::optional(refused("the second number of the height of FAN", fan.heightSlope,
                                       "positive: wider lines need a higher nozzle"));
  }
  /// GUN, a gun with a flat fan.
  std::optional<Failure> gun() {
    const EntityPtr found = take(EntityType::gun);
    if (!found) {
      return wrong("GUN without a gun", "a GUN belongs there");
    }
    const spray::Gun gun = spray::Gun::of(found->canon);
    if (gun.kind != spray::Gun::Kind::fan) {
      return fail(diag::StencilGun, found->name);
    }
    stencil::FanGun& fan = made_.job.gun;
    fan.fan = 2.0 * gun.angle / radian;
    fan.heightAtZero = gun.heightAtZero;
    fan.heightSlope = gun.heightSlope;
    fan.speed = gun.speed;
    fan.leadOn = gun.leadOn;
    fan.leadOff = gun.leadOff;
    fan.flow = gun.flow;
    fan.efficiency = gun.efficiency;
    made_.output = gun.output;
    return std::nullopt;
  }
  /// SPEED, v [, most]: over a line one grid unit wide, and the largest of the gun.
  std::optional<Failure> speed() {
    if (auto failure = positive(Word::SPEED, made_.speed)) {
      return failure;
    }
    if (!more()) {
      return std::nullopt;
    }
    if (auto failure = number(Word::SPEED, largest_)) {
      return failure;
    }
    return largest_ > 0.0
               ? std::nullopt
               : std::optional(refused("the largest speed of SPEED", largest_, "positive"));
  }
  std::optional<Failure> space() {
    double& space = made_.placement.space.emplace();
    if (auto failure = number(Word::SPACE, space, unit_)) {
      return failure;
    }
    return space >= 0.0 ? std::nullopt
                        : std::optional(refused("SPACE", space / unit_,
                                                "0 or more: symbols would cover each other"));
  }
  std::optional<Failure> lead() {
    if (auto failure = number(Word::LEAD, leadOn_)) {
      return failure;
    }
    if (auto failure = number(Word::LEAD, leadOff_)) {
      return failure;
    }
    const double least = std::min(leadOn_, leadOff_);
    return least < 0.0 ? std::optional(fail(diag::StencilNumber, "a LEAD time", least, "0 or more"))
                       : std::nullopt;
  }
  std::optional<Failure> output() {
    double value = 0.0;
    if (auto failure = number(Word::OUTPUT, value)) {
      return failure;
    }
    constexpr double mostOutputs = 4095.0;
    if (value < 1.0 || value > mostOutputs || value != std::round(value)) {
      return fail(diag::StencilNumber, "OUTPUT", value, "a whole number from 1 to 4095");
    }
    output_ = static_cast<int>(value);
    return std::nullopt;
  }

  std::optional<Failure> origin() {
    const EntityPtr point = take(EntityType::point);
    if (!point) {
      return wrong("ORIGIN without a point", "a POINT belongs there");
    }
    const std::vector<double>& p = point->canon;
    made_.placement.origin = unit_ * stencil::Vec2(p[0], p[1]);
    made_.ground = unit_ * p[2];
    return std::nullopt;
  }

  std::optional<Failure> tilt() {
    const Word* word = next() != nullptr ? std::get_if<Word>(&next()->value) : nullptr;
    const std::map<Word, TiltRule> rules = {{Word::OFF, TiltRule::off},
                                            {Word::TRAPZ, TiltRule::trapezoid},
                                            {Word::QUADR, TiltRule::quadrilateral},
                                            {Word::BEST, TiltRule::best}};
    if (word == nullptr || rules.count(*word) == 0) {
      return wrong("TILT without a rule", "OFF, TRAPZ, QUADR or BEST belongs there");
    }
    made_.job.tilt = rules.at(*word);
    skip();
    stencil::TiltLimits& limits = made_.job.limits;
    if (more()) {
      if (auto failure = number(Word::TILT, limits.most)) {
        return failure;
      }
      if (!(limits.most > 0.0 && limits.most < 90.0)) {
        return refused("the largest tilt of TILT", limits.most, "above 0 and below 90 degrees");
      }
    }
    if (!more()) {
      return std::nullopt;
    }
    if (auto failure = number(Word::TILT, limits.rate)) {
      return failure;
    }
    return limits.rate > 0.0 ? std::nullopt
                             : std::optional(refused("the rate of TILT, in degrees a second,",
                                                     limits.rate, "positive"));
  }

  std::optional<Failure> points() {
    double value = 0.0;
    if (auto failure = number(Word::NUMPTS, value)) {
      return failure;
    }
    constexpr double most = 10000.0;
    const double whole = std::round(value);
    if (std::abs(value - whole) > tolerance::wholeNumber || whole < 2.0 || whole > most) {
      return fail(diag::StencilNumber, "NUMPTS", value, "a whole number from 2 to 10000");
    }
    made_.cells = static_cast<int>(whole) - 1;
    return std::nullopt;
  }

  double unit_;
  stencil::Statement made_;
  int output_ = 1;
  double leadOn_ = 0.0, leadOff_ = 0.0;
  double largest_ = 0.0;
};

/// Puts the tracks into the stream: poses of the gun, its switching, feeds.
class TrackWriter {
 public:
  TrackWriter(State& state, const stencil::Statement& statement)
      : state_(state), statement_(statement), unit_(state.context.millimeters) {}

  void write(const std::vector<stencil::Track>& tracks) {
    const stencil::FanGun& gun = statement_.job.gun;
    if (gun.flow > 0.0 && !statement_.job.asSource) {
      post(Word::FLOW, {spray::toldFlow(gun.flow)});
    }
    for (const stencil::Track& track : tracks) {
      write(track);
    }
  }

 private:
  void write(const stencil::Track& track) {
    post(Word::RAPID, {});
    for (std::size_t i = 0; i < track.poses.size(); ++i) {
      go(track.poses[i]);
      if (i == track.off) {
        post(Word::SPRAY, {Word::OFF, static_cast<double>(statement_.output)});
      }
      if (i == track.on) {
        post(Word::SPRAY, {Word::ON, static_cast<double>(statement_.output)});
      }
      // The speed of the last line is no move's; the source prints it all the same.
      if (i + 1 < track.poses.size() || statement_.job.asSource) {
        post(Word::FEDRAT, {track.poses[i].speed, Word::MMPS});
      }
    }
  }
  void post(Word word, std::vector<cl::Value> values) {
    state_.emit(Pass{cl::Post{word, "", std::move(values)}});
  }
  void go(const stencil::Pose& pose) {
    const auto [sy, cy] = geometry::sinCosDegrees(pose.yaw);
    const auto [st, ct] = geometry::sinCosDegrees(pose.tilt);
    Locate locate;
    locate.word = Word::GOTO;
    const Vec3 place(pose.place.x(), pose.place.y(), statement_.ground + pose.height);
    locate.point = state_.systems.pointToBase(place / unit_);
    locate.axis = state_.systems.vectorToBase({st * cy, st * sy, ct});
    locate.side = state_.systems.vectorToBase({ct * cy, ct * sy, -st});
    state_.emit(std::move(locate));
  }

  State& state_;
  const stencil::Statement& statement_;
  double unit_;
};
}  // namespace

void stencil(State& state, const ir::Command& command) {
  state.meetImplied("STENCL", false, true);
  const auto items = evaluate(state, command.arguments, Use::definition);
  if (!items) {
    return;
  }
  Result<stencil::Statement> statement = Reader(*items, state.context.millimeters).run();
  if (!statement) {
    reportAt(state, state.statement->span, statement.takeFailure(), *items);
    return;
  }
  const Vec3 up = state.systems.vectorToBase(Vec3::UnitZ()).normalized();
  const double lean = std::acos(std::clamp(up.z(), -1.0, 1.0)) / radian;
  if (lean > tolerance::levelGround) {
    reportAt(state, state.statement->span, fail(diag::StencilSystem, state.systems.current(), lean),
             *items);
    return;
  }
  Result<stencil::Painted> painted = stencil::paint(
      *statement, state.options.files, state.options.limits, statement->placement.origin);
  if (!painted) {
    reportAt(state, state.statement->span, painted.takeFailure(), *items);
    return;
  }
  painted->origin = state.statement->span;
  painted->base = state.systems.pointToBase(Vec3::Zero());
  painted->across = state.systems.vectorToBase(Vec3::UnitX());
  painted->along = state.systems.vectorToBase(Vec3::UnitY());
  TrackWriter(state, *statement).write(painted->tracks);
  state.out.stencils.push_back(std::make_shared<const stencil::Painted>(*std::move(painted)));
}

}  // namespace arelem::runtime::interpret
