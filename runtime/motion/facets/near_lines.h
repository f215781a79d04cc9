#pragma once
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "runtime/motion/facets/upright_bounds.h"

namespace arelem::motion {

/// What lines tell of the heights at which an upright cutter touches the triangles near to it: two
/// of each triangle's own, and one for each of the last normals that were tried on all of them.
///
/// Few triangles are looked at very often, so they stand side by side, four in a block. What is
/// told of them are as many numbers as fill the blocks; of those beyond the last triangle,
/// `nowhere`.
class NearLines {
 public:
  using Line = UprightBounds::Line;
  static constexpr double nowhere = -std::numeric_limits<double>::infinity();

  explicit NearLines(const UprightBounds& bounds) : bounds_(bounds) {}

  /// Forgets triangles and normals.
  void clear();
  /// One more triangle: not touched outside of its range.
  void add(const tool::UprightFacet& facet,
           const std::array<Line, 2>& own,
           const UprightBounds::Range& range);
  /// Above no height at s, by all that is known.
  void heightsAt(double s, std::vector<double>& heights) const;
  /// How much the lines are above a straight piece: triangles of which one line is nowhere above it
  /// are below.
  void excessOver(const SectionPoint& from,
                  const SectionPoint& to,
                  std::vector<double>& excess) const;
  /// Lines for one more normal; lowers heights at s.
  void addNormal(const Vec3& normal, double s, std::vector<double>& heights);
  /// The same, how much they are above a straight piece.
  void addNormal(const Vec3& normal,
                 const SectionPoint& from,
                 const SectionPoint& to,
                 std::vector<double>& excess);

 private:
  static constexpr std::size_t kept = 10;  ///< normals
  static constexpr std::size_t lanes = 4;
  using Lanes = Eigen::Array4d;
  struct Block {
    std::array<Lanes, 2> base, slope;
    Lanes first, last;
    std::array<Lanes, 9> corners;   ///< coordinates
    std::array<Lanes, kept> bases;  ///< of the lines for the last normals
  };

  [[nodiscard]] std::span<Block> used() { return {blocks_.data(), used_}; }
  [[nodiscard]] std::span<const Block> used() const { return {blocks_.data(), used_}; }
  void lowerByOlder(const SectionPoint& from,
                    const SectionPoint& to,
                    std::vector<double>& excess) const;
  template <class More>
  void sweep(const Vec3& normal, const More& more, std::vector<double>& values);
  static void leaveOut(const Block& block, double from, double to, Lanes& values);
  /// What a line with that slope is above the higher one of the lines through the ends of a piece.
  [[nodiscard]] static double over(double slope, const SectionPoint& from, const SectionPoint& to) {
    return -std::min(from.z - slope * from.s, to.z - slope * to.s);
  }

  const UprightBounds& bounds_;
  std::vector<Block> blocks_;
  std::size_t count_ = 0, used_ = 0;  ///< triangles, and blocks of them
  std::array<double, kept> slopes_{};
  std::size_t rounds_ = 0;
};

}  // namespace arelem::motion
