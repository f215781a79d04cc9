#pragma once
#include <optional>
#include <variant>

#include "runtime/interpret/item.h"
#include "runtime/spray/region_job.h"
#include "runtime/spray/surface/surface_job.h"

namespace arelem::runtime::interpret {

/// The parameters of SPRAY as they are written: lengths in the unit of the part program, process
/// quantities in mm, s, $/h and $/l.
struct SprayWords {
  Items items;
  EntityPtr work;
  EntityPtr gun;
  double film = 0.0;
  std::variant<double, spray::Measure> overlap = spray::Measure::average;
  std::variant<double, spray::InsetRule> inset = spray::InsetRule::mean;
  double degrees = 0.0;
  std::optional<double> speed;
  bool otherSide = false;
  std::optional<spray::Prices> prices;
  std::optional<spray::Range> sizes;
  std::optional<spray::Range> angles;
  // Of a surface.
  enum class Lines : std::uint8_t { none, alongU, alongV, sections, radial };
  Lines lines = Lines::none;
  EntityPtr plane;       ///< of sections
  EntityPtr axisPlace;   ///< POINT of radial sections
  EntityPtr axisVector;  ///< VECTOR of radial sections
  std::optional<spray::Limits4> limits;
  struct Side {
    Word modifier;    ///< XLARGE, XSMALL, ... ZSMALL: which side of the plane is kept
    EntityPtr plane;  ///< PLANE or LINE
  };
  std::vector<Side> sides;  ///< planes of LIMITS
  double step = 0.0;
  std::optional<double> chord;
  double past = 0.0;
  std::optional<double> clear;
  bool checkRadius = true;
  [[nodiscard]] bool ofRegion() const { return work->type == EntityType::region; }
};

/// SPRAY/ region, GUN, gun, FILM, h [, OVRLAP, {beta | AVG | RMS | MAX}] [, INSET, {c | EDGE | MEAN
/// | COMPAT}] [, ATANGL, deg] [, SPEED, v] [, REVERS] [, MINCST, k1, k2, k3, k4 [, HEIGHT, b1, b2,
/// db] [, ANGLE, t1, t2, dt]]
/// SPRAY/ surface, GUN, gun, FILM, h, {ULINES | VLINES | SECTN, plane | RADIAL, point, vector}
/// [, LIMITS [, u1, u2, v1, v2] [, {XLARGE | ... | ZSMALL}, plane]...] [, STEP, r] [, CHORD, tol]
/// [, PAST, d] [, CLEARP, c] [, SPEED, v] [, REVERS] [, MINRAD, OFF] The words in any order.
/// Errors: E0372.
[[nodiscard]] Result<SprayWords> readSprayWords(Items items);

}  // namespace arelem::runtime::interpret
