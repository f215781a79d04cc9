#include "ir/geometry/entity.h"

#include <array>

namespace arelem {

namespace {
struct TypeRow {
  EntityType type;
  Word word;
  int count;
};
constexpr std::array rows = {
    TypeRow{EntityType::point, Word::POINT, 3},
    TypeRow{EntityType::line, Word::LINE, 4},
    TypeRow{EntityType::plane, Word::PLANE, 4},
    TypeRow{EntityType::circle, Word::CIRCLE, 7},
    TypeRow{EntityType::cylinder, Word::CYLNDR, 7},
    TypeRow{EntityType::ellipse, Word::ELLIPS, 10},
    TypeRow{EntityType::hyperbola, Word::HYPERB, 10},
    TypeRow{EntityType::cone, Word::CONE, 7},
    TypeRow{EntityType::gconic, Word::GCONIC, 10},
    TypeRow{EntityType::lconic, Word::LCONIC, 10},
    TypeRow{EntityType::vector, Word::VECTOR, 3},
    TypeRow{EntityType::matrix, Word::MATRIX, 12},
    TypeRow{EntityType::sphere, Word::SPHERE, 4},
    TypeRow{EntityType::quadric, Word::QADRIC, 10},
    TypeRow{EntityType::polyconic, Word::POLCON, 0},
    TypeRow{EntityType::pattern, Word::PATERN, 0},
    TypeRow{EntityType::torus, Word::TORUS, 8},
    TypeRow{EntityType::tabulatedCylinder, Word::TABCYL, 0},
    TypeRow{EntityType::gun, Word::GUN, 0},
    TypeRow{EntityType::region, Word::REGION, 0},
    TypeRow{EntityType::revolved, Word::REVOLV, 0},
    TypeRow{EntityType::mesh, Word::MESH, 0},
    TypeRow{EntityType::ruledSurface, Word::RLDSRF, 0},
    TypeRow{EntityType::pathSpline, Word::BSPLIN, 0},
};
}  // namespace

std::string_view spell(EntityType type) {
  for (const TypeRow& r : rows) {
    if (r.type == type) {
      return spell(r.word);
    }
  }
  return "?";
}

std::optional<EntityType> entityType(Word word) {
  for (const TypeRow& r : rows) {
    if (r.word == word) {
      return r.type;
    }
  }
  return std::nullopt;
}

int canonicalCount(EntityType type) {
  for (const TypeRow& r : rows) {
    if (r.type == type) {
      return r.count;
    }
  }
  return 0;
}

}  // namespace arelem
