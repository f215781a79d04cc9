#include "runtime/region/drawing_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "ir/diag/spray.h"
#include "ir/space/spray_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/region/drawing_chords.h"
#include "runtime/region/drawing_spline.h"

namespace arelem::region {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
constexpr double wholeTurn = 2.0 * std::numbers::pi;

constexpr std::string_view notParallel = "that is not parallel to the xy plane";
constexpr long spatial = 8;  // the flag of a POLYLINE whose vertices have their own z

Curve useless(std::string_view why) {
  Curve curve;
  curve.useless = why;
  return curve;
}
}  // namespace

bool CurveReader::knows(std::string_view entity) {
  constexpr std::array<std::string_view, 7> known = {"LINE",     "ARC",     "CIRCLE", "LWPOLYLINE",
                                                     "POLYLINE", "ELLIPSE", "SPLINE"};
  return std::find(known.begin(), known.end(), entity) != known.end();
}

Failure CurveReader::wrong(const DrawingObject& entity, std::string what) const {
  return fail(diag::DrawingSyntax, name_, entity.line,
              fmt::format("{} {}", entity.name, std::move(what)));
}

Result<double> CurveReader::number(const DrawingObject& entity,
                                   int code,
                                   std::optional<double> otherwise) const {
  for (const Group& group : entity.groups) {
    if (group.code == code) {
      return numberOf(group, name_);
    }
  }
  if (otherwise) {
    return *otherwise;
  }
  return wrong(entity, fmt::format("without group {}", code));
}

Result<std::vector<double>> CurveReader::numbers(const DrawingObject& entity, int code) const {
  std::vector<double> list;
  for (const Group& group : entity.groups) {
    if (group.code == code) {
      Result<double> value = numberOf(group, name_);
      if (!value) {
        return value.takeFailure();
      }
      list.push_back(*value);
    }
  }
  return list;
}

Result<Curve> CurveReader::read(const DrawingObject& entity,
                                std::span<const DrawingObject> vertices) const {
  const Result<double> up = number(entity, 230, 1.0);
  if (!up) {
    return up.failure();
  }
  if (std::abs(std::abs(*up) - 1.0) > tolerance::similarity) {
    return useless(notParallel);
  }
  Result<Curve> curve = entity.name == "LINE"         ? line(entity)
                        : entity.name == "ELLIPSE"    ? ellipse(entity)
                        : entity.name == "LWPOLYLINE" ? lightPolyline(entity)
                        : entity.name == "POLYLINE"   ? polyline(entity, vertices)
                        : entity.name == "SPLINE"     ? spline(entity)
                                                      : arc(entity);
  // An entity drawn on the back of the plane has its own x axis turned round; LINE, ELLIPSE and
  // SPLINE are in coordinates of the drawing always.
  const bool own = entity.name == "ARC" || entity.name == "CIRCLE" || entity.name == "LWPOLYLINE" ||
                   entity.name == "POLYLINE";
  Result<std::optional<double>> z = height(entity, vertices);
  if (!z) {
    return z.takeFailure();
  }
  if (curve && !*z) {
    return useless(notParallel);
  }
  if (curve) {
    curve->height = own ? *up * **z : **z;
  }
  if (curve && !std::all_of(curve->points.begin(), curve->points.end(),
                            [](const Vec2& p) { return p.allFinite(); })) {
    return wrong(entity, "leads farther than numbers go");
  }
  if (curve && own && *up < 0.0) {
    for (Vec2& p : curve->points) {
      p.x() = -p.x();
    }
  }
  return curve;
}

Result<std::optional<double>> CurveReader::height(const DrawingObject& entity,
                                                  std::span<const DrawingObject> vertices) const {
  std::vector<double> all;
  const auto add = [&](const DrawingObject& object, int code) -> std::optional<Failure> {
    Result<std::vector<double>> list = numbers(object, code);
    if (!list) {
      return list.takeFailure();
    }
    all.insert(all.end(), list->begin(), list->end());
    return std::nullopt;
  };
  const Result<double> flags = number(entity, 70, 0.0);
  const bool inSpace = entity.name == "POLYLINE" && flags && (wholeOf(*flags) & spatial) != 0;
  for (const DrawingObject& vertex : inSpace ? vertices : vertices.first(0)) {
    if (auto failure = add(vertex, 30)) {
      return *std::move(failure);
    }
  }
  for (const int code : {30, entity.name == "LINE" ? 31 : 30, 38}) {
    if (auto failure = inSpace ? std::nullopt : add(entity, code)) {
      return *std::move(failure);
    }
  }
  // The end of an ellipse's axis is given from its center.
  Result<double> rise = entity.name == "ELLIPSE" ? number(entity, 31, 0.0) : Result<double>(0.0);
  if (!rise) {
    return rise.takeFailure();
  }
  if (all.empty()) {
    all.push_back(0.0);
  }
  const auto [low, high] = std::minmax_element(all.begin(), all.end());
  if (std::abs(*high - *low) + std::abs(*rise) > tolerance::drawingJoint) {
    return std::optional<double>();
  }
  return std::optional(*low);
}

