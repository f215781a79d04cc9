#pragma once
#include <span>

#include "runtime/define/define.h"
#include "runtime/geometry/shapes.h"

namespace arelem::define {

/// The parameters of a definition whose form is known: a resolve function asks for parameter `i`
/// (0 based) with the type that its pattern promises.
class Arguments {
 public:
  Arguments(EntityType type, std::span<const Parameter> parameters, const Context& context)
      : type_(type), parameters_(parameters), context_(context) {}

  [[nodiscard]] EntityType type() const { return type_; }  ///< what is being defined
  [[nodiscard]] std::size_t count() const { return parameters_.size(); }

  [[nodiscard]] bool isOmitted(std::size_t i) const;
  [[nodiscard]] bool isScalar(std::size_t i) const;
  [[nodiscard]] bool isEntity(std::size_t i) const;
  [[nodiscard]] bool isText(std::size_t i) const;
  [[nodiscard]] bool is(std::size_t i, EntityType type) const;
  /// Also false beyond the last parameter.
  [[nodiscard]] bool is(std::size_t i, Word word) const;

  [[nodiscard]] double scalar(std::size_t i) const { return std::get<double>(parameters_[i]); }
  [[nodiscard]] Word word(std::size_t i) const { return std::get<Word>(parameters_[i]); }
  [[nodiscard]] const std::string& text(std::size_t i) const {
    return std::get<std::string>(parameters_[i]);
  }
  [[nodiscard]] const Entity& entity(std::size_t i) const {
    return *std::get<EntityPtr>(parameters_[i]);
  }

  /// Three (two) successive scalars.
  [[nodiscard]] Vec3 triple(std::size_t i) const {
    return {scalar(i), scalar(i + 1), scalar(i + 2)};
  }
  [[nodiscard]] geometry::Vec2 pair(std::size_t i) const { return {scalar(i), scalar(i + 1)}; }

  /// A POINT or VECTOR.
  [[nodiscard]] Vec3 arrow(std::size_t i) const { return as<geometry::Point>(i).at; }
  [[nodiscard]] Vec3 point(std::size_t i) const { return as<geometry::Point>(i).at; }
  [[nodiscard]] geometry::Vec2 pointInXy(std::size_t i) const { return point(i).head<2>(); }
  [[nodiscard]] geometry::Line line(std::size_t i) const { return as<geometry::Line>(i); }
  /// A PLANE, or a LINE as the vertical plane that it is.
  [[nodiscard]] geometry::Plane plane(std::size_t i) const { return as<geometry::Plane>(i); }
  [[nodiscard]] geometry::Circle circle(std::size_t i) const { return as<geometry::Circle>(i); }
  [[nodiscard]] geometry::Matrix matrix(std::size_t i) const { return as<geometry::Matrix>(i); }
  [[nodiscard]] geometry::Quadric quadric(std::size_t i) const { return as<geometry::Quadric>(i); }

  /// The bytes of a data file that the program names.
  [[nodiscard]] Result<std::string> fileText(std::string_view name) const;
  [[nodiscard]] double millimeters() const { return context_.millimeters; }
  [[nodiscard]] std::uint64_t mostCorners() const { return context_.mostCorners; }

  /// The point above (x, y) on the ZSURF plane.
  [[nodiscard]] Vec3 onZsurf(const geometry::Vec2& place) const {
    return {place.x(), place.y(), context_.z(place.x(), place.y())};
  }

  /// Something to be told though the definition succeeds.
  void remark(Failure remark) const {
    if (context_.remarks != nullptr) {
      context_.remarks->push_back(std::move(remark));
    }
  }

 private:
  template <class Shape>
  [[nodiscard]] Shape as(std::size_t i) const {
    return Shape::of(entity(i).canon);
  }

  EntityType type_;
  std::span<const Parameter> parameters_;
  const Context& context_;
};

}  // namespace arelem::define
