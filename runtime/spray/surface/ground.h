#pragma once
#include <vector>

/// How far apart sections lie on a surface that leans against their planes.
namespace arelem::spray {

/// A piece of a surface between two levels of the sections. `apart`: how far it is over the
/// surface, straight across the sections, in a unit of the level; mm.
struct LevelSpan {
  double low = 0.0, high = 0.0, apart = 1.0;
};

/// The way across the sections from the lowest level to the highest, at each level as long as over
/// the piece that leans most there. Sections that are equally far apart on it are nowhere farther
/// apart on the surface.
class Ground {
 public:
  /// Levels from `low` to `high`; pieces beyond do not count.
  Ground(std::vector<LevelSpan> spans, double low, double high);

  /// mm.
  [[nodiscard]] double length() const { return ways_.back(); }
  /// The level at a length of the way, 0 to `length()`.
  [[nodiscard]] double levelAt(double way) const;

 private:
  std::vector<double> levels_;
  std::vector<double> ways_;  // to each level
};

}  // namespace arelem::spray
