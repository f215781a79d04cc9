#pragma once
#include <span>

#include "runtime/motion/facets/height_source.h"
#include "runtime/motion/facets/section_triangles.h"

namespace arelem::motion {

/// Heights of touch of any convex cutter in any section: by Newton steps on the gaps, which from
/// above do not go too far as gaps are convex.
class GapHeights final : public HeightSource {
 public:
  /// Heights are found to a gap of `rest`.
  GapHeights(const FacetTask& task, double rest)
      : list_(task), rest_(rest), band_(task.high - task.low) {}

  bool gather(const Way& way, std::size_t limit) override { return list_.gather(way, limit); }
  [[nodiscard]] double aboveBands() const override { return above; }
  void focus(const Way& way) override { list_.focus(way); }
  [[nodiscard]] std::size_t count(Among among) const override { return listed(among).size(); }
  [[nodiscard]] std::uint32_t triangle(std::uint32_t index) const override {
    return list_.triangle(index);
  }
  std::optional<TouchNode> node(const SectionPoint& guess, Among among) override {
    return node(guess, listed(among));
  }
  std::optional<TouchHeight> nearTop(TouchNode& node, std::uint32_t index, double below) override;
  double top(double s, TouchHeight& height) override;
  std::optional<double> penetration(const Bottom& bottom, std::uint32_t skipped) override;

 private:
  static constexpr double above = 4.5;

  using Indices = std::span<const std::uint32_t>;
  [[nodiscard]] Indices listed(Among among) const {
    return among == Among::wide ? list_.all() : list_.near();
  }
  /// None where the triangle is not touched at s, or the way is too steep there.
  [[nodiscard]] std::optional<TouchHeight> height(std::uint32_t index, const SectionPoint& guess);
  [[nodiscard]] std::optional<TouchNode> node(const SectionPoint& guess, Indices among);
  [[nodiscard]] std::optional<TouchHeight> likely(const SectionPoint& guess, Indices among);
  [[nodiscard]] std::optional<TouchHeight> nearest(const SectionPoint& guess, Indices among);
  [[nodiscard]] std::optional<double> penetrationBy(const Bottom& bottom, std::uint32_t j);

  SectionTriangles list_;
  double rest_, band_;
};

}  // namespace arelem::motion
