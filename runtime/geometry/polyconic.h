#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "ir/space/vector.h"
#include "runtime/geometry/interval.h"
#include "runtime/geometry/jet.h"

namespace arelem::geometry {

/// The canonical form of a POLCON: conics in the planes x = cb + pb d of its own system. In the
/// plane of d a conic begins at (y, z) = (L, H) along (C, B), ends at (L + A + C, H + D + B) along
/// (A, D), and its tangent parallel to its chord touches it at L + A (1 - P) + C P, H + D (1 - P) +
/// B P; the seven are functions of d, 0 <= d <= 1 (APLCNA and APLCNB of the old system).
///
/// With roots of d they are functions of s, s s = d, and s < 0 is the other half of the surface.
/// Beyond its ends a conic goes on along its tangents, and so do the functions beyond theirs; P,
/// which must lie between 1/2 and 1, bends away from these.
class Polyconic {
 public:
  /// jroots, m1 to m12, t, cb, pb, 7 x 8 coefficients, 7 of the square root.
  static constexpr std::size_t canonicalCount = 79;
  enum Function : std::uint8_t { a, b, c, d, l, h, p, functions };

  /// Before, on or behind the stretch that the numbers define.
  enum class Part : std::int8_t { before = -1, inside = 0, behind = 1 };

  [[nodiscard]] static Polyconic of(std::span<const double> canon);

  [[nodiscard]] bool hasRoots() const { return low_ < 0.0; }
  /// Range of s; that of t is 0 to 1.
  [[nodiscard]] double low() const { return low_; }
  static constexpr double high = 1.0;
  [[nodiscard]] Part partOf(double s) const { return part(s, low_, high); }
  [[nodiscard]] static Part along(double t) { return part(t, 0.0, 1.0); }

  /// The place of s and t in the system of the conics; parts are those of s and t.
  template <class T>
  [[nodiscard]] std::array<Jet<T>, 3> at(const T& s, const T& t, Part ofS, Part ofT) const;

  /// True where P is proven to lie between 1/2 and 1 over a part of the range of s: at() may then
  /// be asked for intervals.
  [[nodiscard]] bool keepsShoulder(const Interval& s, Part part) const {
    const Interval top = shoulder(s, part).value;
    return top.low > 0.5 && top.high < 1.0;
  }

  /// A function at s, inside its range.
  [[nodiscard]] double value(Function which, double s) const;
  /// A B - C D at s: 0 where the conic is flat or a point.
  [[nodiscard]] double area(double s) const;
  /// Up to which s the conics beyond an end go on before they are flat or a point; behind that they
  /// are turned over. Without end where they never are.
  [[nodiscard]] double properEnd(Part beyond) const;
  /// True where the conics at d = 0 shrink to a point: the halves of the surface form a nose.
  [[nodiscard]] bool hasNose() const { return nose_; }

  /// From the part to the system of the conics.
  Eigen::Matrix3d rows = Eigen::Matrix3d::Identity();
  Vec3 shift = Vec3::Zero();
  /// What motion meets lies this far from the conics, on the side of the normal.
  double thickness = 0.0;

 private:
  static constexpr std::size_t powers = 15;
  /// A polynomial of s: coefficients by powers, and how many of them count.
  struct Coefficients {
    std::array<double, powers> of{};
    std::size_t count = 0;

    void set(std::size_t power, double value) {
      of[power] = value;
      count = value != 0.0 ? std::max(count, power + 1) : count;
    }
  };

  [[nodiscard]] static Part part(double x, double low, double high) {
    return x < low ? Part::before : x > high ? Part::behind : Part::inside;
  }
  template <class T>
  [[nodiscard]] static Jet<T> polynomial(const Coefficients& of, const T& s);
  template <class T>
  [[nodiscard]] Jet<T> function(const Coefficients& of, const T& s, Part part) const;
  template <class T>
  [[nodiscard]] Jet<T> shoulder(const T& s, Part part) const;
  /// How much the middle of a conic weighs.
  template <class T>
  [[nodiscard]] Jet<T> weight(const T& s, Part part) const;
  /// square / sum, where sum = (1 - t)(1 - t) + 2 q t (1 - t) + t t and `square` depends on t
  /// alone.
  template <class T>
  [[nodiscard]] static Jet<T> share(const T& t,
                                    const Jet<T>& q,
                                    const T& sum,
                                    const Jet<T>& square);
  /// from + a u + c w, where from, a and c depend on s alone.
  template <class T>
  [[nodiscard]] static Jet<T> conic(
      const Jet<T>& from, const Jet<T>& a, const Jet<T>& u, const Jet<T>& c, const Jet<T>& w);

