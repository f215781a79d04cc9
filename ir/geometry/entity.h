#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/define/forms.h"
#include "ir/text/span.h"
#include "ir/words/words.h"

namespace arelem {

/// The kinds of geometric entities; the numbers are the type codes of CL records.
enum class EntityType : std::uint8_t {
  point = 1,
  line = 2,
  plane = 3,
  circle = 4,
  cylinder = 5,
  ellipse = 6,
  hyperbola = 7,
  cone = 8,
  gconic = 9,
  lconic = 10,
  vector = 11,
  matrix = 12,
  sphere = 13,
  quadric = 14,
  polyconic = 15,
  pattern = 18,
  torus = 19,
  gun = 20,
  region = 21,
  revolved = 22,
  tabulatedCylinder = 50,
  mesh = 51,
  ruledSurface = 53,
  pathSpline = 54
};

[[nodiscard]] std::string_view spell(EntityType type);  ///< "POINT", "CYLNDR", ...
[[nodiscard]] std::optional<EntityType> entityType(Word word);
/// Number of canonical values, or 0 where it varies (PATERN, TABCYL, RLDSRF, POLCON, MESH).
[[nodiscard]] int canonicalCount(EntityType type);

/// Facts of a PATERN that its coordinates alone do not tell.
struct PatternShape {
  enum class Kind : std::uint8_t { linear = 1, arc = 2, random = 3, parallel = 4 };
  Kind kind = Kind::linear;
  int columns = 1;  ///< columns of a PARLEL grid, else 1
};

/// A geometric definition reduced to its canonical numbers: all that survives a definition.
/// Layout of `canon` by type, units of the part program, angles never stored:
///   POINT x y z · LINE, PLANE a b c d (ax+by+cz=d, unit normal) · CIRCLE, CYLNDR x y z i j k r
///   CONE x y z i j k cos(half angle) · VECTOR i j k · MATRIX 12 by rows (p' = A p + t) · SPHERE x
///   y z r ELLIPS HYPERB GCONIC LCONIC QADRIC a b c d f g h p q r
///     (ax²+by²+cz²+d+2fyz+2gxz+2hxy+2px+2qy+2rz=0) · PATERN 3n coordinates
///   TABCYL n k m1..m9, then per interval u v a b len max min, then final u v · TORUS x y z i j k R
///   r GUN see runtime/spray/gun.h · REGION see runtime/region/region.h · REVOLV x y z i j k start
///   stop (degrees), then a TABCYL · BSPLIN closed m, the distinct knots, 3m coordinates of control
///   points · RLDSRF sub-forms one after another, see runtime/geometry/ruled_surface.h · MESH
///   numbers of vertices and triangles, coordinates, vertex numbers, see
///   runtime/geometry/triangle_mesh.h
struct Entity {
  EntityType type = EntityType::point;
  std::vector<double> canon;
  PatternShape pattern;                         ///< only for PATERN
  define::FormId form = define::FormId::count;  ///< that defined it; count when none did
  std::string name;                             ///< "" when unnamed (nested)
  int subscript = 0;                            ///< 0 when not an array element
  Span definition;                              ///< where it was defined
  std::shared_ptr<const void> built;  ///< of a MESH: what its surface kind made of `canon`, or null
  std::string referenceSystem;  ///< name of the REFSYS matrix in force, "" for the base system
};

using EntityPtr = std::shared_ptr<const Entity>;

}  // namespace arelem
