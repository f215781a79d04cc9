#pragma once
#include <optional>
#include <vector>

#include "runtime/motion/facets/near_lines.h"
#include "runtime/motion/facets/upright_places.h"

namespace arelem::motion {

/// The triangles near a way along which a cutter stands upright, in the frame of the section: along
/// the way, across it, up.
///
/// Any normal tells a line in the section that no height of touch of a triangle is above: how far
/// its corners and the cutter reach along it.
class UprightList {
 public:
  using Line = UprightBounds::Line;

  UprightList(const FacetTask& task, const tool::UprightProfile& profile);
  UprightList(const UprightList&) = delete;
  UprightList& operator=(const UprightList&) = delete;

  /// False where there are more than `limit`, or so many in the places in question that the next
  /// lists must know how high the way goes.
  bool gather(const Way& way, std::size_t limit);
  /// Whether the next list need not know how high the way goes.
  [[nodiscard]] bool goesByPlaces() const { return slabsToCome_ == 0; }
  /// Whether the list is right at any height.
  [[nodiscard]] bool isByPlaces() const { return byPlaces_; }
  /// The height of touch at s, of all triangles of the mesh, where it is above `floor`.
  [[nodiscard]] std::optional<double> highestAt(double s,
                                                double floor,
                                                const tool::UprightTouch& touch) const;
  void focus(const Way& way);
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const std::vector<std::uint32_t>& near() const { return near_; }
  [[nodiscard]] std::uint32_t number(std::uint32_t index) const { return all_[index].number; }
  [[nodiscard]] const tool::UprightFacet& facet(std::uint32_t index) const {
    return all_[index].facet;
  }

  /// The line of one triangle for a normal that is not level.
  [[nodiscard]] Line line(std::uint32_t index, const Vec3& normal) const;
  /// What is known of the heights of one of the wide list: they are not above.
  [[nodiscard]] double known(std::uint32_t index, double s) const;
  /// Of the near triangles, in their order.
  [[nodiscard]] NearLines& lines() { return lines_; }

 private:
  using Normal = UprightBounds::Normal;
  struct Own {
    tool::UprightFacet facet;
    std::array<Line, 2> lines;   ///< for a normal towards it, and for its own
    UprightBounds::Range range;  ///< beyond these s it is beside the cutter or below the slab
    std::uint32_t number = 0;
    bool hasRange = false;

    [[nodiscard]] bool isBelow(const UprightBounds::Edge& edge) const {
      return edge.isAbove(lines[0]) || edge.isAbove(lines[1]);
    }
  };
  using Doubt = UprightBounds::Doubt;
  using Box = UprightFrame::Box;
  using Cover = UprightFrame::Cover;
  class Collect;
  class Highest;

  [[nodiscard]] bool gatherByPlaces(const Way& way);
  [[nodiscard]] bool reaches(Own& own, const Way& way);

  UprightFrame frame_;
  const UprightBounds& bounds_;
  std::shared_ptr<const UprightPlaces> places_;
  std::vector<UprightPlaces::Found> found_;
  bool byPlaces_ = false;
  int slabsToCome_ = 0;
  std::vector<Own> all_;
  std::vector<std::uint32_t> near_;
  NearLines lines_;
};

}  // namespace arelem::motion
