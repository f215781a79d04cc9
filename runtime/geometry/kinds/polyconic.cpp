#include "runtime/geometry/kinds/polyconic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ir/space/tolerance.h"
#include "runtime/geometry/kinds/sheet.h"
#include "runtime/geometry/polyconic.h"

namespace arelem::surface {

namespace {
using geometry::Interval;
using geometry::Jet;
using Part = geometry::Polyconic::Part;
using Box = std::array<Interval, 3>;

constexpr int newtonLimit = 60;
constexpr int halvings = 12;
/// A Newton step of s and t at most this long is the last.
constexpr double smallStep = 1e-9;
/// A Newton step is at most this share of the ranges of s and t, which are of length one.
constexpr double stride = 0.25;
/// A part of the sheet that is bounded reaches at most this far in s and t.
constexpr double widest = 0.45;
/// It is taken in parts that reach at most this far.
constexpr double narrow = 0.04;
/// Places from which a search may start, in each direction, and how many are left out where the
/// foot is known to lie on the surface.
constexpr int seeds = 33;
constexpr int coarse = 4;
/// The first form of a part of the sheet that is bounded changes by at most this share, and ways
/// along it are at most this many times as long as straight ones.
constexpr double mostChange = 0.5;
constexpr double sheetSlack = 1.5;
/// A vector product this small against its factors has no direction.
constexpr double noArea = 1e-9;
}  // namespace

class Polyconic::Sheet {
 public:
  explicit Sheet(const geometry::Polyconic& form) : form_(form) {
    for (int i = 0; i < seeds; ++i) {
      for (int k = 0; k < seeds; ++k) {
        const double s =
            form_.low() + (geometry::Polyconic::high - form_.low()) * i / (seeds - 1.0);
        const double t = k / (seeds - 1.0);
        places_.push_back({s, t, at(s, t).place});
      }
    }
  }

  [[nodiscard]] double thickness() const { return form_.thickness; }

  [[nodiscard]] SheetPlace at(double s, double t) const {
    const auto jets = form_.at<double>(s, t, form_.partOf(s), geometry::Polyconic::along(t));
    const Eigen::Matrix3d back = form_.rows.transpose();
    const auto member = [&](double Jet<double>::*m) {
      return Vec3(back * Vec3(jets[0].*m, jets[1].*m, jets[2].*m));
    };
    SheetPlace place{member(&Jet<double>::value) - back * form_.shift, member(&Jet<double>::s),
                     member(&Jet<double>::t), member(&Jet<double>::ss), member(&Jet<double>::st)};
    place.byGG = member(&Jet<double>::tt);
    return place;
  }

  /// Unit normal. On the other half of a nose t runs the other way round; at its tip all t meet.
  [[nodiscard]] Vec3 normalAt(double s, const SheetPlace& p) const {
    const double mirrored = form_.rows.determinant() < 0.0 ? -1.0 : 1.0;
    Vec3 across = p.byG.cross(p.byF);
    if (across.norm() <= noArea * p.byF.squaredNorm()) {
      across = p.byFG.cross(p.byF);
    } else if (form_.hasNose() && s < 0.0) {
      across = -across;
    }
    const double length = across.norm();
    return length > 0.0 ? Vec3(mirrored / length * across) : Vec3(p.byF.unitOrthogonal());
  }

  [[nodiscard]] Hint seed(const Vec3& p, int every) const {
    Hint best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < seeds; i += every) {
      for (int k = 0; k < seeds; k += every) {
        const Place& place = places_[static_cast<std::size_t>(i * seeds + k)];
        const double squared = (p - place.point).squaredNorm();
        if (squared < least) {
          least = squared;
          best = {true, place.s, place.t};
        }
      }
    }
    return best;
  }