Result<Curve> CurveReader::line(const DrawingObject& entity) const {
  std::array<double, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) {
    constexpr std::array codes = {10, 20, 11, 21};
    Result<double> value = number(entity, codes[i]);
    if (!value) {
      return value.takeFailure();
    }
    v[i] = *value;
  }
  return Curve{{{v[0], v[1]}, {v[2], v[3]}}, false};
}

Result<Curve> CurveReader::arc(const DrawingObject& entity) const {
  const bool whole = entity.name == "CIRCLE";
  std::array<double, 5> v{};
  for (std::size_t i = 0; i < 5; ++i) {
    constexpr std::array codes = {10, 20, 40, 50, 51};
    Result<double> value =
        number(entity, codes[i], whole && i > 2 ? std::optional(0.0) : std::nullopt);
    if (!value) {
      return value.takeFailure();
    }
    v[i] = *value;
  }
  if (!(v[2] > 0.0)) {
    return useless("without a radius");
  }
  double sweep = std::fmod((v[4] - v[3]) * degree, wholeTurn);
  sweep = whole || sweep <= 0.0 ? sweep + wholeTurn : sweep;
  Curve curve{arcPoints({v[0], v[1]}, v[2], v[3] * degree, sweep, chord_, mostPoints_), whole};
  if (whole) {
    curve.points.pop_back();
  }
  return curve;
}

Result<Curve> CurveReader::ellipse(const DrawingObject& entity) const {
  std::array<double, 7> v{};
  for (std::size_t i = 0; i < 7; ++i) {
    constexpr std::array codes = {10, 20, 11, 21, 40, 41, 42};
    Result<double> value = number(entity, codes[i],
                                  i == 5   ? std::optional(0.0)
                                  : i == 6 ? std::optional(wholeTurn)
                                           : std::nullopt);
    if (!value) {
      return value.takeFailure();
    }
    v[i] = *value;
  }
  const Vec2 major(v[2], v[3]);
  if (!(major.norm() > 0.0) || !(v[4] > 0.0)) {
    return useless("with an axis of no length");
  }
  const Result<double> up = number(entity, 230, 1.0);
  const Vec2 minor = v[4] * (*up < 0.0 ? -1.0 : 1.0) * Vec2(-major.y(), major.x());
  double sweep = v[6] - v[5];
  sweep = sweep <= 0.0 ? sweep + wholeTurn : sweep;
  const bool whole = std::abs(sweep - wholeTurn) <= tolerance::similarity;
  const auto at = [&](double t) -> Vec2 {
    return Vec2(v[0], v[1]) + std::cos(t) * major + std::sin(t) * minor;
  };
  Curve curve{{at(v[5])}, whole};
  for (int i = 0; i < 8; ++i) {
    addChords(at, v[5] + sweep * i / 8.0, v[5] + sweep * (i + 1) / 8.0, chord_, mostPoints_,
              curve.points);
  }
  if (whole) {
    curve.points.pop_back();
  }
  return curve;
}

Curve CurveReader::bulged(const std::vector<Vertex>& vertices, bool closed) const {
  Curve curve;
  curve.closed = closed;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n && curve.points.size() <= mostPoints_; ++i) {
    const Vertex& from = vertices[i];
    curve.points.push_back(from.place);
    if ((i + 1 == n && !closed) || from.bulge == 0.0) {
      continue;
    }
    // The bulge is the tangent of a quarter of the arc's angle, positive counterclockwise.
    const Vec2 chord = vertices[(i + 1) % n].place - from.place;
    const double length = chord.norm();
    if (length == 0.0) {
      continue;
    }
    const double sweep = 4.0 * std::atan(from.bulge);
    const double radius = length * (1.0 + from.bulge * from.bulge) / (4.0 * std::abs(from.bulge));
    const double height = (1.0 - from.bulge * from.bulge) / (4.0 * from.bulge);
    const Vec2 center = from.place + chord / 2.0 + height * Vec2(-chord.y(), chord.x());
    const Vec2 arm = from.place - center;
    const std::vector<Vec2> arc =
        arcPoints(center, radius, std::atan2(arm.y(), arm.x()), sweep, chord_, mostPoints_);
    curve.points.insert(curve.points.end(), arc.begin() + 1, arc.end() - 1);
  }
  return curve;
}

