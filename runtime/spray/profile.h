#pragma once
#include <span>
#include <utility>
#include <vector>

#include "ir/diag/result.h"

namespace arelem::spray {

/// How one straight pass deposits paint across its path: the density p(u) at the place u = y / b
/// between -1 and 1, with unit area. The film of one pass is h(y) = q / (v b) p(y / b), where q is
/// the flow that stays on the work, v the speed and b the half width of the footprint.
class Profile {
 public:
  /// An elliptical (or round) footprint of uniform deposition: p(u) = 2/pi sqrt(1 - u^2)
  /// (Bartlett 2.9; a cone of spray is the round case, Sen 3.1).
  [[nodiscard]] static Profile ellipse();
  /// A flat fan: p(u) = 1/2.
  [[nodiscard]] static Profile flat();
  /// Measured film at places across the pass, straight between them and 0 outside. Places rise;
  /// films are not negative and not all zero. They are centered and scaled to -1 ... 1; the half
  /// width in the units of the places is `halfWidth`. Errors: E0352.
  struct Measured;
  [[nodiscard]] static Result<Measured> table(std::span<const std::pair<double, double>> points);
  /// A table whose places are already -1 ... 1: what a gun stores.
  [[nodiscard]] static Profile normalized(std::vector<std::pair<double, double>> points);

  [[nodiscard]] double density(double u) const;
  /// Area of the density from -1 to u.
  [[nodiscard]] double share(double u) const;
  /// Places where the density has a kink, in order; the first is -1, the last 1.
  [[nodiscard]] const std::vector<double>& knots() const { return knots_; }
  [[nodiscard]] bool isEllipse() const { return kind_ == Kind::ellipse; }
  [[nodiscard]] bool isTable() const { return kind_ == Kind::table; }
  /// Place and density of a table's points.
  [[nodiscard]] const std::vector<std::pair<double, double>>& points() const { return points_; }

 private:
  enum class Kind : std::uint8_t { ellipse, flat, table };
  explicit Profile(Kind kind) : kind_(kind), knots_{-1.0, 1.0} {}

  Kind kind_;
  std::vector<double> knots_;
  std::vector<std::pair<double, double>> points_;  // of a table
  std::vector<double> shares_;                     // up to each point
};

struct Profile::Measured {
  Profile profile;
  double halfWidth = 0.0;
};

}  // namespace arelem::spray
