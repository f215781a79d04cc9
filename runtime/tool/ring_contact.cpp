#include "runtime/tool/ring_contact.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "runtime/geometry/least.h"
#include "runtime/geometry/mesh_foot.h"

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

/// Rounding of distances and of how they change, as a share of the coordinates' size.
constexpr double rounding = 1e-12;

/// The triangles that are the nearest one of some place of a ball. How far each was from the place
/// where it was looked at last tells, for the next places, mostly without a look that another one
/// is nearer.
class NearBall {
 public:
  NearBall(const surface::MeshShape& shape, const Vec3& center, double radius, double distance)
      : shape_(shape),
        center_(center),
        slack_(rounding * (1.0 + center.cwiseAbs().maxCoeff() + radius + distance)),
        reach_(distance + 2.0 * radius + slack_) {
    shape.tree.search(*this);
  }

  /// False where they are too many, and where the ball is nowhere.
  [[nodiscard]] bool isComplete() const { return count_ > 0 && count_ <= most; }
  [[nodiscard]] std::size_t nearest(const Vec3& p) {
    std::size_t found = last_;
    double least = squaredTo(list_[found], p);
    double reach = std::sqrt(least) + slack_;
    for (std::size_t k = 0; k < count_; ++k) {
      const One& one = list_[k];
      const double nearer = one.away - reach;
      if (k == last_ || (nearer > 0.0 && (p - one.from).squaredNorm() < nearer * nearer)) {
        continue;
      }
      const double squared = squaredTo(list_[k], p);
      if (squared < least || (squared == least && list_[k].triangle < list_[found].triangle)) {
        least = squared;
        found = k;
        reach = std::sqrt(least) + slack_;
      }
    }
    last_ = found;
    return list_[found].triangle;
  }

  bool enters(const Vec3& center, const Vec3& half) const {
    return ((center_ - center).cwiseAbs() - half).cwiseMax(0.0).squaredNorm() <= reach_ * reach_;
  }
  void visit(std::size_t triangle) {
    if (count_ > most) {
      return;
    }
    One one{triangle, center_, 0.0};
    if (squaredTo(one, center_) <= reach_ * reach_) {
      if (count_ < most) {
        list_[count_] = one;
      }
      ++count_;
    }
  }

 private:
  static constexpr std::size_t most = 64;
  struct One {
    std::size_t triangle = 0;
    Vec3 from = Vec3::Zero();  ///< it is so far `away` from here
    double away = 0.0;
  };
  double squaredTo(One& one, const Vec3& p) const {
    const geometry::TriangleMesh& mesh = shape_.mesh;
    const Vec3 on = geometry::nearestOn(mesh.corner(one.triangle, 0), mesh.corner(one.triangle, 1),
                                        mesh.corner(one.triangle, 2), p)
                        .point;
    const double squared = (on - p).squaredNorm();
    one.from = p;
    one.away = std::sqrt(squared);
    return squared;
  }

  const surface::MeshShape& shape_;
  Vec3 center_;
  double slack_, reach_;
  std::array<One, most> list_;
  std::size_t count_ = 0, last_ = 0;
};

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
        hint_(hint),
        near_(mesh.shape(), center_, radius_, std::abs(mesh.foot(center_, hint).distance)) {}

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
    const surface::Foot foot = footOf(point);
    return {side_ * foot.distance, side_ * foot.normal, point};
  }

 private:
  [[nodiscard]] Vec3 place(double angle) const {
    return center_ + radius_ * (std::cos(angle) * first_ + std::sin(angle) * second_);
  }
  [[nodiscard]] surface::Foot footOf(const Vec3& p) {
    return near_.isComplete() ? surface::footOn(mesh_.shape(), near_.nearest(p), p, hint_)
                              : mesh_.foot(p, hint_);
  }
  Look at(double angle) {
    const Look look{angle, side_ * footOf(place(angle)).distance};
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
  /// As long as a lower place can be in what is left.
  void valley(double low, double high) {
    int left = sections;
    geometry::narrowLeast([this](double angle) { return at(angle).gap; }, low, high,
                          [&](double least, double width) {
                            return left-- > 0 && least - radius_ * width <= best_.gap;
                          });
  }

  const surface::Mesh& mesh_;
  double side_, radius_;
  Vec3 center_, first_, second_;
  surface::Mesh::Hint& hint_;
  NearBall near_;
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