Result<Curve> CurveReader::lightPolyline(const DrawingObject& entity) const {
  std::vector<Vertex> vertices;
  Result<double> flags = number(entity, 70, 0.0);
  Result<double> count = number(entity, 90);
  if (!flags || !count) {
    return flags ? count.takeFailure() : flags.takeFailure();
  }
  for (const Group& group : entity.groups) {
    if (group.code != 10 && group.code != 20 && group.code != 42) {
      continue;
    }
    Result<double> value = numberOf(group, name_);
    if (!value) {
      return value.takeFailure();
    }
    if (group.code == 10) {
      vertices.push_back({{*value, 0.0}, 0.0});
    } else if (vertices.empty()) {
      return wrong(entity, "has a coordinate before its first vertex");
    } else {
      (group.code == 20 ? vertices.back().place.y() : vertices.back().bulge) = *value;
    }
  }
  if (static_cast<double>(vertices.size()) != *count) {
    return wrong(entity, fmt::format("says {} vertices and has {}", *count, vertices.size()));
  }
  if (vertices.empty()) {
    return wrong(entity, "has no vertices");
  }
  return bulged(vertices, (wholeOf(*flags) & 1) != 0);
}

Result<Curve> CurveReader::polyline(const DrawingObject& entity,
                                    std::span<const DrawingObject> vertices) const {
  Result<double> flags = number(entity, 70, 0.0);
  if (!flags) {
    return flags.takeFailure();
  }
  const long bits = wholeOf(*flags);
  if ((bits & (16 | 64)) != 0) {
    return useless("that is a grid or a mesh");
  }
  std::vector<Vertex> list;
  for (const DrawingObject& vertex : vertices) {
    Result<double> x = number(vertex, 10);
    Result<double> y = number(vertex, 20);
    Result<double> bulge = number(vertex, 42, 0.0);
    if (!x || !y || !bulge) {
      return !x ? x.takeFailure() : !y ? y.takeFailure() : bulge.takeFailure();
    }
    Result<double> kind = number(vertex, 70, 0.0);
    if (!kind) {
      return kind.takeFailure();
    }
    constexpr long frame = 16;  // a control point of the curve that the other vertices stand for
    if ((wholeOf(*kind) & frame) == 0) {
      list.push_back({{*x, *y}, *bulge});
    }
  }
  if (list.empty()) {
    return wrong(entity, "has no vertices");
  }
  return bulged(list, (bits & 1) != 0);
}

Result<Curve> CurveReader::spline(const DrawingObject& entity) const {
  Result<double> degreeValue = number(entity, 71);
  Result<double> flags = number(entity, 70, 0.0);
  std::array<std::vector<double>, 4> lists;
  for (std::size_t i = 0; i < 4; ++i) {
    constexpr std::array codes = {40, 10, 20, 41};
    Result<std::vector<double>> list = numbers(entity, codes[i]);
    if (!list) {
      return list.takeFailure();
    }
    lists[i] = *std::move(list);
  }
  if (!degreeValue || !flags) {
    return degreeValue ? flags.takeFailure() : degreeValue.takeFailure();
  }
  const auto& [knots, x, y, weights] = lists;
  const int degreeNumber = static_cast<int>(wholeOf(*degreeValue));
  for (const auto& [code, found] : {std::pair{72, knots.size()}, std::pair{73, x.size()}}) {
    Result<double> said = number(entity, code, static_cast<double>(found));
    if (!said) {
      return said.takeFailure();
    }
    if (*said != static_cast<double>(found)) {
      return wrong(entity, fmt::format("says {} {} and has {}", *said,
                                       code == 72 ? "knots" : "control points", found));
    }
  }
  if (const auto fits = numbers(entity, 11); x.empty() && fits && !fits->empty()) {
    return useless("by fit points");
  }
  const bool sizes = x.size() == y.size() && (weights.empty() || weights.size() == x.size()) &&
                     degreeNumber >= 1 && degreeNumber <= 10 &&
                     x.size() > static_cast<std::size_t>(degreeNumber) &&
                     knots.size() == x.size() + static_cast<std::size_t>(degreeNumber) + 1;
  if (!sizes) {
    return wrong(entity, fmt::format("of degree {} has {} knots, {} control points, {} weights",
                                     *degreeValue, knots.size(), x.size(), weights.size()));
  }
  if (!std::is_sorted(knots.begin(), knots.end()) ||
      std::any_of(weights.begin(), weights.end(), [](double w) { return !(w > 0.0); })) {
    return wrong(entity, "has knots that fall or a weight that is not above 0");
  }
  std::vector<Eigen::Vector3d> poles;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = weights.empty() ? 1.0 : weights[i];
    poles.emplace_back(w * x[i], w * y[i], w);
  }
  const DrawingSpline curve(degreeNumber, knots, std::move(poles));
  const std::vector<double> spans = curve.spans();
  Curve result{{curve.at(spans.front())}, false};
  for (std::size_t i = 1; i < spans.size(); ++i) {
    addChords([&curve](double t) { return curve.at(t); }, spans[i - 1], spans[i], chord_,
              mostPoints_, result.points);
  }
  return result;
}

}  // namespace arelem::region
