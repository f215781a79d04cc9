#pragma once
#include <memory>
#include <optional>
#include <string>

#include "ir/diag/result.h"
#include "runtime/motion/field.h"
#include "runtime/motion/tilt.h"

/// Tool axes that follow from the surfaces (TLAXIS).
namespace arelem::motion {

/// Where a tool axis that changes with the tool position comes from.
class AxisSource {
 public:
  virtual ~AxisSource() = default;
  /// The unit tool axis with the tool end there.
  virtual Vec3 at(const Vec3& toolEnd) = 0;
  /// Of axes that have a choice, from there on that which they make there: a motion cannot jump
  /// from one to another.
  virtual void hold(const Vec3& /*toolEnd*/) {}
  /// The tool has come there with that axis: searches around begin at it, whatever others were
  /// looked at before.
  virtual void stand(const Vec3& /*toolEnd*/, const Vec3& /*axis*/) {}
  /// The tool may come to where the axis was asked for last: what was found there is kept.
  virtual void mark() {}
  /// As it was when a place was marked; where none was, the axis is asked for anew.
  virtual void back(const Vec3& toolEnd, const Vec3& /*axis*/) { (void)at(toolEnd); }
  /// Searches begin where the first one did.
  virtual void startAnew() {}
  /// Why there was no axis with the tool end there when it was last asked for; it then was the one
  /// of the place before.
  [[nodiscard]] virtual std::optional<Failure> fault() const { return std::nullopt; }
  /// False where the axis that it was asked for last is one of many that turn into each other.
  [[nodiscard]] virtual bool settles() const { return true; }
  /// Why a motion may not get on there: the axis is one between two contacts.
  [[nodiscard]] virtual std::optional<Failure> jump() const { return std::nullopt; }
};

/// NORMPS and NORMDS: the surface's normal under the tool end, on the given side.
[[nodiscard]] std::unique_ptr<AxisSource> normalTo(const surface::AnySurface& surface, double side);

/// PARLEL: along the straight line of the surface under the tool end, in the sense nearest to
/// `start`. `toolEnd` is a place of the tool. Fails for a surface without straight lines.
[[nodiscard]] Result<std::unique_ptr<AxisSource>> alongRulings(const surface::AnySurface& surface,
                                                               const std::string& name,
                                                               const Vec3& toolEnd,
                                                               const Vec3& start);

/// A surface whose contact normal an angle is measured from or towards.
struct AngleSide {
  std::unique_ptr<Field> field;
  bool on = false;  ///< the tool end is on the surface: the normal on the axis' side counts
  std::string name;
  double side = 1.0;  ///< on: from which side the tool came, where the axis lies in the surface
  std::unique_ptr<Field> under{};  ///< of the tool end, on the tool's side
};

/// ATANGL. `start` is the axis near which the first one is looked for; `forward` gives the sense of
/// the motion, zero where none is known yet.
[[nodiscard]] std::unique_ptr<AxisSource> atAngle(
    const Tilt& tilt, AngleSide control, AngleSide other, const Vec3& start, const Vec3& forward);

}  // namespace arelem::motion
