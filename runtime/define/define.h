#pragma once
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "ir/diag/result.h"
#include "ir/geometry/entity.h"
#include "ir/limits.h"
#include "ir/words/words.h"
#include "runtime/files/files.h"

/// From the parameters of a definition to its canonical form: `name = TYPE/ parameters`.
namespace arelem::define {

struct Omitted {};
/// One evaluated parameter. Entities are already in the current reference system;
/// inclusive subscripts are already expanded. A string is a text that stood in quotes.
using Parameter = std::variant<Omitted, double, Word, EntityPtr, std::string>;

/// What a definition depends on beside its parameters.
struct Context {
  /// ZSURF plane a x + b y + c z = d that supplies an implicit z; c is not 0.
  double zsurfA = 0.0, zsurfB = 0.0, zsurfC = 1.0, zsurfD = 0.0;
  const files::Files* files = nullptr;  ///< data files of the program; null: there are none
  double millimeters = 1.0;             ///< length of the part program's unit, mm
  std::uint64_t mostCorners = Limits{}.corners;  ///< of a region
  /// Takes what is to be told of a definition that succeeds; may be null.
  std::vector<Failure>* remarks = nullptr;
  [[nodiscard]] double z(double x, double y) const {
    return (zsurfD - zsurfA * x - zsurfB * y) / zsurfC;
  }
};

/// Computes the canonical form. The entity's name, subscript and place are left to the caller.
[[nodiscard]] Result<Entity> define(EntityType type,
                                    std::span<const Parameter> parameters,
                                    const Context& context);

/// The same entity moved by a 3x4 matrix (rows a b c t): what REFSYS does to an entity in use.
[[nodiscard]] Result<Entity> transformed(const Entity& entity, std::span<const double, 12> matrix);

/// Product and inverse of 3x4 affine matrices by rows.
[[nodiscard]] std::vector<double> product(std::span<const double, 12> left,
                                          std::span<const double, 12> right);
[[nodiscard]] Result<std::vector<double>> inverse(std::span<const double, 12> matrix);

}  // namespace arelem::define
