#pragma once
#include "runtime/region/drawing.h"
#include "runtime/region/drawing_pairs.h"

namespace arelem::region {

/// Makes the curve of one entity, in units of the drawing or block. Errors: E0367.
class CurveReader {
 public:
  /// `chord` in units of the drawing. A curve of more points than `mostPoints` ends early: it is
  /// refused by its number of points.
  CurveReader(std::string_view name, double chord, std::size_t mostPoints)
      : name_(name), chord_(chord), mostPoints_(mostPoints) {}

  [[nodiscard]] static bool knows(std::string_view entity);
  /// POLYLINE takes its vertices from `vertices`. A curve that bounds nothing tells why.
  [[nodiscard]] Result<Curve> read(const DrawingObject& entity,
                                   std::span<const DrawingObject> vertices) const;

 private:
  struct Vertex {
    Vec2 place = Vec2::Zero();
    double bulge = 0.0;
  };
  [[nodiscard]] Failure wrong(const DrawingObject& entity, std::string what) const;
  [[nodiscard]] Result<double> number(const DrawingObject& entity,
                                      int code,
                                      std::optional<double> otherwise = std::nullopt) const;
  /// All values of a code, in order.
  [[nodiscard]] Result<std::vector<double>> numbers(const DrawingObject& entity, int code) const;
  /// The z of an entity; none where it is not the same all along it.
  [[nodiscard]] Result<std::optional<double>> height(const DrawingObject& entity,
                                                     std::span<const DrawingObject> vertices) const;
  [[nodiscard]] Result<Curve> line(const DrawingObject& entity) const;
  [[nodiscard]] Result<Curve> arc(const DrawingObject& entity) const;
  [[nodiscard]] Result<Curve> ellipse(const DrawingObject& entity) const;
  [[nodiscard]] Result<Curve> lightPolyline(const DrawingObject& entity) const;
  [[nodiscard]] Result<Curve> polyline(const DrawingObject& entity,
                                       std::span<const DrawingObject> vertices) const;
  [[nodiscard]] Result<Curve> spline(const DrawingObject& entity) const;
  [[nodiscard]] Curve bulged(const std::vector<Vertex>& vertices, bool closed) const;

  std::string_view name_;
  double chord_;
  std::size_t mostPoints_;
};

}  // namespace arelem::region
