#include "runtime/region/drawing.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "ir/diag/spray.h"
#include "ir/space/tolerance.h"
#include "runtime/region/drawing_blocks.h"

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

/// What the table of layers says of one.
struct LayerState {
  bool off = false, frozen = false;
};
using LayerStates = std::map<std::string, LayerState, std::less<>>;

Result<LayerStates> layerStates(const std::vector<DrawingObject>& tables, std::string_view name) {
  LayerStates states;
  for (const DrawingObject& object : tables) {
    if (object.name != "LAYER") {
      continue;
    }
    LayerState& state = states[std::string(object.text(2))];
    for (const Group& group : object.groups) {
      if (group.code == 62 || group.code == 70) {
        const Result<double> value = numberOf(group, name);
        if (!value) {
          return value.failure();
        }
        (group.code == 62 ? state.off : state.frozen) =
            group.code == 62 ? *value < 0.0 : (wholeOf(*value) & 1) != 0;
      }
    }
  }
  return states;
}

class Reader {
 public:
  Reader(std::string_view name,
         const DrawingRules& rules,
         double scale,
         LayerStates states,
         DrawingBlocks blocks)
      : name_(name),
        rules_(rules),
        scale_(scale),
        states_(std::move(states)),
        blocks_(std::move(blocks)) {}

  Result<Drawing> run(const std::vector<DrawingObject>& entities) {
    if (auto failure = takeAll(entities, {}, "0", 0)) {
      return *std::move(failure);
    }
    drawing_.layers.assign(layers_.begin(), layers_.end());
    return std::move(drawing_);
  }

 private:
  using Problem = std::optional<Failure>;

  /// `layer`: that of the INSERT, which entities of its block on layer 0 take.
  Problem takeAll(const std::vector<DrawingObject>& entities,
                  const Placement& placement,
                  const std::string& layer,
                  int depth) {
    for (std::size_t i = 0; i < entities.size(); ++i) {
      const std::size_t first = i + 1;
      const DrawingObject& entity = entities[i];
      if (entity.name == "POLYLINE") {
        while (i + 1 < entities.size() && entities[i + 1].name == "VERTEX") {
          ++i;
        }
      }
      const std::string own(entity.text(8, "0"));
      const std::string& on = depth > 0 && own == "0" ? layer : own;
      const std::span vertices = std::span(entities).subspan(first, i + 1 - first);
      Problem failure = entity.name == "INSERT" ? insert(entity, placement, on, depth)
                                                : take(entity, vertices, placement, on, depth);
      if (failure) {
        return failure;
      }
    }
    return std::nullopt;
  }

  static void count(Drawing::Kinds& kinds, const DrawingObject& entity, std::string_view why) {
    Drawing::Kind& kind = kinds[fmt::format("{}{}{}", entity.name, why.empty() ? "" : " ", why)];
    kind.line = kind.count++ == 0 ? entity.line : kind.line;
  }

  /// Why the drawing does not show an entity, "" where it does.
  [[nodiscard]] std::string hiddenBy(const DrawingObject& entity, const std::string& layer) const {
    if (entity.text(67, "0") == "1") {
      return "in paper space";
    }
    if (entity.text(60, "0") == "1") {
      return "that is invisible";
    }
    const auto state = states_.find(layer);
    if (state == states_.end() || layer == rules_.layer) {
      return "";
    }
    // What a block has on other layers is seen where the layer of its INSERT is off.
    const bool off = state->second.off && entity.name != "INSERT";
    return off || state->second.frozen
               ? fmt::format("on layer `{}`, which is {}", layer, off ? "off" : "frozen")
               : "";
  }

