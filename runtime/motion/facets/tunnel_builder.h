#pragma once
#include <memory>

#include "runtime/motion/facets/height_source.h"
#include "runtime/motion/facets/tunnel.h"
#include "runtime/tool/triangle_gap.h"

namespace arelem::motion {

/// Finds the tunnel of a motion along facets, piece by piece.
///
/// Cells between two nodes have one straight line as top, from the heights of one triangle at both
/// ends, which is right as those heights are concave in between. Their bottom is a straight line or
/// one with a corner; no triangle comes up to it, which tangents of its gap prove. Cells for which
/// that cannot be shown are divided.
class TunnelBuilder {
 public:
  /// `reach`: the length of a cut vector, roughly.
  TunnelBuilder(const FacetTask& task, double reach);

  /// Starts at a place within the tolerance; false where no tunnel begins there.
  bool begin(const SectionPoint& at);
  /// Makes it longer; false where it ends: at walls, cliffs and borders.
  bool extend();
  [[nodiscard]] const Tunnel& tunnel() const { return tunnel_; }
  void forget(double s);
  /// The triangle touched at s, the nearer of those at the nodes around.
  [[nodiscard]] tool::TriangleGap touchAt(const SectionPoint& p) const;
  [[nodiscard]] const FacetTask& task() const { return task_; }

 private:
  enum class Outcome : std::uint8_t { done, outside, ends };
  using Among = HeightSource::Among;
  using Bottom = HeightSource::Bottom;
  /// A piece of way whose triangles are listed.
  struct List {
    Way way;
    double length = 0.0;  ///< of the next
    double bend = 0.0;    ///< half the height of its slab, by the square of its length
    double use = 0.0;     ///< what of that was made use of

    [[nodiscard]] double share() const { return bend * length; }
    void see(double beside) {
      const double gone = way.to.s - way.from.s;
      use = std::max(use, beside / (gone * gone));
    }
    /// The bend of the next one is near to what this one took.
    void settleBend();
    /// The next one, from s on, is shorter in a higher slab.
    void shorten(double s);
  };
  struct Mark {
    double s = 0.0;
    std::uint32_t triangle = 0;
  };

  [[nodiscard]] std::optional<double> probe(double s, double guess);
  [[nodiscard]] Way ahead(const SectionPoint& here, double slope, double length);
  bool gather();
  bool resume(std::uint32_t highest);
  bool focus();
  Outcome settle(TouchNode& a, TouchNode& b, int depth);
  Outcome divide(TouchNode& a, TouchNode& b, double s, int depth);
  [[nodiscard]] std::optional<std::uint32_t> witness(TouchNode& a, TouchNode& b);
  [[nodiscard]] Bottom bottomOf(TouchNode& a, TouchNode& b, std::uint32_t i) const;
  void emit(TouchNode& a, TouchNode& b, const Bottom& bottom, std::uint32_t i);
  [[nodiscard]] bool isInSlab(const TouchNode& node);

  FacetTask task_;
  tool::Body body_;
  double band_, spare_, bent_;
  std::unique_ptr<HeightSource> heights_;
  double above_, slab_;  ///< how far nothing is above cells; least height of slabs
  Tunnel tunnel_;
  TouchNode last_;
  std::vector<Mark> marks_;
  List wide_, near_;
  Way foreseen_;
  double missed_ = 0.0;  ///< how far heights were from where they were looked for
  double step_, least_, shortest_;
  bool ended_ = false;
};

}  // namespace arelem::motion
