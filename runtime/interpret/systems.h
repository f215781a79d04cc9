#pragma once
#include <array>
#include <map>
#include <string>

#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "ir/space/vector.h"

namespace arelem::runtime::interpret {

/// Local reference systems (REFSYS). A system is the name of its matrix; the base system is "".
/// An entity keeps the coordinates of the system it was defined in and is moved when it is used in
/// another: local to base by the system's matrix, base to local by the inverse.
class Systems {
 public:
  [[nodiscard]] const std::string& current() const { return current_; }
  [[nodiscard]] bool atBase() const { return current_.empty(); }
  /// Enters the system of a matrix. Fails when the matrix has no inverse.
  [[nodiscard]] std::optional<Failure> enter(const Entity& matrix);
  void leave() { current_.clear(); }

  /// The entity as the named system sees it; the same pointer when nothing changes.
  [[nodiscard]] Result<EntityPtr> seenFrom(const EntityPtr& entity,
                                           const std::string& system) const;
  /// Coordinates and components written as numbers in the current system, in the base system.
  [[nodiscard]] Vec3 pointToBase(const Vec3& point) const;
  [[nodiscard]] Vec3 vectorToBase(const Vec3& vector) const;

 private:
  using Matrix = std::array<double, 12>;
  struct System {
    Matrix toBase;
    Matrix fromBase;
  };
  std::map<std::string, System> systems_;
  std::string current_;
};

/// "P1", "P(3)" or "" for an unnamed entity.
[[nodiscard]] std::string nameOf(const Entity& entity);

}  // namespace arelem::runtime::interpret