  /// Goes from `at` to a place whose rest to p is square to the sheet; false if it finds none.
  bool descend(const Vec3& p, Hint& at) const {
    SheetPlace place = this->at(at.s, at.t);
    for (int i = 0; i < newtonLimit; ++i) {
      auto [step, newton] = descent(place, p - place.place);
      if (!step.allFinite()) {
        return false;
      }
      const double size = step.cwiseAbs().maxCoeff();
      step *= std::min(1.0, stride / std::max(size, stride));
      const double before = (p - place.place).squaredNorm();
      for (int k = 0;; ++k) {
        const SheetPlace next = this->at(at.s + step.x(), at.t + step.y());
        const bool last = size <= smallStep || k == halvings;
        if (last || (p - next.place).squaredNorm() <= before) {
          at = {true, at.s + step.x(), at.t + step.y()};
          place = next;
          break;
        }
        step *= 0.5;
      }
      // Newton squares the error: what it leaves after a small step is rounding.
      if (size <= 1e-15 || (newton && size <= smallStep)) {
        return true;
      }
    }
    return false;
  }

  /// Bounds of the normal curvatures, positive where the sheet bends away from its normal, within
  /// `reach` of the place at s and t. None where it is not regular or changes too much there.
  [[nodiscard]] std::optional<Bends> curvatures(const Hint& middle, double reach) const;

 private:
  struct Place {
    double s, t;
    Vec3 point;
  };
  /// Derivatives over a box of s and t, in the system of the conics.
  struct Range {
    Box s, t, ss, st, tt;
  };

  [[nodiscard]] std::optional<Range> over(const Interval& s, const Interval& t) const;
  /// The same for a box about a place, its first derivatives also by the mean value theorem.
  [[nodiscard]] std::optional<Range> about(const Hint& middle, double halfS, double halfT) const;

  geometry::Polyconic form_;
  std::vector<Place> places_;
};

Polyconic::Polyconic(const geometry::Polyconic& surface)
    : sheet_(std::make_shared<const Sheet>(surface)) {}

Foot Polyconic::foot(const Vec3& p, Hint& hint) const {
  Hint at = hint;
  if (!at.valid || !sheet_->descend(p, at)) {
    at = sheet_->seed(p, 1);
    (void)sheet_->descend(p, at);
  }
  hint = at;
  const SheetPlace place = sheet_->at(at.s, at.t);
  const Vec3 normal = sheet_->normalAt(at.s, place);
  return {(p - place.place).dot(normal) - sheet_->thickness(), normal};
}

Vec3 Polyconic::turn(const Vec3&, const Foot& foot, const Vec3& t, Hint& hint) const {
  return hint.valid ? sheetTurn(sheet_->at(hint.s, hint.t), foot.normal,
                                foot.distance + sheet_->thickness(), t)
                    : Vec3(Vec3::Zero());
}