  std::array<Coefficients, functions> curves_{};
  Coefficients x_{};
  double low_ = 0.0;
  bool nose_ = false;
};

template <class T>
Jet<T> Polyconic::polynomial(const Coefficients& f, const T& s) {
  constexpr double two = 2.0;
  Jet<T> sum;
  for (std::size_t i = f.count; i-- > 0;) {
    sum.ss = sum.ss * s + two * sum.s;
    sum.s = sum.s * s + sum.value;
    sum.value = sum.value * s + T(f.of[i]);
  }
  return sum;
}

template <class T>
Jet<T> Polyconic::function(const Coefficients& of, const T& s, Part part) const {
  if (part == Part::inside) {
    return polynomial(of, s);
  }
  const double end = part == Part::before ? low_ : high;
  const Jet<double> there = polynomial(of, end);
  Jet<T> f;
  f.value = T(there.value) + T(there.s) * (s - T(end));
  f.s = T(there.s);
  return f;
}

template <class T>
Jet<T> Polyconic::shoulder(const T& s, Part part) const {
  if (part == Part::inside) {
    return polynomial(curves_[p], s);
  }
  // P goes to a value within its limits as x / (1 + |x|) goes to 1.
  const double end = part == Part::before ? low_ : high;
  const Jet<double> there = polynomial(curves_[p], end);
  const double room = 0.5 * std::min(there.value - 0.5, 1.0 - there.value);
  Jet<T> step;
  step.value = T(there.s) * (s - T(end));
  step.s = T(there.s);
  const bool falls = (there.s < 0.0) == (part == Part::behind);
  const Jet<T> size = Jet<T>(T(falls ? -1.0 : 1.0)) * step;
  return Jet<T>(T(there.value)) + step / (Jet<T>(T(1.0)) + size / Jet<T>(T(room)));
}

template <class T>
Jet<T> Polyconic::weight(const T& s, Part part) const {
  // (P - 1/2) / (1 - P), by one place of P.
  const Jet<T> top = shoulder(s, part);
  constexpr double half = 0.5;
  const T inverse = T(1.0) / (T(1.0) - top.value);
  const T square = inverse * inverse;
  Jet<T> q;
  q.value = half * inverse - T(1.0);
  q.s = half * top.s * square;
  q.ss = half * top.ss * square + top.s * top.s * square * inverse;
  return q;
}

template <class T>
Jet<T> Polyconic::share(const T& t, const Jet<T>& q, const T& sum, const Jet<T>& square) {
  constexpr double two = 2.0;
  const T zero(0.0);
  constexpr double four = 4.0;
  const T rise = four * t - T(two);
  const T middle = two * t * (T(1.0) - t);
  const T byS = q.s * middle;
  const T byT = rise * (T(1.0) - q.value);
  const T inverse = T(1.0) / sum;
  Jet<T> u;
  u.value = square.value * inverse;
  u.s = (zero - u.value * byS) * inverse;
  u.t = (square.t - u.value * byT) * inverse;
  u.ss = (zero - two * u.s * byS - u.value * q.ss * middle) * inverse;
  u.st = (u.value * q.s * rise - u.s * byT - u.t * byS) * inverse;
  u.tt = (square.tt - two * u.t * byT - u.value * (four * (T(1.0) - q.value))) * inverse;
  return u;
}

template <class T>
Jet<T> Polyconic::conic(
    const Jet<T>& from, const Jet<T>& a, const Jet<T>& u, const Jet<T>& c, const Jet<T>& w) {
  constexpr double two = 2.0;
  Jet<T> y;
  y.value = from.value + a.value * u.value + c.value * w.value;
  y.s = from.s + a.s * u.value + a.value * u.s + c.s * w.value + c.value * w.s;
  y.t = a.value * u.t + c.value * w.t;
  y.ss = from.ss + a.ss * u.value + two * a.s * u.s + a.value * u.ss + c.ss * w.value +
         two * c.s * w.s + c.value * w.ss;
  y.st = a.s * u.t + a.value * u.st + c.s * w.t + c.value * w.st;
  y.tt = a.value * u.tt + c.value * w.tt;
  return y;
}

template <class T>
std::array<Jet<T>, 3> Polyconic::at(const T& s, const T& t, Part ofS, Part ofT) const {
  const T one(1.0);
  constexpr double two = 2.0;
  const Jet<T> q = weight(s, ofS);
  Jet<T> u;
  Jet<T> w;
  const auto tangent = [&](Jet<T>& f, const T& way) {
    f.value = f.value + two * q.value * way;
    f.s = two * q.s * way;
    f.t = two * q.value;
    f.ss = two * q.ss * way;
    f.st = two * q.s;
  };
  if (ofT == Part::before) {
    tangent(w, t);
  } else if (ofT == Part::behind) {
    u.value = w.value = one;
    tangent(u, t - one);
  } else {
    // u = t t / sum, and w, which begins as u ends, 1 - (1 - t)(1 - t) / sum.
    const T left = one - t;
    const T sum = left * left + two * q.value * t * left + t * t;
    Jet<T> square;
    square.value = t * t;
    square.t = two * t;
    square.tt = two;
    u = share(t, q, sum, square);
    square.value = left * left;
    square.t = T(0.0) - two * left;
    const Jet<T> v = share(t, q, sum, square);
    w.value = one - v.value;
    const T zero(0.0);
    for (T Jet<T>::*m : {&Jet<T>::s, &Jet<T>::t, &Jet<T>::ss, &Jet<T>::st, &Jet<T>::tt}) {
      w.*m = zero - v.*m;
    }
  }
  return {function(x_, s, ofS),
          conic(function(curves_[l], s, ofS), function(curves_[a], s, ofS), u,
                function(curves_[c], s, ofS), w),
          conic(function(curves_[h], s, ofS), function(curves_[d], s, ofS), u,
                function(curves_[b], s, ofS), w)};
}

/// Where the functions of a POLCON do not make a surface.
struct PolyconicFault {
  double d = 0.0;        ///< at this fraction of pb
  bool shoulder = true;  ///< P is not between 1/2 and 1; else A B - C D is 0 or changes its sign
  double value = 0.0;    ///< of P or of A B - C D there
};
/// The first fault at one of many places.
[[nodiscard]] std::optional<PolyconicFault> faultOf(const Polyconic& surface);

}  // namespace arelem::geometry
