#pragma once
#include <memory>

#include "runtime/certify/bounds.h"
#include "runtime/certify/chord.h"
#include "runtime/geometry/kinds.h"
#include "runtime/tool/contact.h"

namespace arelem::certify {

/// What is known about the gap at one place of a cut vector.
struct Node : Known {
  double s = 0.0;
  Vec3 toolEnd = Vec3::Zero(), axis = Vec3::UnitZ();
  Vec3 point = Vec3::Zero();     ///< of the cutter, where `high` was measured; the core's place
  surface::Foot foot;            ///< of `point`, by the surface's own side
  Vec3 normal = Vec3::UnitZ();   ///< unit, towards the tool
  Vec3 support = Vec3::UnitZ();  ///< gradient of a linear function of the tool end below the gap,
                                 ///< `low` here; of convex solids
  std::size_t triangle = 0;      ///< of a mesh, in contact
};

/// What is known about the gap over a part of a cut vector.
struct Stretch : Range {
  double sample = unbounded;  ///< a gap that was measured there, with its place
  double sampleAt = 0.0;
  Vec3 sampleOn = Vec3::Zero();  ///< the point of the cutter
};

/// How the tool is to stand to a surface. The gap of a cutter is the least distance, positive on
/// `side`, of any of its points to the surface, less `thick`; without a cutter the distance of the
/// tool end.
struct Relation {
  const tool::Profile* cutter = nullptr;
  double side = 1.0;
  double thick = 0.0;
};

/// Measures the gap along cut vectors with bounds that hold for all of their points. It knows
/// surfaces and cutters, nothing of how motion was computed. One belongs to one thread.
class Probe {
 public:
  virtual ~Probe() = default;
  /// The cut vector that the other calls speak of.
  virtual void take(const Chord& chord) = 0;
  /// Ball ends are measured by the ball, which is quick and tells nothing where the shank touches.
  /// Goes over to the whole cutter until the next chord is taken; false where that is measured
  /// already. Nodes from before count no more.
  virtual bool widen() { return false; }
  /// The node at s = 0 of the chord taken, from the one at s = 1 of the chord before it.
  virtual Node resume(const Node& previous) = 0;
  /// `low` may be -unbounded where it is costly; `settle` then finds it.
  virtual Node at(double s) = 0;
  /// The gap between two nodes. A lower bound above `aim` need not be made narrower; where a gap
  /// below it is measured, that ends the search. With an aim of -unbounded none is looked for.
  virtual Stretch over(const Node& a, const Node& b, double aim) = 0;
  /// Raises `low` of a node to at least `aim`, if that can be proven; a gap below that was measured
  /// becomes its `high`.
  virtual void settle(Node& node, double aim) = 0;
};

/// A place of a chord, where nothing was measured yet.
[[nodiscard]] inline Node placeOn(const Chord& chord, double s) {
  Node n;
  n.s = s;
  n.toolEnd = chord.toolEnd(s);
  n.axis = chord.axis(s);
  return n;
}

/// What a contact tells of a place of a chord: no more than how near the cutter is at most.
inline void note(const tool::Contact& contact, double thick, const Chord& chord, Node& n) {
  n.point = contact.point;
  n.normal = contact.normal;
  n.high = contact.gap - thick;
  n.low = -unbounded;
  n.slope = n.normal.dot(chord.velocity(n.point - n.toolEnd));
}

/// `previous` as the beginning of a chord: only its slope changes.
[[nodiscard]] inline Node turned(Node previous, const Chord& chord) {
  previous.s = 0.0;
  previous.slope = previous.normal.dot(chord.velocity(previous.point - previous.toolEnd));
  return previous;
}

[[nodiscard]] std::unique_ptr<Probe> makeProbe(const surface::AnySurface& surface,
                                               const Relation& relation);

}  // namespace arelem::certify
