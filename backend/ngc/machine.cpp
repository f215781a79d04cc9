#include "backend/ngc/machine.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <toml++/toml.h>

#include "ir/diag/ngc.h"
#include "ir/space/tolerance.h"

namespace arelem::backend::ngc {

namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

/// Takes known keys out of a table; what is left is unknown.
class Reader {
 public:
  explicit Reader(toml::table& table) : table_(table) {}

  template <class Value>
  void take(const char* key, Value& into) {
    const auto node = table_.get(key);
    if (node == nullptr) {
      return;
    }
    if (const auto value = node->value<Value>()) {
      into = *value;
      table_.erase(key);
    } else {
      wrong(key, "has another type of value");
    }
  }
  void takeInRange(const char* key, double& into, double least) {
    take(key, into);
    if (!(into >= least) || !std::isfinite(into)) {
      wrong(key, fmt::format("is {}; at least {} is needed", into, least));
    }
  }
  void takeDecimals(const char* key, int& into) {
    take(key, into);
    if (into < 1 || into > 8) {
      wrong(key, fmt::format("is {}; 1 to 8 are possible", into));
    }
  }
  void takePoint(const char* key, Vec3& into) {
    const toml::array* array = table_[key].as_array();
    if (array == nullptr) {
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = array->size() == 3 ? (*array)[i].value<double>() : std::nullopt;
      if (!value) {
        return wrong(key, "is not three numbers");
      }
      into(static_cast<Eigen::Index>(i)) = *value;
    }
    table_.erase(key);
  }
  void wrong(std::string_view key, std::string_view what) {
    if (!failure) {
      failure = fail(diag::MachineFile, fmt::format("`{}` {}", key, what));
    }
  }
  std::optional<Failure> failure;

 private:
  toml::table& table_;
};

void takeTurning(Reader& reader, Machine& machine) {
  std::string name = "none";
  reader.take("kinematics", name);
  constexpr std::array names = {"none", "table-ac", "table-bc", "head-ac", "head-bc"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i]) {
      machine.turning = static_cast<Machine::Turning>(i);
      return;
    }
  }
  reader.wrong("kinematics",
               "is `" + name + "`; there are none, table-ac, table-bc, head-ac, head-bc");
}

bool isTable(Machine::Turning turning) {
  return turning == Machine::Turning::tableAc || turning == Machine::Turning::tableBc;
}

/// The turn next to `before` among those that differ by whole turns.
double nextTo(double angle, double before) {
  return angle + 360.0 * std::round((before - angle) / 360.0);
}

}  // namespace

Result<Machine> readMachine(std::string_view text) {
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& error) {
    return fail(diag::MachineFile,
                fmt::format("line {}: {}", error.source().begin.line, error.description()));
  }
  Machine machine;
  Reader reader(table);
  std::string units = "mm";
  reader.take("units", units);
  machine.inches = units == "inch";
  if (units != "mm" && units != "inch") {
    reader.wrong("units", "is `" + units + "`; there are mm and inch");
  }
  machine.decimals = machine.inches ? 5 : 4;
  reader.takeDecimals("decimals", machine.decimals);
  reader.takeDecimals("angle_decimals", machine.angleDecimals);
  reader.takeInRange("blend", machine.blend, 0.0);
  reader.takeInRange("arc_tolerance", machine.arcTolerance, 0.0);
  reader.takeInRange("pivot_length", machine.pivotLength, 0.0);
  reader.take("arcs", machine.arcs);
  reader.take("cycles", machine.cycles);
  reader.take("tool_length", machine.toolLength);
  reader.take("line_numbers", machine.lineNumbers);
  reader.take("tool_point", machine.toolPoint);
  reader.takePoint("center", machine.center);
  reader.take("end", machine.end);
  if (machine.end != "M2" && machine.end != "M30") {
    reader.wrong("end", "is `" + machine.end + "`; there are M2 and M30");
  }
  std::string name;
  reader.take("name", name);
  takeTurning(reader, machine);
  if (reader.failure) {
    return *std::move(reader.failure);
  }
  if (!table.empty()) {
    return fail(diag::MachineFile,
                fmt::format("`{}` is no key of a control file", table.begin()->first.str()));
  }
  return machine;
}

Angles anglesOf(const Machine& machine, const Vec3& axis, const Angles& before) {
  const double across = std::hypot(axis.x(), axis.y());
  const double tilt = std::atan2(across, axis.z()) * degrees;
  if (across <= tolerance::nullDirection) {
    return {tilt, before.turn};  // every turn is as good: no axis moves for nothing
  }
  Angles one{tilt, 0.0};
  switch (machine.turning) {
    case Machine::Turning::tableAc:
      one.turn = std::atan2(axis.x(), axis.y()) * degrees;
      break;
    case Machine::Turning::tableBc:
      one = {-tilt, -std::atan2(axis.y(), axis.x()) * degrees};
      break;
    case Machine::Turning::headAc:
      one.turn = std::atan2(axis.x(), -axis.y()) * degrees;
      break;
    case Machine::Turning::headBc:
      one.turn = std::atan2(axis.y(), axis.x()) * degrees;
      break;
    case Machine::Turning::none:
      return {};
  }
  // The same axis with the tilt to the other side and half a turn.
  const Angles a{one.tilt, nextTo(one.turn, before.turn)};
  const Angles b{-one.tilt, nextTo(one.turn + 180.0, before.turn)};
  const auto way = [&](const Angles& to) {
    return std::abs(to.turn - before.turn) + std::abs(to.tilt - before.tilt);
  };
  return way(b) < way(a) ? b : a;
}

Vec3 axesOf(const Machine& machine, const Vec3& toolEnd, const Vec3& axis, const Angles& angles) {
  if (machine.turning == Machine::Turning::none || machine.toolPoint) {
    return toolEnd;
  }
  if (!isTable(machine.turning)) {
    return toolEnd + machine.pivotLength * (axis - Vec3::UnitZ());
  }
  const Vec3 tiltAxis =
      machine.turning == Machine::Turning::tableAc ? Vec3::UnitX() : Vec3::UnitY();
  const Eigen::Matrix3d turned = (Eigen::AngleAxisd(angles.tilt / degrees, tiltAxis) *
                                  Eigen::AngleAxisd(angles.turn / degrees, Vec3::UnitZ()))
                                     .toRotationMatrix();
  return turned * (toolEnd - machine.center) + machine.center;
}

}  // namespace arelem::backend::ngc
