#pragma once
#include <memory>
#include <optional>
#include <string>

#include "runtime/certify/chord.h"
#include "runtime/geometry/kinds.h"
#include "runtime/motion/bulge.h"
#include "runtime/tool/contact.h"

namespace arelem::motion {

/// What a proof says of a cut vector.
struct Judgement {
  double factor = 1.0;  ///< 1: it keeps its band; else by which to shorten it
  int miss = 0;         ///< -1: it is too near to the surface somewhere, 1: too far off
};
/// What a gap in the middle of a cut vector says: as if the gap bent evenly away from its ends.
[[nodiscard]] Judgement judgeGap(double gap, double inner, double outer);

/// A mesh and the convex cutter that runs along it.
struct Facets {
  const surface::Mesh* mesh = nullptr;
  const tool::Profile* cutter = nullptr;
  double thick = 0.0;
};

/// The gap between the tool and one side of one surface as a function of where the tool is:
/// 1-Lipschitz in the tool end, with the contact normal as gradient. Remembers the last contact to
/// start the next search, so one Field belongs to one motion of one thread.
class Field {
 public:
  virtual ~Field() = default;
  /// `axis` is the unit tool axis.
  virtual tool::Contact at(const Vec3& toolEnd, const Vec3& axis) = 0;
  /// Whether the gap stays in [-inner, outer] over the whole straight cut vector between two
  /// positions. Smooth surfaces set no limit: there the slopes at a few places tell enough.
  [[nodiscard]] virtual Judgement judge(const certify::Chord& chord, double inner, double outer);
  /// A gap on the cut vector that is proven to be above `outer`, if one is found: for chords on
  /// which the slopes at a few places do not tell enough.
  [[nodiscard]] virtual std::optional<Bulge> bulge(const certify::Chord& chord, double outer) = 0;
  /// Of a mesh and a convex cutter; they stay as long as the field.
  [[nodiscard]] virtual std::optional<Facets> facets() const { return std::nullopt; }
  /// True where the gap is a linear function of the tool end (planes).
  [[nodiscard]] bool flat() const { return flat_; }
  /// True for meshes: no few places tell about those between them; `judge` does.
  [[nodiscard]] bool isFaceted() const { return faceted_; }
  /// True where the gap is a convex or a concave function of the tool end: without a dip or a rise
  /// between places that lie on a line.
  [[nodiscard]] bool isEven() const { return even_; }

 protected:
  Field(bool flat, bool faceted, bool even) : flat_(flat), faceted_(faceted), even_(even) {}

 private:
  bool flat_, faceted_, even_;
};

/// Which part of the tool meets the surface.
struct Tool {
  const tool::Profile* cutter = nullptr;  ///< null: the tool end alone (relation ON)
  double thick = 0.0;                     ///< stock left between cutter and surface, ignored for ON
};

/// `side` is +1 or -1: the side of the surface, by its own normal, on which the tool stands.
[[nodiscard]] std::unique_ptr<Field> makeField(const surface::AnySurface& surface,
                                               double side,
                                               Tool tool);

/// Signed distance of a point to a surface, by the surface's own normal.
[[nodiscard]] surface::Foot footOn(const surface::AnySurface& surface, const Vec3& point);

/// The least radius of curvature of the surface nearest to a point, where it is hollow seen from
/// `side`; without end where it is not.
[[nodiscard]] double hollowRadius(const surface::AnySurface& surface,
                                  double side,
                                  const Vec3& point);

}  // namespace arelem::motion
