#pragma once
#include <array>
#include <optional>
#include <string>

#include "ir/space/motion_tolerance.h"
#include "runtime/geometry/kinds.h"
#include "runtime/interpret/action.h"
#include "runtime/tool/profile.h"

namespace arelem::certify {

/// Order of the values of INTOL, OUTTOL and THICK.
enum Role : std::size_t { partRole = 0, driveRole = 1, checkRole = 2, secondCheckRole = 3 };

/// A surface in one of its roles, with the name to speak of.
struct Named {
  surface::AnySurface surface = surface::Plane{};
  std::string name;
};
[[nodiscard]] Result<Named> named(const EntityPtr& entity);

/// What modal statements leave in force for the motions behind them, read from the actions alone.
class Modal {
 public:
  Vec3 toolEnd = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  bool positioned = true;  ///< the tool end is known; before FROM it is at 0, 0, 0
  std::optional<tool::Profile> cutter;
  std::array<std::optional<tool::Profile>, 2> option;  ///< CUTTER/OPTION: part, drive
  std::array<double, 4> inner{0.0, 0.0, 0.0, 0.0};
  std::array<double, 4> outer{tolerance::defaultOutside, tolerance::defaultOutside,
                              tolerance::defaultOutside, tolerance::defaultOutside};
  std::array<double, 4> thick{0.0, 0.0, 0.0, 0.0};
  std::optional<Named> part;         ///< none: the XY plane
  std::optional<Word> partRelation;  ///< TLONPS, TLOFPS
  std::optional<Word> driveRelation;
  /// The last startup asked for the cutter at the part surface, not the tool end, and nothing has
  /// moved the tool off it since.
  bool startedOffPart = false;
  /// The drive surface at which it asked for the cutter, for the motion behind it.
  std::string startedOffDrive;
  bool staysOn = false;   ///< dialect apt360: a tool end on a line goes along it whatever the word
  bool standsOn = false;  ///< so in the motion that goes on
  bool output = true;
  runtime::ToolAxis axisRule;
  std::array<std::optional<Vec3>, 3> surfaceVector;
  bool ignorePart = false;
  bool automaticPart = false;

  /// Takes over a modal statement. False for other actions.
  bool apply(const runtime::Action& action);
  /// AUTOPS, before a startup or motion; then NOPS, SRFVCT and AUTOPS are used up.
  void takeAutomaticPart();
  void consumeOneShots();

  [[nodiscard]] Named partSurface() const;
  [[nodiscard]] const tool::Profile* cutterFor(Role role) const;
  [[nodiscard]] bool toolOnDrive() const {
    return standsOn ||
           (driveRelation && (*driveRelation == Word::TLON || *driveRelation == Word::TLNDON));
  }
  /// TLLFT or TLRGT for a tool end on the line that leads it, where that is taken as TLON.
  [[nodiscard]] bool isLeftOn(const surface::AnySurface& drive, const Vec3& end) const;
  [[nodiscard]] bool toolOnPart() const { return partRelation && *partRelation == Word::TLONPS; }
  /// The axis at a tool end that is put out without one.
  [[nodiscard]] Vec3 axisAt(const Vec3& place, const surface::AnySurface& drive) const;

 private:
  void set(const runtime::Parameter& parameter);
};

}  // namespace arelem::certify
