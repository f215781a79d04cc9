#pragma once
#include <optional>

#include "runtime/motion/facets/touch_node.h"

namespace arelem::motion {

/// The heights at which a cutter touches the triangles of a mesh, along pieces of a section.
///
/// Two lists of triangles go along: a wide one for a long piece of way, and the near ones of it for
/// the piece that is looked at. What is not listed is farther off anywhere in the slab.
class HeightSource {
 public:
  /// The lower line over a piece of way: straight, or with a corner.
  struct Bottom {
    SectionPoint from, corner, to;
    double rise = 0.0;  ///< of the corner; 0: it is none
  };
  enum class Among : std::uint8_t { wide, near };

  HeightSource() = default;
  HeightSource(const HeightSource&) = delete;
  HeightSource& operator=(const HeightSource&) = delete;
  virtual ~HeightSource() = default;

  /// Lists all triangles whose gap may be less than the task's low anywhere within the slab. False
  /// where there are more than `limit`.
  virtual bool gather(const Way& way, std::size_t limit) = 0;
  /// Whether the list is right at any height, not only within the slab.
  [[nodiscard]] virtual bool isOfAnyHeight() const { return false; }
  /// The height of the tool end at s, of all triangles, where it is above `floor`; none also where
  /// that is not easily found.
  [[nodiscard]] virtual std::optional<double> heightAt(double /*s*/, double /*floor*/) const {
    return std::nullopt;
  }
  /// How far a place is on the side of a way on which its slab must have room for it.
  [[nodiscard]] virtual double beside(const Way& way, const SectionPoint& p) const {
    return way.beside(p);
  }
  /// How far above cells nothing may be either, in bands.
  [[nodiscard]] virtual double aboveBands() const = 0;
  /// Those of them that matter on a part of the way.
  virtual void focus(const Way& way) = 0;
  [[nodiscard]] virtual std::size_t count(Among among) const = 0;
  /// The number in the mesh of one of the wide list.
  [[nodiscard]] virtual std::uint32_t triangle(std::uint32_t index) const = 0;

  /// The highest of the triangles listed; none where the way is too steep.
  virtual std::optional<TouchNode> node(const SectionPoint& guess, Among among) = 0;
  /// The height of one triangle at a node, if it is not below the node's by more than `below`.
  virtual std::optional<TouchHeight> nearTop(TouchNode& node,
                                             std::uint32_t index,
                                             double below) = 0;
  /// Finds the top of a height.
  virtual double top(double s, TouchHeight& height) = 0;
  /// Where one of the near triangles, but for `skipped`, may come through a bottom, or between it
  /// and the top.
  virtual std::optional<double> penetration(const Bottom& bottom, std::uint32_t skipped) = 0;
};

}  // namespace arelem::motion
