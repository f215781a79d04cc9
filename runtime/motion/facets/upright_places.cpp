#include "runtime/motion/facets/upright_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arelem::motion {

namespace {
/// Normals within this of those of the cutter's side may touch it there.
constexpr double aboveSide = 1e-6;
/// Rectangles are larger than computed by this share of the cutter's radius and the mesh's size.
constexpr double slack = 1e-9;
/// The highest level has no more boxes.
constexpr std::size_t fewest = 8;

bool areSame(const tool::UprightProfile& a, const tool::UprightProfile& b) {
  return a.e == b.e && a.f == b.f && a.r == b.r && a.sinBeta == b.sinBeta &&
         a.cosBeta == b.cosBeta && a.highest == b.highest;
}

float below(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float above(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}
}  // namespace

void UprightPlaces::Rectangle::cover(const Rectangle& other) {
  low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
  high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
}

UprightPlaces::Box UprightPlaces::outside(const Rectangle& r) {
  return {{below(r.low.x), below(r.low.y)}, {above(r.high.x), above(r.high.y)}};
}

std::shared_ptr<const UprightPlaces> UprightPlaces::of(const surface::MeshShape& mesh,
                                                       const tool::UprightProfile& cutter,
                                                       double radius,
                                                       const Vec3& up) {
  const auto kept = mesh.kept(
      [&](const surface::KeptWithMesh& one) {
        const auto* places = dynamic_cast<const UprightPlaces*>(&one);
        return places != nullptr && places->up_ == up && places->radius_ == radius &&
               areSame(places->cutter_, cutter);
      },
      [&] {
        return std::shared_ptr<const surface::KeptWithMesh>(
            new UprightPlaces(mesh, cutter, radius, up));
      });
  return std::static_pointer_cast<const UprightPlaces>(kept);
}

/// The hull of what may be touched at the corners of a triangle has what may be touched of its
/// edges and its face: their normals are among those of each corner.
UprightPlaces::UprightPlaces(const surface::MeshShape& mesh,
                             const tool::UprightProfile& cutter,
                             double radius,
                             const Vec3& up)
    : cutter_(cutter),
      radius_(radius),
      up_(up),
      right_(up == Vec3::UnitZ() ? Vec3::UnitX() : up.unitOrthogonal()),
      ahead_(up.cross(right_)),
      center_(mesh.mesh.corner(0, 0)),
      order_(mesh.tree.order()) {
  double size = radius;
  for (const Vec3& v : mesh.mesh.vertices) {
    size = std::max(size, (v - center_).cwiseAbs().maxCoeff());
  }
  const double more = slack * size;
  const std::vector<geometry::NormalCone> cones =
      geometry::normalCones(mesh.mesh, mesh.normals, mesh.atBorder);
  std::vector<Rectangle> places;
  places.reserve(cones.size());
  for (std::size_t v = 0; v < cones.size(); ++v) {
    const Place p = placeOf(mesh.mesh.vertices[v] - center_);
    const Rectangle foot = footOf(cones[v]);
    places.push_back({{p.x + foot.low.x - more, p.y + foot.low.y - more},
                      {p.x + foot.high.x + more, p.y + foot.high.y + more}});
  }
  std::vector<Box>& boxes = levels_.emplace_back();
  boxes.reserve(order_.size());
  for (const std::uint32_t i : order_) {
    const auto& t = mesh.mesh.triangles[i];
    Rectangle all = places[t[0]];
    all.cover(places[t[1]]);
    all.cover(places[t[2]]);
    boxes.push_back(outside(all));
  }
  while (levels_.back().size() > fewest) {
    addLevel();
  }
}

void UprightPlaces::addLevel() {
  const std::vector<Box>& last = levels_.back();
  std::vector<Box> boxes;
  boxes.reserve(last.size() / parts + 1);
  for (std::size_t begin = 0; begin < last.size(); begin += parts) {
    Box box = last[begin];
    for (std::size_t i = begin + 1; i < std::min(begin + parts, last.size()); ++i) {
      for (std::size_t k = 0; k < 2; ++k) {
        box.low[k] = std::min(box.low[k], last[i].low[k]);
        box.high[k] = std::max(box.high[k], last[i].high[k]);
      }
    }
    boxes.push_back(box);
  }
  levels_.push_back(std::move(boxes));
}

/// Where the axis is, seen from what is touched with normals in a cone.
UprightPlaces::Rectangle UprightPlaces::footOf(const geometry::NormalCone& cone) const {
  const auto around = [](double x, double y, double halfX, double halfY) {
    return Rectangle{{x - halfX, y - halfY}, {x + halfX, y + halfY}};
  };
  const double upwards = std::abs(up_.dot(cone.axis));
  const Vec3 n = up_.dot(cone.axis) < 0.0 ? Vec3(-cone.axis) : cone.axis;
  if (cone.isAny() || upwards - cone.radius <= cutter_.sinBeta + aboveSide) {
    return around(0.0, 0.0, radius_, radius_);
  }
  const Place lean = placeOf(n);
  const double length = std::sqrt(lean.x * lean.x + lean.y * lean.y);
  const double arc = cutter_.r * cone.radius;
  if (length <= cone.radius) {
    // With the level bottom too.
    return around(cutter_.r * lean.x, cutter_.r * lean.y, arc + cutter_.e, arc + cutter_.e);
  }
  // Directions seen from above are within an angle of this sine.
  const double sine = cone.radius / length;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const double x = lean.x / length;
  const double y = lean.y / length;
  const double ring = 0.5 * cutter_.e * (1.0 + cosine);
  const double thick = 0.5 * cutter_.e * (1.0 - cosine);
  const double wide = cutter_.e * sine;
  return around(cutter_.r * lean.x + ring * x, cutter_.r * lean.y + ring * y,
                arc + thick * std::abs(x) + wide * std::abs(y),
                arc + thick * std::abs(y) + wide * std::abs(x));
}

/// Goes down the boxes that a line meets.
class UprightPlaces::Search {
 public:
  using Range = UprightBounds::Range;

