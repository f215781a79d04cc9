#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "runtime/geometry/kinds/polyconic_sheet.h"

/// How a POLCON bends.
namespace arelem::surface {

namespace {
using geometry::Interval;
using geometry::Jet;
using Part = geometry::Polyconic::Part;
using Box = std::array<Interval, 3>;

/// A part of the sheet that is bounded reaches at most this far in s and t.
constexpr double widest = 0.45;
/// It is taken in parts that reach at most this far.
constexpr double narrow = 0.04;
/// A patch is taken in at most so many by so many.
constexpr int mostParts = 4;
/// The first form of a part of the sheet that is bounded changes by at most this share, and ways
/// along it are at most this many times as long as straight ones.
constexpr double mostChange = 0.5;
constexpr double sheetSlack = 1.5;
/// A vector product this small against its factors has no direction.
constexpr double noArea = 1e-9;

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

std::optional<Polyconic::Sheet::Range> Polyconic::Sheet::around(const Hint& middle,
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

  /// None where the sheet has no direction.
  [[nodiscard]] static std::optional<Square> of(const SheetPlace& place) {
    const double ss = place.byF.squaredNorm();
    const double st = place.byF.dot(place.byG);
    const double tt = place.byG.squaredNorm() - st * st / ss;
    if (!(ss > 0.0 && tt > noArea * noArea * ss)) {
      return std::nullopt;
    }
    return Square{std::sqrt(ss), std::sqrt(tt), st / ss};
  }
  /// Half widths of s and t over a circle of x and y.
  [[nodiscard]] double halfS(double way) const { return way / e + std::abs(k) * way / f; }
  [[nodiscard]] double halfT(double way) const { return way / f; }
};

/// What the coefficients of both fundamental forms by x and y may be: of the first, less the unit
/// matrix, and of the second times the area.
struct Forms {
  Interval exx, exy, eyy, lxx, lxy, lyy;
  Interval upright;    ///< how far normals go along the middle one, times the area
  double leans = 0.0;  ///< how far they are from it, times the area

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
    leans = std::hypot((across[0] - normal.x()).size(), (across[1] - normal.y()).size(),
                       (across[2] - normal.z()).size());
  }
  void widen(const Forms& o) {
    for (Interval Forms::*m : {&Forms::exx, &Forms::exy, &Forms::eyy, &Forms::lxx, &Forms::lxy,
                               &Forms::lyy, &Forms::upright}) {
      this->*m = geometry::hull(this->*m, o.*m);
    }
    leans = std::max(leans, o.leans);
  }
  /// The first form is nearly the unit matrix, and the eigenvalues of the second nearly the
  /// curvatures, positive where the sheet bends towards byG x byF. None where it changes too much.
  [[nodiscard]] std::optional<Bends> curvatures() const {
    const Interval change = eigenvalues(exx, exy, eyy);
    if (!(change.size() <= mostChange && upright.low > 0.0)) {
      return std::nullopt;
    }
    const Interval second = eigenvalues(lxx, lxy, lyy);
    // The area is the root of the determinant of the first form.
    const double least = 1.0 + change.low;
    const double most = 1.0 + change.high;
    const auto farthest = [&](double value, bool upwards) {
      const bool outwards = (value > 0.0) == upwards;
      return value / (outwards ? least * least : most * most);
    };
    return Bends{farthest(second.low, false), farthest(second.high, true)};
  }
};

/// Of a sheet that bends towards byG x byF: whether its normal goes there or back.
Bends seenFrom(double upwards, const Bends& bent) {
  return upwards < 0.0 ? bent : Bends{-bent.high, -bent.low};
}
}  // namespace

/// The box is taken in parts: intervals widen faster than it does.
std::optional<Bends> Polyconic::Sheet::curvatures(const Hint& middle,
                                                  double reach,
                                                  int most) const {
  const SheetPlace place = at(middle.s, middle.t);
  const auto square = Square::of(place);
  if (!square) {
    return std::nullopt;
  }
  const double way = sheetSlack * reach;
  const double halfS = square->halfS(way);
  const double halfT = square->halfT(way);
  if (!(std::max(halfS, halfT) <= widest)) {
    return std::nullopt;
  }
  const int byS = static_cast<int>(std::ceil(halfS / narrow));
  const int byT = static_cast<int>(std::ceil(halfT / narrow));
  if (byS * byT > most) {
    return std::nullopt;
  }
  const Vec3 normal = form_.rows * place.byG.cross(place.byF).normalized() * mirrored_;
  std::optional<Forms> forms;
  for (int i = 0; i < byS; ++i) {
    for (int j = 0; j < byT; ++j) {
      const Hint center{true, middle.s + halfS * ((2 * i + 1.0) / byS - 1.0),
                        middle.t + halfT * ((2 * j + 1.0) / byT - 1.0)};
      const std::optional<Range> box = around(center, halfS / byS, halfT / byT);
      if (!box) {
        return std::nullopt;
      }
      const Forms part(*box, *square, normal);
      forms ? forms->widen(part) : void(forms = part);
    }
  }
  const auto bent = forms->curvatures();
  return bent ? std::optional(seenFrom(upwards(middle.s), *bent)) : std::nullopt;
}

std::optional<Polyconic::Sheet::Turned> Polyconic::Sheet::turnedAbout(const Hint& middle,
                                                                      double halfS,
                                                                      double halfT) const {
  const SheetPlace place = at(middle.s, middle.t);
  const auto square = Square::of(place);
  const auto box = square ? around(middle, halfS, halfT) : std::nullopt;
  if (!box) {
    return std::nullopt;
  }
  const Vec3 normal = form_.rows * place.byG.cross(place.byF).normalized() * mirrored_;
  const Forms forms(*box, *square, normal);
  const auto bent = forms.curvatures();
  if (!bent || !(forms.leans <= mostChange)) {
    return std::nullopt;
  }
  // A unit vector is as far from another as twice the sine of half the angle, and `leans` at least
  // the sine of it.
  const double spread = forms.leans / std::sqrt(1.0 - 0.25 * forms.leans * forms.leans);
  return Turned{true, seenFrom(upwards(middle.s), *bent), upwards(middle.s) * normal, spread};
}

Polyconic::Sheet::Turned Polyconic::Sheet::turnedOver(const Interval& s, const Interval& t) const {
  const auto partsOf = [](const Interval& x) {
    return std::clamp(static_cast<int>(std::ceil(x.half() / narrow)), 1, mostParts);
  };
  const int byS = partsOf(s);
  const int byT = partsOf(t);
  std::vector<Turned> parts;
  for (int i = 0; i < byS; ++i) {
    for (int j = 0; j < byT; ++j) {
      const Hint center{true, s.low + s.half() * (2 * i + 1.0) / byS,
                        t.low + t.half() * (2 * j + 1.0) / byT};
      const auto part = turnedAbout(center, s.half() / byS, t.half() / byT);
      if (!part) {
        return {};
      }
      parts.push_back(*part);
    }
  }
  Turned all = parts[parts.size() / 2];
  for (const Turned& part : parts) {
    all.curvatures.low = std::min(all.curvatures.low, part.curvatures.low);
    all.curvatures.high = std::max(all.curvatures.high, part.curvatures.high);
    all.spread = std::max(all.spread, (part.normal - all.normal).norm() + part.spread);
  }
  return all;
}

}  // namespace arelem::surface
