#pragma once
#include <memory>

#include "runtime/motion/facets/height_source.h"
#include "runtime/motion/facets/upright_list.h"

namespace arelem::motion {

/// Heights of touch where the tool axis is the section's up and the cutter has a level bottom and a
/// tangent corner arc: closed forms. Of all triangles near to the way the one that may be highest
/// is measured first; its normal then shows for most others that they are not.
class UprightHeights final : public HeightSource {
 public:
  /// None for other tasks. Heights are found to `rest`.
  [[nodiscard]] static std::unique_ptr<UprightHeights> of(const FacetTask& task, double rest);
  UprightHeights(const FacetTask& task,
                 const tool::UprightProfile& low,
                 const tool::UprightProfile& high,
                 double rest)
      : low_(low), high_(high), list_(task, low), gap_(task.low), rest_(rest) {}

  bool gather(const Way& way, std::size_t limit) override { return list_.gather(way, limit); }
  [[nodiscard]] bool isOfAnyHeight() const override { return list_.isByPlaces(); }
  [[nodiscard]] std::optional<double> heightAt(double s, double floor) const override {
    return list_.goesByPlaces() ? std::nullopt : list_.highestAt(s, floor, low_);
  }
  /// Lists hold what is above the lower side of the slab.
  [[nodiscard]] double beside(const Way& way, const SectionPoint& p) const override {
    return list_.isByPlaces() ? 0.0 : std::max(0.0, way.heightAt(p.s) - p.z);
  }
  [[nodiscard]] double aboveBands() const override { return 0.0; }
  void focus(const Way& way) override { list_.focus(way); }
  [[nodiscard]] std::size_t count(Among among) const override {
    return among == Among::wide ? list_.size() : list_.near().size();
  }
  [[nodiscard]] std::uint32_t triangle(std::uint32_t index) const override {
    return list_.number(index);
  }
  std::optional<TouchNode> node(const SectionPoint& guess, Among among) override {
    return among == Among::wide ? wideNode(guess.s) : nearNode(guess.s);
  }
  std::optional<TouchHeight> nearTop(TouchNode& node, std::uint32_t index, double below) override;
  double top(double s, TouchHeight& height) override;
  std::optional<double> penetration(const Bottom& bottom, std::uint32_t skipped) override;

 private:
  [[nodiscard]] TouchHeight heightOf(std::uint32_t index, const tool::Touch& touch) const;
  [[nodiscard]] std::optional<TouchNode> wideNode(double s);
  [[nodiscard]] std::optional<TouchNode> nearNode(double s);
  [[nodiscard]] std::optional<double> penetrationOf(const SectionPoint& from,
                                                    const SectionPoint& to,
                                                    std::uint32_t skipped);

  tool::UprightTouch low_, high_;
  UprightList list_;
  double gap_, rest_;
  std::vector<double> above_;  ///< of each near triangle
};

}  // namespace arelem::motion
