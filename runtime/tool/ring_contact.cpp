#include "runtime/tool/ring_contact.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "runtime/geometry/least.h"

namespace arelem::tool {

namespace {
/// The ring is looked at in so many places, and between them, where that tells nothing, so many
/// times more closely, by halves.
constexpr int parts = 32;
constexpr int halvings = 5;
constexpr int sections = 48;
/// A gap that changes by no more from place to place is level: a ring that lies on a facet has a
/// valley nowhere. Part unit.
constexpr double levelGap = 1e-12;

struct Look {
  double angle = 0.0, gap = 0.0;
};

class RingSearch {
 public:
  RingSearch(const surface::Mesh& mesh,
             double side,
             const Profile& ring,
             const Vec3& te,
             const Vec3& axis,
             surface::Mesh::Hint& hint)
      : mesh_(mesh),
        side_(side),
        radius_(ring.e),
        center_(te + ring.f * axis),
        first_(axis.unitOrthogonal()),
        second_(axis.cross(first_)),
        hint_(hint) {}

  Contact run() {
    constexpr double turn = 2.0 * std::numbers::pi;
    std::array<Look, parts + 1> around;
    for (int i = 0; i < parts; ++i) {
      around[static_cast<std::size_t>(i)] = at(turn * i / parts);
    }
    around[parts] = {turn, around[0].gap};
    for (std::size_t i = 0; i < parts; ++i) {
      looks_.push_back(around[i]);
      divide(around[i], around[i + 1], halvings);
    }
    const std::vector<Look> looks = std::move(looks_);
    const double width = turn / (parts << halvings);
    for (std::size_t i = 0; i < looks.size(); ++i) {
      const Look& before = looks[(i + looks.size() - 1) % looks.size()];
      const Look& behind = looks[(i + 1) % looks.size()];
      const double rim = std::max(before.gap, behind.gap);
      if (looks[i].gap <= before.gap && looks[i].gap <= behind.gap &&
          rim - looks[i].gap > levelGap && looks[i].gap - radius_ * width < best_.gap) {
        valley(looks[i].angle - width, looks[i].angle + width);
      }
    }
    const Vec3 point = place(best_.angle);
    const surface::Foot foot = mesh_.foot(point, hint_);
    return {side_ * foot.distance, side_ * foot.normal, point};
  }

 private:
  [[nodiscard]] Vec3 place(double angle) const {
    return center_ + radius_ * (std::cos(angle) * first_ + std::sin(angle) * second_);
  }
  Look at(double angle) {
    const Look look{angle, side_ * mesh_.foot(place(angle), hint_).distance};
    best_ = look.gap < best_.gap ? look : best_;
    return look;
  }
  /// Looks between two places where one between may be the lowest.
  void divide(const Look& a, const Look& b, int depth) {
    if (depth == 0 || 0.5 * (a.gap + b.gap - radius_ * (b.angle - a.angle)) >= best_.gap) {
      return;
    }
    const Look middle = at(0.5 * (a.angle + b.angle));
    divide(a, middle, depth - 1);
    looks_.push_back(middle);
    divide(middle, b, depth - 1);
  }
  void valley(double low, double high) {
    int left = sections;
    geometry::narrowLeast([this](double angle) { return at(angle).gap; }, low, high,
                          [&left](double, double) { return left-- > 0; });
  }

  const surface::Mesh& mesh_;
  double side_, radius_;
  Vec3 center_, first_, second_;
  surface::Mesh::Hint& hint_;
  std::vector<Look> looks_;
  Look best_{0.0, std::numeric_limits<double>::infinity()};
};
}  // namespace

Contact ringContact(const surface::Mesh& mesh,
                    double side,
                    const Profile& ring,
                    const Vec3& te,
                    const Vec3& axis,
                    surface::Mesh::Hint& hint) {
  return RingSearch(mesh, side, ring, te, axis, hint).run();
}

}  // namespace arelem::tool
