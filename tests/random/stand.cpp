#include "tests/random/stand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "runtime/motion/field.h"

namespace arelem::scenes {

namespace {
using motion::Field;

/// Places between both stops where gaps are measured.
constexpr int places = 16;
/// Fewer surfaces than this leave the tool a way.
constexpr std::size_t guiding = 3;
/// A gap beyond the band by this share of it is of another surface than those that the tool keeps.
constexpr double beyond = 0.01;

/// One of the gaps that a tool has to a surface: of the cutter, on either side, or of its end.
struct Touch {
  std::unique_ptr<Field> field;
  double gap = 0.0;  ///< at the stop
};

/// That of the gaps to a surface which is nearest to none: the one that the motion keeps.
std::optional<Touch> touchAt(const Scene& scene,
                             const Work& work,
                             std::string_view name,
                             double thick,
                             const std::vector<const tool::Profile*>& cutters,
                             const Stand& stop) {
  const EntityPtr entity = work.entity(name);
  if (!entity) {
    return std::nullopt;
  }
  const auto found = surface::surfaceOf(*entity);
  if (!found) {
    return std::nullopt;
  }
  std::optional<Touch> nearest;
  for (const tool::Profile* cutter : cutters) {
    for (const double side : {1.0, -1.0}) {
      Touch touch{
          motion::makeField(*found, side, motion::Tool{cutter, cutter != nullptr ? thick : 0.0})};
      touch.gap = touch.field->at(stop.place, stop.axis).gap;
      if (!nearest || std::abs(touch.gap) < std::abs(nearest->gap)) {
        nearest = std::move(touch);
      }
    }
  }
  return nearest && std::abs(nearest->gap) <= (1.0 + beyond) * scene.band() ? std::move(nearest)
                                                                            : std::nullopt;
}
}  // namespace

bool isOneStop(const Scene& scene,
               const Work& work,
               std::string_view check,
               double share,
               const Stand& stop,
               const Stand& other) {
  const auto cutter = tool::makeProfile(scene.cutter);
  if (!cutter) {
    return false;
  }
  const std::vector<const tool::Profile*> cutters{nullptr, &*cutter};
  std::size_t touched = 0;
  constexpr std::array<std::string_view, 4> names{"PS1", "DS1", "CS1", "CS2"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double thick = scene.thick[std::min<std::size_t>(i, 2)];
    auto touch = touchAt(scene, work, names[i], thick, cutters, stop);
    if (!touch) {
      continue;
    }
    ++touched;
    const double most = (names[i].starts_with(check) ? share : 1.0) * scene.band();
    for (int k = 1; k <= places; ++k) {
      const double s = static_cast<double>(k) / places;
      const Vec3 place = stop.place + s * (other.place - stop.place);
      const Vec3 axis = (stop.axis + s * (other.axis - stop.axis)).normalized();
      if (std::abs(touch->field->at(place, axis).gap - touch->gap) > most) {
        return false;
      }
    }
  }
  return touched >= guiding;
}

}  // namespace arelem::scenes