namespace {
Box hull(const Box& a, const Box& b) {
  return {geometry::hull(a[0], b[0]), geometry::hull(a[1], b[1]), geometry::hull(a[2], b[2])};
}
Interval dot(const Box& a, const Box& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Box cross(const Box& a, const Box& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// a x + b y.
Box mixed(const Box& a, double x, const Box& b, double y) {
  Box sum;
  for (std::size_t i = 0; i < 3; ++i) {
    sum[i] = a[i] * Interval(x) + b[i] * Interval(y);
  }
  return sum;
}

/// The stretches of a range before, inside and behind its limits.
std::vector<std::pair<Interval, Part>> parts(const Interval& x, double low, double high) {
  std::vector<std::pair<Interval, Part>> result;
  if (x.low < low) {
    result.push_back({{x.low, std::min(x.high, low)}, Part::before});
  }
  if (x.high >= low && x.low <= high) {
    result.push_back({{std::max(x.low, low), std::min(x.high, high)}, Part::inside});
  }
  if (x.high > high) {
    result.push_back({{std::max(x.low, high), x.high}, Part::behind});
  }
  return result;
}

/// Bounds of the eigenvalues of all symmetric matrices (a b; b c): those of the middle one and how
/// far the others are from it, and Gershgorin's circles.
Interval eigenvalues(const Interval& a, const Interval& b, const Interval& c) {
  const double half = 0.5 * (a.middle() + c.middle());
  const double root = std::hypot(0.5 * (a.middle() - c.middle()), b.middle());
  const double off = std::max(a.half(), c.half()) + b.half();
  const double low = std::min(a.low, c.low) - b.size();
  const double high = std::max(a.high, c.high) + b.size();
  return {std::max(low, half - root - off), std::min(high, half + root + off)};
}
}  // namespace

std::optional<Polyconic::Sheet::Range> Polyconic::Sheet::over(const Interval& s,
                                                              const Interval& t) const {
  Range range;
  bool first = true;
  for (const auto& [inS, partS] : parts(s, form_.low(), geometry::Polyconic::high)) {
    if (!form_.keepsShoulder(inS, partS)) {
      return std::nullopt;
    }
    for (const auto& [inT, partT] : parts(t, 0.0, 1.0)) {
      const auto jets = form_.at<Interval>(inS, inT, partS, partT);
      const auto take = [&](Interval Jet<Interval>::*m, Box& into) {
        const Box box{jets[0].*m, jets[1].*m, jets[2].*m};
        into = first ? box : hull(into, box);
      };
      take(&Jet<Interval>::s, range.s);
      take(&Jet<Interval>::t, range.t);
      take(&Jet<Interval>::ss, range.ss);
      take(&Jet<Interval>::st, range.st);
      take(&Jet<Interval>::tt, range.tt);
      first = false;
    }
  }
  return range;
}

std::optional<Polyconic::Sheet::Range> Polyconic::Sheet::about(const Hint& middle,
                                                               double halfS,
                                                               double halfT) const {
  const Interval byS(-halfS, halfS);
  const Interval byT(-halfT, halfT);
  auto range = over(Interval(middle.s) + byS, Interval(middle.t) + byT);
  if (range) {
    const auto center = form_.at<double>(middle.s, middle.t, form_.partOf(middle.s),
                                         geometry::Polyconic::along(middle.t));
    for (std::size_t i = 0; i < 3; ++i) {
      const auto both = [](Interval& a, const Interval& b) {
        a = {std::max(a.low, b.low), std::min(a.high, b.high)};
      };
      both(range->s[i], Interval(center[i].s) + range->ss[i] * byS + range->st[i] * byT);
      both(range->t[i], Interval(center[i].t) + range->st[i] * byS + range->tt[i] * byT);
    }
  }
  return range;
}

namespace {
/// Parameters x and y whose directions on the sheet are perpendicular and of length one at a place:
/// S_x = byF / e, S_y = (byG - k byF) / f.
struct Square {
  double e, f, k;

  /// Half widths of s and t over a circle of x and y.
  [[nodiscard]] double halfS(double way) const { return way / e + std::abs(k) * way / f; }
  [[nodiscard]] double halfT(double way) const { return way / f; }
};

/// What the coefficients of both fundamental forms by x and y may be: of the first, less the unit
/// matrix, and of the second times the area.
struct Forms {
  Interval exx, exy, eyy, lxx, lxy, lyy;
  Interval upright;  ///< how far normals go along the middle one, times the area

  template <class Range>
  Forms(const Range& box, const Square& q, const Vec3& normal) {
    const Box x = mixed(box.s, 1.0 / q.e, box.s, 0.0);
    const Box y = mixed(box.t, 1.0 / q.f, box.s, -q.k / q.f);
    const Box across = cross(y, x);
    const Box xx = mixed(box.ss, 1.0 / (q.e * q.e), box.ss, 0.0);
    const Box xy = mixed(box.st, 1.0 / (q.e * q.f), box.ss, -q.k / (q.e * q.f));
    const Box yy = mixed(mixed(box.tt, 1.0 / (q.f * q.f), box.st, -2.0 * q.k / (q.f * q.f)), 1.0,
                         box.ss, q.k * q.k / (q.f * q.f));
    exx = dot(x, x) - 1.0;
    exy = dot(x, y);
    eyy = dot(y, y) - 1.0;
    lxx = dot(across, xx);
    lxy = dot(across, xy);
    lyy = dot(across, yy);
    upright = dot(across, {normal.x(), normal.y(), normal.z()});
  }
  void widen(const Forms& o) {
    for (Interval Forms::*m : {&Forms::exx, &Forms::exy, &Forms::eyy, &Forms::lxx, &Forms::lxy,
                               &Forms::lyy, &Forms::upright}) {
      this->*m = geometry::hull(this->*m, o.*m);
    }
  }
};
}  // namespace

/// The first form is nearly the unit matrix all over the box, and the eigenvalues of the second
/// nearly the curvatures. The box is taken in parts: intervals widen faster than it does.
std::optional<Bends> Polyconic::Sheet::curvatures(const Hint& middle, double reach) const {
  const SheetPlace place = at(middle.s, middle.t);
  const double ss = place.byF.squaredNorm();
  const double st = place.byF.dot(place.byG);
  const double tt = place.byG.squaredNorm() - st * st / ss;
  if (!(ss > 0.0 && tt > noArea * noArea * ss)) {
    return std::nullopt;
  }
  const Square square{std::sqrt(ss), std::sqrt(tt), st / ss};
  const double way = sheetSlack * reach;
  const double halfS = square.halfS(way);
  const double halfT = square.halfT(way);
  if (!(std::max(halfS, halfT) <= widest)) {
    return std::nullopt;
  }
  const int byS = static_cast<int>(std::ceil(halfS / narrow));
  const int byT = static_cast<int>(std::ceil(halfT / narrow));
  const Vec3 normal = form_.rows * place.byG.cross(place.byF).normalized() *
                      (form_.rows.determinant() < 0.0 ? -1.0 : 1.0);
  std::optional<Forms> forms;
  for (int i = 0; i < byS; ++i) {
    for (int j = 0; j < byT; ++j) {
      const Hint center{true, middle.s + halfS * ((2 * i + 1.0) / byS - 1.0),
                        middle.t + halfT * ((2 * j + 1.0) / byT - 1.0)};
      const std::optional<Range> box = about(center, halfS / byS, halfT / byT);
      if (!box) {
        return std::nullopt;
      }
      const Forms part(*box, square, normal);
      forms ? forms->widen(part) : void(forms = part);
    }
  }
  const Interval change = eigenvalues(forms->exx, forms->exy, forms->eyy);
  if (!(change.size() <= mostChange && forms->upright.low > 0.0)) {
    return std::nullopt;
  }
  const Interval second = eigenvalues(forms->lxx, forms->lxy, forms->lyy);
  // The area is the root of the determinant of the first form.
  const double least = 1.0 + change.low;
  const double most = 1.0 + change.high;
  const auto farthest = [&](double value, bool upwards) {
    const bool outwards = (value > 0.0) == upwards;
    return value / (outwards ? least * least : most * most);
  };
  const double low = farthest(second.low, false);
  const double high = farthest(second.high, true);
  return form_.hasNose() && middle.s < 0.0 ? Bends{low, high} : Bends{-high, -low};
}

Bends Polyconic::bends(const Vec3& p, const Foot& foot, double radius) const {
  const Vec3 on = p - (foot.distance + sheet_->thickness()) * foot.normal;
  Hint hint = sheet_->seed(on, coarse);
  (void)sheet_->descend(on, hint);
  if (!((sheet_->at(hint.s, hint.t).place - on).norm() <= tolerance::sameSide)) {
    hint = {};
    (void)this->foot(p, hint);
  }
  return bends(p, foot, radius, hint);
}

Bends Polyconic::bends(const Vec3&, const Foot& foot, double radius, const Hint& hint) const {
  const double distance = foot.distance + sheet_->thickness();
  const double away = std::abs(distance);
  const Bends any = bendsOfAnySet(distance, radius);
  // Feet of all places within the radius lie within 2 (|distance| + radius) of the foot.
  const auto range = sheet_->curvatures(hint, 2.0 * (away + radius));
  if (!range) {
    return any;
  }
  const double sharpest = std::max(std::abs(range->low), std::abs(range->high));
  return both(any,
              bendsOfCurvature(*range, distance, radius, sharpest * (away + 3.0 * radius) < 1.0));
}

}  // namespace arelem::surface
