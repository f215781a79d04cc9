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
/// The way between stops has more of them in the middle where it bows: fewer than three surfaces
/// leave a way.
constexpr std::size_t guiding = 3;

/// One of the gaps that a tool has to a surface: of the cutter or the ring on it, on either side,
/// or of the tool end.
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
      Touch touch{motion::makeField(*found, side, motion::Tool{cutter, cutter != nullptr ? thick : 0.0})};
      touch.gap = touch.field->at(stop.place, stop.axis).gap;
      if (!nearest || std::abs(touch.gap) < std::abs(nearest->gap)) {
        nearest = std::move(touch);
      }
    }
  }
  return nearest && std::abs(nearest->gap) <= 1.01 * scene.band() ? std::move(nearest)
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
    const double most = (names[i] == check ? share : 1.0) * scene.band();
    if (getenv("DBG")) fprintf(stderr, "%s gap %.5g at other %.5g band %g:", std::string(names[i]).c_str(), touch->gap, touch->field->at(other.place, other.axis).gap, scene.band());
    bool ok = true;
    for (int k = 1; k <= places; ++k) {
      const double s = static_cast<double>(k) / places;
      const Vec3 place = stop.place + s * (other.place - stop.place);
      const Vec3 axis = (stop.axis + s * (other.axis - stop.axis)).normalized();
      const double gap = touch->field->at(place, axis).gap;
      if (getenv("DBG")) fprintf(stderr, " %.4g", gap);
      ok = ok && std::abs(gap - touch->gap) <= most;
    }
    if (getenv("DBG")) fprintf(stderr, " ok %d\n", ok);
    if (!ok && !getenv("DBG")) {
      return false;
    }
  }
  return touched >= guiding;
}

}  // namespace arelem::scenes
