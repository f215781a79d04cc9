#include "runtime/interpret/systems.h"

#include <algorithm>

#include "runtime/define/define.h"

namespace arelem::runtime::interpret {

std::string nameOf(const Entity& entity) {
  return entity.subscript == 0 ? entity.name : fmt::format("{}({})", entity.name, entity.subscript);
}

std::optional<Failure> Systems::enter(const Entity& matrix) {
  System system{};
  std::copy_n(matrix.canon.begin(), 12, system.toBase.begin());
  Result<std::vector<double>> inverse = define::inverse(system.toBase);
  if (!inverse) {
    return inverse.takeFailure();
  }
  std::copy_n(inverse->begin(), 12, system.fromBase.begin());
  current_ = nameOf(matrix);
  systems_[current_] = system;
  return std::nullopt;
}

Result<EntityPtr> Systems::seenFrom(const EntityPtr& entity, const std::string& system) const {
  if (entity->referenceSystem == system || entity->type == EntityType::matrix) {
    return entity;
  }
  EntityPtr moved = entity;
  const auto move = [&moved](const Matrix& matrix) -> std::optional<Failure> {
    Result<Entity> result = define::transformed(*moved, matrix);
    if (!result) {
      return result.takeFailure();
    }
    auto copy = std::make_shared<Entity>(*std::move(result));
    copy->name = moved->name;
    copy->subscript = moved->subscript;
    copy->definition = moved->definition;
    copy->pattern = moved->pattern;
    moved = std::move(copy);
    return std::nullopt;
  };
  if (!entity->referenceSystem.empty()) {
    if (auto failure = move(systems_.at(entity->referenceSystem).toBase)) {
      return *std::move(failure);
    }
  }
  if (!system.empty()) {
    if (auto failure = move(systems_.at(system).fromBase)) {
      return *std::move(failure);
    }
  }
  auto result = std::make_shared<Entity>(*moved);
  result->referenceSystem = system;
  return EntityPtr(std::move(result));
}

Vec3 Systems::vectorToBase(const Vec3& v) const {
  if (atBase()) {
    return v;
  }
  const Matrix& m = systems_.at(current_).toBase;
  return {m[0] * v.x() + m[1] * v.y() + m[2] * v.z(), m[4] * v.x() + m[5] * v.y() + m[6] * v.z(),
          m[8] * v.x() + m[9] * v.y() + m[10] * v.z()};
}

Vec3 Systems::pointToBase(const Vec3& p) const {
  if (atBase()) {
    return p;
  }
  const Matrix& m = systems_.at(current_).toBase;
  return vectorToBase(p) + Vec3(m[3], m[7], m[11]);
}

}  // namespace arelem::runtime::interpret