  Problem insert(const DrawingObject& entity,
                 const Placement& placement,
                 const std::string& layer,
                 int depth) {
    if (const std::string why = hiddenBy(entity, layer); !why.empty()) {
      count(drawing_.hidden, entity, why);
      return std::nullopt;
    }
    const std::string_view block = entity.text(2);
    const auto found = blocks_.find(block);
    if (found == blocks_.end() || depth == deepest) {
      layers_.insert(layer);
      if (rules_.layer.empty() || layer == rules_.layer) {
        count(drawing_.useless, entity,
              fmt::format("of block `{}`, which {}", block,
                          depth == deepest ? "lies in too many blocks or in itself"
                                           : "the drawing does not have"));
      }
      return std::nullopt;
    }
    const Result<InsertedBlock> inserted = insertedBlock(entity, found->second, name_);
    if (!inserted) {
      return inserted.failure();
    }
    if (!inserted->level) {
      count(drawing_.useless, entity, "that is not parallel to the xy plane or has a scale of 0");
      return std::nullopt;
    }
    for (double k = 0.0; k < inserted->rows; ++k) {
      for (double i = 0.0; i < inserted->columns; ++i) {
        if (++points_ > rules_.mostPoints) {
          return tooMany(entity);
        }
        if (auto failure = takeAll(found->second.entities, placement.of(inserted->at(i, k)), layer,
                                   depth + 1)) {
          return failure;
        }
      }
    }
    return std::nullopt;
  }

  Problem take(const DrawingObject& entity,
               std::span<const DrawingObject> vertices,
               const Placement& placement,
               const std::string& layer,
               int depth) {
    // ATTDEF in a block is a form for the texts of its INSERT.
    if (entity.name == "SEQEND" || (depth > 0 && entity.name == "ATTDEF")) {
      return std::nullopt;
    }
    layers_.insert(layer);
    if (!rules_.layer.empty() && layer != rules_.layer) {
      return std::nullopt;
    }
    if (const std::string why = hiddenBy(entity, layer); !why.empty()) {
      count(drawing_.hidden, entity, why);
      return std::nullopt;
    }
    if (!CurveReader::knows(entity.name)) {
      count(drawing_.useless, entity, "");
      return std::nullopt;
    }
    const CurveReader curves(name_, rules_.chord / (scale_ * placement.size), rules_.mostPoints);
    Result<Curve> curve = curves.read(entity, vertices);
    if (!curve) {
      return curve.takeFailure();
    }
    if (!curve->useless.empty()) {
      count(drawing_.useless, entity, curve->useless);
      return std::nullopt;
    }
    return add(entity, *std::move(curve), placement);
  }

  Problem add(const DrawingObject& entity, Curve curve, const Placement& placement) {
    points_ += curve.points.size();
    if (points_ > rules_.mostPoints) {
      return tooMany(entity);
    }
    for (Vec2& p : curve.points) {
      p = scale_ * (placement.plane * p);
    }
    curve.height = scale_ * placement.height(curve.height);
    if (drawing_.curves.empty()) {
      drawing_.height = curve.height;
    } else if (std::abs(curve.height - drawing_.height) > tolerance::drawingJoint) {
      count(drawing_.useless, entity,
            fmt::format("at another z than {:.9g}, that of the first curve", drawing_.height));
      return std::nullopt;
    }
    drawing_.curves.push_back(std::move(curve));
    return std::nullopt;
  }

  [[nodiscard]] Failure tooMany(const DrawingObject& entity) const {
    return fail(diag::RegionSize, rules_.mostPoints)
        .withHelp(fmt::format("`{}` line {}; a larger CHORD makes fewer", name_, entity.line));
  }

  static constexpr int deepest = 16;  // blocks in blocks
  std::string_view name_;
  const DrawingRules& rules_;
  double scale_;
  LayerStates states_;
  DrawingBlocks blocks_;
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
  Result<LayerStates> states = layerStates(section(*groups, "TABLES"), name);
  Result<DrawingBlocks> blocks = blocksOf(section(*groups, "BLOCKS"), name);
  if (!states || !blocks) {
    return states ? blocks.takeFailure() : states.takeFailure();
  }
  return Reader(name, rules, unit > 0.0 ? unit / rules.unit : 1.0, *std::move(states),
                *std::move(blocks))
      .run(section(*groups, "ENTITIES"));
}

}  // namespace arelem::region
