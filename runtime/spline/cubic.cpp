#include "runtime/spline/cubic.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/spline.h"

namespace arelem::spline {

namespace {

/// Distinct knots with three more on each side: repeated for Bezier ends, going round when closed.
std::vector<double> extended(const std::vector<double>& knots, bool closed) {
  std::vector<double> full(3, knots.front());
  full.insert(full.end(), knots.begin(), knots.end());
  full.insert(full.end(), 3, knots.back());
  if (closed) {
    const double period = knots.back() - knots.front();
    const std::size_t n = knots.size();
    for (std::size_t i = 0; i < 3; ++i) {
      full[2 - i] = knots[n - 2 - i] - period;
      full[n + 3 + i] = knots[1 + i] + period;
    }
  }
  return full;
}

std::optional<Failure> objection(const std::vector<Vec3>& control,
                                 const std::vector<double>& knots,
                                 bool closed) {
  if (control.size() < 4) {
    return fail(diag::SplineTooShort, control.size(),
                closed ? "a closed path spline" : "a path spline", 4);
  }
  const std::size_t needed = closed ? control.size() + 1 : control.size() - 2;
  if (knots.size() != needed) {
    return fail(diag::SplineKnotCount, knots.size(), control.size(), needed);
  }
  for (std::size_t i = 0; i < control.size(); ++i) {
    if (!control[i].allFinite()) {
      return fail(diag::SplineNotFinite, i + 1);
    }
  }
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (!(knots[i] > knots[i - 1]) || !std::isfinite(knots[i])) {
      return fail(diag::SplineKnotOrder, i + 1, knots[i], knots[i - 1]);
    }
  }
  return std::nullopt;
}

}  // namespace

Result<CubicSpline> CubicSpline::make(std::vector<Vec3> control,
                                      std::vector<double> knots,
                                      bool closed) {
  if (auto failure = objection(control, knots, closed)) {
    return *std::move(failure);
  }
  CubicSpline curve;
  curve.closed_ = closed;
  curve.control_ = std::move(control);
  curve.full_ = extended(knots, closed);
  return curve;
}

Result<CubicSpline> CubicSpline::uniform(std::vector<Vec3> control, bool closed) {
  const std::size_t m = control.size();
  std::vector<double> knots(closed ? m + 1 : std::max<std::size_t>(m, 2) - 2);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots[i] = static_cast<double>(i);
  }
  return make(std::move(control), std::move(knots), closed);
}

CubicSpline CubicSpline::withControl(std::vector<Vec3> control) const {
  CubicSpline other = *this;
  other.control_ = std::move(control);
  return other;
}

double CubicSpline::inside(double t) const {
  if (!closed_) {
    return std::clamp(t, begin(), end());
  }
  const double period = end() - begin();
  const double turns = std::floor((t - begin()) / period);
  return std::clamp(t - turns * period, begin(), end());
}

std::size_t CubicSpline::spanOf(double t) const {
  const auto distinct = knots();
  const auto after = std::upper_bound(distinct.begin(), distinct.end(), t);
  const auto n = static_cast<std::size_t>(after - distinct.begin());
  return std::clamp<std::size_t>(n, 1, spans()) - 1;
}

/// Bezier points of a span by inserting its two knots until each counts three times; blossoms
/// of the cubic: with u, v the span, b0 = f(u,u,u), b1 = f(u,u,v), b2 = f(u,v,v), b3 = f(v,v,v).
CubicSpline::Weights CubicSpline::pieceWeights(std::size_t span) const {
  const double* k = &full_[span + 1];  // k[2], k[3] are the ends of the span
  const double u = k[2];
  const double v = k[3];
  using Row = std::array<double, 4>;
  const auto mix = [](const Row& a, const Row& b, double from, double to, double at) {
    const double w = (at - from) / (to - from);
    Row row{};
    for (std::size_t i = 0; i < 4; ++i) {
      row[i] = (1.0 - w) * a[i] + w * b[i];
    }
    return row;
  };
  const auto blossom = [&](double r, double s, double t) {
    const Row p0{1, 0, 0, 0};
    const Row p1{0, 1, 0, 0};
    const Row p2{0, 0, 1, 0};
    const Row p3{0, 0, 0, 1};
    const Row a = mix(p0, p1, k[0], k[3], r);
    const Row b = mix(p1, p2, k[1], k[4], r);
    const Row c = mix(p2, p3, k[2], k[5], r);
    const Row d = mix(a, b, k[1], k[3], s);
    const Row e = mix(b, c, k[2], k[4], s);
    return mix(d, e, k[2], k[3], t);
  };
  return {blossom(u, u, u), blossom(u, u, v), blossom(u, v, v), blossom(v, v, v)};
}

