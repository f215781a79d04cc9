#pragma once
#include <array>
#include <optional>
#include <string>

#include "ir/geometry/entity.h"
#include "ir/space/motion_tolerance.h"
#include "runtime/geometry/kinds.h"
#include "runtime/interpret/action.h"
#include "runtime/tool/profile.h"

namespace arelem::motion {

/// A surface in one of its roles, with the name to speak of.
struct NamedSurface {
  EntityPtr entity;
  surface::AnySurface surface = surface::Plane{};
  std::string name;

  [[nodiscard]] bool isPlane() const { return std::holds_alternative<surface::Plane>(surface); }
};

/// Order of the values of INTOL, OUTTOL and THICK (which differs from that of GO/).
enum Role : std::size_t { partRole = 0, driveRole = 1, checkRole = 2, secondCheckRole = 3 };

/// Everything that is modal in Section 2, as one value.
struct State {
  Vec3 toolEnd = Vec3::Zero();
  bool positioned = false;  ///< FROM or a motion was met
  bool adrift = false;      ///< the last motion failed: the tool is not where the program means it
  Vec3 axis = Vec3::UnitZ();
  std::optional<Vec3> forward;  ///< last non-axial displacement or INDIRV/INDIRP
  /// Last displacement that was not along the axis: where the forward direction is axial.
  std::optional<Vec3> lastAcross;
  std::optional<tool::Profile> cutter;
  bool cutterRefused = false;  ///< CUTTER was in error: motions are left out without further words
  std::array<std::optional<tool::Profile>, 2> option;  ///< CUTTER/OPTION for part (0) and drive (1)
  std::array<double, 4> inner{0.0, 0.0, 0.0, 0.0};
  std::array<double, 4> outer{tolerance::defaultOutside, tolerance::defaultOutside,
                              tolerance::defaultOutside, tolerance::defaultOutside};
  std::array<double, 4> thick{0.0, 0.0, 0.0, 0.0};
  double longestVector = 10.0;       ///< MAXDP
  double vectorLimit = 400.0;        ///< NUMPTS
  std::optional<NamedSurface> part;  ///< none: the XY plane
  std::optional<Word> partRelation;  ///< TLONPS, TLOFPS; none before the first of them
  /// The last startup brought the cutter, and not the tool end, to the part surface, and the tool
  /// was not moved off it since.
  bool touchesPart = false;
  std::optional<Word> driveRelation;  ///< TLLFT, TLRGT, TLON; none before the first of them
  bool staysOn = false;               ///< TLLFT, TLRGT: a tool end on a line stays there (apt360)
  bool alwaysIterate = false;         ///< 3DCALC
  bool multax = false;
  bool toldOfAxis = false;  ///< that one is not written
  bool gougeCheck = false;
  bool output = true;  ///< CUT, not DNTCUT
  runtime::ToolAxis axisRule;
  std::array<std::optional<Vec3>, 3> direction;  ///< INDIRV or INDIRP turned to vectors, by surface
  std::array<std::optional<Vec3>, 3> surfaceVector;  ///< SRFVCT
  bool ignorePart = false;                           ///< NOPS
  bool automaticPart = false;                        ///< AUTOPS

  [[nodiscard]] double band(Role role) const { return inner[role] + outer[role]; }
};

}  // namespace arelem::motion
