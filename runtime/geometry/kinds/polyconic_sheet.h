#pragma once
#include <array>
#include <atomic>
#include <cstdlib>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "runtime/geometry/kinds/polyconic.h"
#include "runtime/geometry/kinds/sheet.h"
#include "runtime/geometry/polyconic.h"

/// The sheet of a POLCON. Private to runtime/geometry/kinds.
namespace arelem::surface {

class Polyconic::Sheet {
 public:
  explicit Sheet(const geometry::Polyconic& form);

  [[nodiscard]] double thickness() const { return form_.thickness; }

  [[nodiscard]] SheetPlace at(double s, double t) const;
  [[nodiscard]] static double endBefore(const Polyconic& surface, const Vec3& p);

  /// Unit normal. On the other half of a nose t runs the other way round; at its tip all t meet.
  [[nodiscard]] Vec3 normalAt(double s, const SheetPlace& p) const;

  /// A place of the sheet that was reached.
  struct Reached {
    Hint at;
    SheetPlace place;
    bool found = true;  ///< the rest to the point is square to the sheet
  };
  /// Goes from a place to one whose rest to p is square to the sheet.
  [[nodiscard]] Reached descend(const Vec3& p, const Hint& from) const;
  /// The nearest place of all, or `known` where none is nearer.
  [[nodiscard]] Reached nearest(const Vec3& p, const Reached* known) const;

  /// What lies about a place.
  struct Part {
    /// Bounds of the normal curvatures, positive where the sheet bends away from its normal. None
    /// where it is not regular or changes too much.
    std::optional<Bends> curvatures;
    double sharpest = std::numeric_limits<double>::infinity();  ///< of them, and of what is beside
    bool alone = false;  ///< it is one piece, of which no normal leans much
  };
  /// Within `reach` of the place at s and t.
  [[nodiscard]] Part about(const Hint& middle, double reach) const;

 private:
  using Interval = geometry::Interval;
  using Box = std::array<Interval, 3>;
  /// Derivatives over a box of s and t, in the system of the conics.
  struct Range {
    Box s, t, ss, st, tt;
  };
  /// What holds all places of a part of the sheet, in the system of the conics.
  struct Hull {
    Vec3 middle = Vec3::Zero(), half = Vec3::Zero();

    [[nodiscard]] double squaredFrom(const Vec3& q) const {
      return ((q - middle).cwiseAbs() - half).cwiseMax(0.0).squaredNorm();
    }
    [[nodiscard]] double squaredFrom(const Hull& o) const {
      return ((o.middle - middle).cwiseAbs() - half - o.half).cwiseMax(0.0).squaredNorm();
    }
    void widen(const Hull& o) {
      const Vec3 low = (middle - half).cwiseMin(o.middle - o.half);
      const Vec3 high = (middle + half).cwiseMax(o.middle + o.half);
      middle = 0.5 * (low + high);
      half = 0.5 * (high - low);
    }
  };
  /// A part of the sheet: its place in the middle of s and t, which is on the sheet, and its hull.
  struct Patch : Hull {
    Vec3 on = Vec3::Zero();
  };
  /// How a patch turns and bends.
  struct Turned {
    bool known = false;
    Bends curvatures;
    Vec3 normal = Vec3::Zero();  ///< one of its unit normals, in the system of the conics
    double spread = 0.0;         ///< how far the others are from it, as places
  };
  struct LateTurned {
    std::once_flag asked;
    Turned turned;
  };
  /// What is known about all places of a patch. Part unit.
  struct Surroundings {
    std::once_flag asked;
    /// The nearest place of all to a point at most so far above or below the sheet whose foot is in
    /// the patch is that foot.
    double above = 0.0, below = 0.0;
  };
  class Lows;
  /// A patch by its s and its t.
  struct Number {
    int row, column;
    [[nodiscard]] bool isBeside(int otherRow, int otherColumn) const {
      return std::abs(row - otherRow) <= 1 && std::abs(column - otherColumn) <= 1;
    }
  };

  [[nodiscard]] Patch patchOver(const Interval& s, const Interval& t) const;
  [[nodiscard]] bool isLow(const Vec3& q, int row, int column, double squared) const;
  /// Where feet of q, which is in the system of the conics, may be of which the square of the
  /// distance is below `upper`.
  [[nodiscard]] Lows lows(const Vec3& q, double upper, const Number& known) const;
  [[nodiscard]] Number numberAt(const Hint& at) const;
  [[nodiscard]] std::size_t indexOf(const Number& number) const {
    return static_cast<std::size_t>(number.row) * (edgesT_.size() - 1) +
           static_cast<std::size_t>(number.column);
  }
  /// Square of the distance of a patch from all that are not beside it.
  [[nodiscard]] double squaredAlone(const Number& number) const;
  /// True where the foot of p is proven to be the nearest place of all.
  [[nodiscard]] bool isNearest(const Vec3& p, const Reached& foot, const Number& number) const;
  void lookAround(const Number& number, Surroundings& known) const;
  /// What is within `reach` of a part of the sheet that is in a patch, and that far `beside`.
  [[nodiscard]] Part partAbout(const Hull& hull,
                               const Number& number,
                               double reach,
                               double beside) const;
  [[nodiscard]] const Turned& turned(const Number& number) const;
  [[nodiscard]] Turned turnedOver(const Interval& s, const Interval& t) const;
  [[nodiscard]] std::optional<Turned> turnedAbout(const Hint& middle,
                                                  double halfS,
                                                  double halfT) const;
  [[nodiscard]] double upwards(double s) const { return form_.hasNose() && s < 0.0 ? -1.0 : 1.0; }
  /// Over a box of s and t about a place that holds all within `reach` of it; in so many parts.
  [[nodiscard]] std::optional<Bends> curvatures(const Hint& middle, double reach, int most) const;
  [[nodiscard]] bool isProper(double s) const { return s >= properLow_ && s <= properHigh_; }

  [[nodiscard]] std::optional<Range> over(const Interval& s, const Interval& t) const;
  /// The same for a box about a place, its first derivatives also by the mean value theorem.
  [[nodiscard]] std::optional<Range> around(const Hint& middle, double halfS, double halfT) const;

  void findEnds();
  double endLow_ = 0.0, endHigh_ = 0.0;  ///< of s: behind these there is no surface
  Vec3 amid_ = Vec3::Zero();             ///< a place, and the square of a distance up to which
  double amidst_ = 0.0;                  ///< none of the ends is near it

  geometry::Polyconic form_;
  double mirrored_;                ///< 1, or -1 where the system of the conics is left-handed
  double properLow_, properHigh_;  ///< beyond these s the conics are turned over
  double width_ = 0.0;             ///< of the stretch that the numbers define
  std::vector<double> edgesS_, edgesT_;
  std::vector<Hull> rows_;                        ///< all patches of the same s
  std::vector<Patch> patches_;                    ///< by s, then t
  std::unique_ptr<std::atomic<double>[]> alone_;  ///< of each, as asked for; negative before
  std::unique_ptr<LateTurned[]> turned_;          ///< as asked for, and
  std::unique_ptr<Surroundings[]> around_;
};

}  // namespace arelem::surface
