#include "runtime/region/drawing.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ir/diag/spray.h"
#include "ir/space/tolerance.h"
#include "runtime/region/drawing_curves.h"

namespace arelem::region {

namespace {
/// Millimeters of $INSUNITS; 0 where the drawing has no unit.
double millimetersOf(long code) {
  switch (code) {
    case 1:
      return 25.4;
    case 2:
      return 304.8;
    case 4:
      return 1.0;
    case 5:
      return 10.0;
    case 6:
      return 1000.0;
    case 3:
      return 1'609'344.0;
    case 7:
      return 1e6;
    case 8:
      return 25.4e-6;
    case 9:
      return 25.4e-3;
    case 10:
      return 914.4;
    case 11:
      return 1e-7;
    case 12:
      return 1e-6;
    case 13:
      return 1e-3;
    case 14:
      return 100.0;
    case 15:
      return 1e4;
    case 16:
      return 1e5;
    default:
      return 0.0;
  }
}

/// The objects of one section, in order; empty when there is none.
std::vector<DrawingObject> section(const std::vector<Group>& groups, std::string_view wanted) {
  std::vector<DrawingObject> objects;
  bool inside = false;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const Group& group = groups[i];
    if (group.code == 0 && group.value == "SECTION" && i + 1 < groups.size() &&
        groups[i + 1].code == 2) {
      inside = groups[i + 1].value == wanted;
      ++i;
    } else if (group.code == 0 && group.value == "ENDSEC") {
      inside = false;
    } else if (inside && group.code == 0) {
      objects.push_back({group.value, group.line, {}});
    } else if (inside && !objects.empty()) {
      objects.back().groups.push_back(group);
    }
  }
  return objects;
}

double unitOf(const std::vector<Group>& groups) {
  for (std::size_t i = 0; i + 1 < groups.size(); ++i) {
    if (groups[i].code == 9 && groups[i].value == "$INSUNITS") {
      const Result<double> code = numberOf(groups[i + 1], "");
      return code ? millimetersOf(wholeOf(*code)) : 0.0;
    }
  }
  return 0.0;
}

class Reader {
 public:
  Reader(std::string_view name, const DrawingRules& rules, double scale)
      : name_(name),
        rules_(rules),
        scale_(scale),
        curves_(name, rules.chord / scale, rules.mostPoints) {}

  Result<Drawing> run(const std::vector<DrawingObject>& entities) {
    for (std::size_t i = 0; i < entities.size(); ++i) {
      const std::size_t first = i + 1;
      const DrawingObject& entity = entities[i];
      if (entity.name == "POLYLINE") {
        while (i + 1 < entities.size() && entities[i + 1].name == "VERTEX") {
          ++i;
        }
      }
      if (auto failure = take(entity, std::span(entities).subspan(first, i + 1 - first))) {
        return *std::move(failure);
      }
    }
    drawing_.layers.assign(layers_.begin(), layers_.end());
    return std::move(drawing_);
  }

 private:
  std::optional<Failure> take(const DrawingObject& entity,
                              std::span<const DrawingObject> vertices) {
    if (entity.name == "SEQEND") {
      return std::nullopt;
    }
    const std::string layer(entity.text(8, "0"));
    layers_.insert(layer);
    if (!rules_.layer.empty() && layer != rules_.layer) {
      return std::nullopt;
    }
    if (entity.text(67, "0") == "1") {
      ++drawing_.unusable[std::string(entity.name) + " in paper space"];
      return std::nullopt;
    }
    if (!CurveReader::knows(entity.name)) {
      ++drawing_.unusable[std::string(entity.name)];
      return std::nullopt;
    }
    Result<Curve> curve = curves_.read(entity, vertices);
    if (!curve) {
      return curve.takeFailure();
    }
    points_ += curve->points.size();
    if (points_ > rules_.mostPoints) {
      return fail(diag::RegionSize, rules_.mostPoints)
          .withHelp(fmt::format("`{}` line {}; a larger CHORD makes fewer", name_, entity.line));
    }
    for (Vec2& p : curve->points) {
      p *= scale_;
    }
    curve->height *= scale_;
    if (drawing_.curves.empty()) {
      drawing_.height = curve->height;
    } else if (std::abs(curve->height - drawing_.height) > tolerance::drawingJoint) {
      return fail(diag::DrawingSyntax, name_, entity.line,
                  fmt::format("{} lies at z = {:.9g}, the curves before it at {:.9g}", entity.name,
                              curve->height, drawing_.height));
    }
    drawing_.curves.push_back(*std::move(curve));
    return std::nullopt;
  }

  std::string_view name_;
  const DrawingRules& rules_;
  double scale_;
  CurveReader curves_;
  Drawing drawing_;
  std::set<std::string> layers_;
  std::size_t points_ = 0;
};
}  // namespace

Result<Drawing> readDrawing(std::string_view text,
                            std::string_view name,
                            const DrawingRules& rules) {
  Result<std::vector<Group>> groups = groupsOf(text, name);
  if (!groups) {
    return groups.takeFailure();
  }
  const double unit = unitOf(*groups);
  return Reader(name, rules, unit > 0.0 ? unit / rules.unit : 1.0)
      .run(section(*groups, "ENTITIES"));
}

}  // namespace arelem::region