Bezier CubicSpline::piece(std::size_t span) const {
  const Weights w = pieceWeights(span);
  Bezier piece;
  for (std::size_t r = 0; r < 4; ++r) {
    piece.control[r] = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      piece.control[r] += w[r][i] * control_[index(span, i)];
    }
  }
  piece.begin = full_[span + 3];
  piece.end = full_[span + 4];
  return piece;
}

std::vector<Bezier> CubicSpline::pieces() const {
  std::vector<Bezier> all;
  all.reserve(spans());
  for (std::size_t span = 0; span < spans(); ++span) {
    all.push_back(piece(span));
  }
  return all;
}

Vec3 CubicSpline::at(double t) const {
  const double s = inside(t);
  return piece(spanOf(s)).at(s);
}

CubicSpline::Derivatives CubicSpline::derivatives(double t) const {
  const double place = inside(t);
  const Bezier p = piece(spanOf(place));
  const double h = p.end - p.begin;
  const double s = (place - p.begin) / h;
  const double r = 1.0 - s;
  const Vec3 a = p.control[1] - p.control[0];
  const Vec3 b = p.control[2] - p.control[1];
  const Vec3 c = p.control[3] - p.control[2];
  return {p.at(place), 3.0 / h * (r * r * a + 2.0 * r * s * b + s * s * c),
          6.0 / (h * h) * (r * (b - a) + s * (c - b)), 6.0 / (h * h * h) * (c - 2.0 * b + a)};
}

double CubicSpline::curvature(double t) const {
  const Derivatives d = derivatives(t);
  const double speed = d.first.norm();
  return speed > 0.0 ? d.first.cross(d.second).norm() / (speed * speed * speed) : 0.0;
}

double CubicSpline::length() const {
  double sum = 0.0;
  for (std::size_t span = 0; span < spans(); ++span) {
    const auto [left, right] = piece(span).halves();
    const auto [a, b] = left.halves();
    const auto [c, d] = right.halves();
    sum += a.length() + b.length() + c.length() + d.length();
  }
  return sum;
}

double CubicSpline::place(std::size_t i) const {
  return (full_[i + 1] + full_[i + 2] + full_[i + 3]) / 3.0;
}

std::vector<double> CubicSpline::canon() const {
  std::vector<double> values{closed_ ? 1.0 : 0.0, static_cast<double>(control_.size())};
  const auto distinct = knots();
  values.insert(values.end(), distinct.begin(), distinct.end());
  for (const Vec3& p : control_) {
    values.insert(values.end(), {p.x(), p.y(), p.z()});
  }
  return values;
}

Result<CubicSpline> CubicSpline::of(std::span<const double> canon) {
  const double m = canon.size() < 2 ? 0.0 : canon[1];
  if (m < 4.0 || m > static_cast<double>(canon.size()) || m != std::floor(m)) {
    return fail(diag::SplineTooShort, canon.size(), "the canonical form of BSPLIN", 4);
  }
  const auto count = static_cast<std::size_t>(m);
  const bool closed = canon[0] != 0.0;
  const std::size_t knotCount = closed ? count + 1 : count - 2;
  const std::size_t needed = 2 + knotCount + 3 * count;
  if (canon.size() != needed) {
    return fail(diag::SplineSize, canon.size(), count, needed);
  }
  const auto first = canon.begin() + 2;
  std::vector<double> knots(first, first + static_cast<std::ptrdiff_t>(knotCount));
  std::vector<Vec3> control;
  control.reserve(count);
  for (std::size_t i = 2 + knotCount; i < needed; i += 3) {
    control.emplace_back(canon[i], canon[i + 1], canon[i + 2]);
  }
  return make(std::move(control), std::move(knots), closed);
}

}  // namespace arelem::spline