  Search(const UprightPlaces& places,
         const Section& section,
         std::size_t limit,
         std::vector<Found>& found)
      : places_(places), limit_(limit), found_(found) {
    const Place from = places.placeOf(section.origin - places.center_);
    const Place along = places.placeOf(section.along);
    from_ = {from.x, from.y};
    for (const std::size_t k : {0U, 1U}) {
      const double by = k == 0 ? along.x : along.y;
      isAcross_[k] = std::abs(by) < alongAxis;
      perLength_[k] = isAcross_[k] ? 0.0 : 1.0 / by;
    }
  }

  void look(std::size_t level, std::size_t place, Range way) {
    if (full || !meets(places_.levels_[level][place], way)) {
      return;
    }
    if (level == 0) {
      found_.push_back({places_.order_[place], way});
      full = found_.size() > limit_;
      return;
    }
    const std::size_t end = std::min((place + 1) * parts, places_.levels_[level - 1].size());
    for (std::size_t i = place * parts; i < end; ++i) {
      look(level - 1, i, way);
    }
  }

 private:
  /// Ways that go less across the other axis than this stay where they are for it, within what
  /// rectangles are larger than they must be.
  static constexpr double alongAxis = 1e-12;

  [[nodiscard]] bool meets(const Box& box, Range& way) const {
    for (const std::size_t k : {0U, 1U}) {
      const double low = box.low[k] - from_[k];
      const double high = box.high[k] - from_[k];
      if (isAcross_[k]) {
        if (low > 0.0 || high < 0.0) {
          return false;
        }
        continue;
      }
      const double a = low * perLength_[k];
      const double b = high * perLength_[k];
      way.first = std::max(way.first, std::min(a, b));
      way.last = std::min(way.last, std::max(a, b));
    }
    return way.first <= way.last;
  }

  const UprightPlaces& places_;
  std::size_t limit_;
  std::vector<Found>& found_;
  std::array<double, 2> from_{}, perLength_{};
  std::array<bool, 2> isAcross_{};

 public:
  bool full = false;
};

bool UprightPlaces::find(const Section& section,
                         const UprightBounds::Range& way,
                         std::size_t limit,
                         std::vector<Found>& found) const {
  found.clear();
  Search search(*this, section, limit, found);
  const std::size_t top = levels_.size() - 1;
  for (std::size_t i = 0; i < levels_[top].size(); ++i) {
    search.look(top, i, way);
  }
  return !search.full;
}

}  // namespace arelem::motion
