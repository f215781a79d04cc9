#pragma once
#include <array>
#include <limits>
#include <numbers>

#include "runtime/tool/contact_descent.h"
#include "runtime/tool/rounded.h"
#include "runtime/tool/section_proof.h"
#include "runtime/tool/survey_grid.h"

/// The general contact: the least side * distance over the whole cutter. Private to runtime/tool.
///
/// A descent from the last contact finds a local minimum. Bounds of how far the distance bends
/// towards the cutter prove that it is the least of all, or the whole cutter is surveyed.
namespace arelem::tool {

template <surface::Surface S>
class ContactSearch {
 public:
  ContactSearch(const S& s,
                double sign,
                const Profile& cutter,
                const Vec3& te,
                const Vec3& axis,
                Search<S>& search)
      : surface_(s),
        side_(sign),
        cutter_(cutter),
        te_(te),
        axis_(axis),
        search_(search),
        descent_(s, sign, cutter, te, axis, search) {}

  Contact run() {
    const bool convex = search_.convex || isConvexAround();
    if (search_.valid && isRoundBall(cutter_)) {
      const Contact ball = descent_.ofBall();
      const bool below = ball.normal.dot(axis_) >= cutter_.sinBeta;
      if (below && (convex || (bottomIsProven(ball, true) && shankIsClear(ball.gap)))) {
        return ball;
      }
    }
    if (search_.onDisc && convex) {
      const Contact level = descent_.onDiscAgain();
      if (search_.onDisc && supports(level)) {
        return level;
      }
      search_.onDisc = false;
    }
    descent_.begin();
    const Contact local = descent_.nearestPiece();
    const bool proven =
        (convex && supports(local)) ||
        (!search_.convex && bottomIsProven(local, descent_.onCorner()) && shankIsClear(local.gap));
    if (proven || leads(local) ||
        SectionProof<S>(surface_, side_, cutter_, te_, axis_, search_.hint).holds(local)) {
      return local;
    }
    return survey(local);
  }

 private:
  static constexpr double supportSlack = 1e-9;
  /// Length of shank that is proven together with the bottom, in radii of the corner.
  static constexpr double lowShare = 1.5;
  /// Growth of the pieces in which the shank above is proven.
  static constexpr double growth = 1.6;
  /// Convexity is looked for in a ball so many times as large as the cutter's.
  static constexpr double roomy = 2.0;
  /// A bound of the bend is asked for so much more than is needed, to serve the next contacts; less
  /// where that is not known.
  static constexpr std::array reserves{1.5, 1.15, 1.0};
  static constexpr double bolder = 1.2;
  static constexpr double idleShare = 0.1;
  static constexpr int angles = SurveyRows::angles;
  /// Cosine of one and a half steps between the angles of the grid.
  static constexpr double besideContact = 0.83;
  /// Of the radius at which the cone of a drill ends: where its point ends, and its corner begins.
  static constexpr double pointShare = 0.25, mostOfCone = 0.9;
  /// Share of the lead over the places of the grid that those between them leave.
  static constexpr double trustedShare = 0.5;

  // ---- proofs -----------------------------------------------------------------------------------

  /// True where the distance bends away from the cutter all over a ball that holds it: the outside
  /// of a torus. What is found holds until the tool leaves the place.
  [[nodiscard]] bool isConvexAround() {
    const double low = std::min(0.0, cutter_.f - cutter_.r);
    const Vec3 middle = te_ + 0.5 * (cutter_.h + low) * axis_;
    const double known = search_.convexWay;
    if ((middle - search_.convexAt).squaredNorm() <= known * known && known != 0.0) {
      return known > 0.0;
    }
    const double across = std::max(cutter_.maxRadius(), cutter_.e + cutter_.r);
    const double radius = std::sqrt(across * across + 0.25 * (cutter_.h - low) * (cutter_.h - low));
    auto hint = search_.hint;
    const surface::Bends bends =
        surface_.bends(middle, surface_.foot(middle, hint), roomy * radius);
    const bool convex = side_ > 0.0 ? bends.low >= 0.0 : bends.high <= 0.0;
    search_.convexAt = middle;
    search_.convexWay = (convex ? 1.0 : -1.0) * (roomy - 1.0) * radius;
    return convex;
  }

  /// True where the cutter lies before the plane through the contact square to its normal; a convex
  /// distance lies above the distance from that plane.
  [[nodiscard]] bool supports(const Contact& c) const {
    const double far = reach(cutter_, c.normal.dot(axis_));
    return c.normal.dot(te_ - c.point) >= far - supportSlack * (1.0 + far);
  }

  /// Height above the corner's center up to which bottomIsProven speaks.
  [[nodiscard]] double lowHeight() const {
    return cutter_.ring ? 0.0 : std::min(lowShare * (cutter_.e + cutter_.r), cutter_.h - cutter_.f);
  }

  /// The cutter up to lowHeight lies within r of the disc of radius e and what is above it. With K
  /// the bound of the bend towards the cutter, the distance at a point x of the disc is at least
  /// that at the contact's q plus n.(x - q) - K/2 |x - q|^2, which is positive all over the disc if
  /// the slope of n towards q is at least K e; and from x upwards it rises.
  [[nodiscard]] bool bottomIsProven(const Contact& c, bool onCorner) {
    if (cutter_.alpha > 0.0) {
      return false;
    }
    const double high = lowHeight();
    const Vec3 core = c.point + cutter_.r * c.normal;
    const Vec3 rim = te_ + cutter_.e * search_.toward + cutter_.f * axis_;
    const double slack = supportSlack * (1.0 + cutter_.e);
    const bool inside = (core - rim).norm() > slack;
    if (cutter_.e == 0.0 ? !onCorner : inside && !isLevel(c, slack)) {
      return false;
    }
    const double widening = cutter_.sinBeta / cutter_.cosBeta;
    // A ball that holds the disc and what is above it.
    const Vec3 middle = te_ + (cutter_.f + 0.5 * high) * axis_;
    const double across = cutter_.e + high * std::max(widening, 0.0);
    const double radius = std::sqrt(across * across + 0.25 * high * high);
    const auto proves = [&](double towards) {
      const double slope = -c.normal.dot(search_.toward);
      if (inside && towards > 0.0) {
        return false;
      }
      const double bent = towards * (2.0 * cutter_.e + 0.5 * high * (1.0 + widening * widening));
      return (inside || towards * cutter_.e <= slope) &&
             (high <= 0.0 || bent + widening <= c.normal.dot(axis_));
    };
    return radius <= 0.0 || isBounded(middle, radius, proves);
  }

  /// True where some bound of the bend around `middle` proves it. Where the last one reached no
  /// farther than asked for, that is not tried again for much farther, and if it proved nothing,
  /// not until the tool has moved.
  template <class Proves>
  bool isBounded(const Vec3& middle, double radius, const Proves& proves) {
    const double moved = (middle - search_.boundAt).norm();
    const double last = search_.boundRadius / radius;
    const bool proved = last > 0.0 && proves(search_.bound);
    if (proved && moved <= search_.boundRadius - radius) {
      return true;
    }
    const bool near = last > 0.0 && moved <= radius;
    if (near && !proved && last <= reserves.back() && moved <= idleShare * radius) {
      return false;
    }
    return std::any_of(reserves.begin(), reserves.end(), [&](double reserve) {
      return !(near && reserve > bolder * last) && proves(boundAround(middle, reserve * radius));
    });
  }

  /// True where the contact is inside a level bottom: the distance has no slope there. Where it
  /// bends away from the cutter everywhere it is the least.
  [[nodiscard]] bool isLevel(const Contact& c, double slack) const {
    const double nz = c.normal.dot(axis_);
    return nz > 0.0 && 2.0 * cutter_.e * (c.normal - nz * axis_).norm() <= slack;
  }

  /// How much the distance bends towards the cutter within `radius` of a place; kept in the search.
  double boundAround(const Vec3& place, double radius) {
    auto hint = search_.hint;
    const surface::Foot foot = surface_.foot(place, hint);
    const surface::Bends bends = surface::bendsOf(surface_, place, foot, radius, hint);
    search_.bound = std::max(0.0, side_ > 0.0 ? -bends.low : bends.high);
    search_.boundAt = place;
    search_.boundRadius = radius;
    return search_.bound;
  }

  /// True where no point of the shank above lowHeight comes nearer than `gap`: the distance changes
  /// by no more than the way, so the places on the axis tell about the shank around them. What is
  /// found holds until the tool has moved half as far.
  bool shankIsClear(double gap) {
    const double moved =
        (te_ - search_.clearAt).norm() + cutter_.h * (axis_ - search_.clearAxis).norm();
    if (2.0 * moved < search_.clearance) {
      return true;
    }
    double clearance = std::numeric_limits<double>::infinity();
    double from = cutter_.f + lowHeight();
    while (!cutter_.ring && from < cutter_.h) {
      const double to = std::min(cutter_.f + growth * (from - cutter_.f) + supportSlack, cutter_.h);
      const double outmost =
          cutter_.sideStart.rho + cutter_.sinBeta / cutter_.cosBeta * (to - cutter_.sideStart.z);
      const double onAxis =
          side_ * descent_.footAt({0.0, 0.5 * (from + to)}, search_.toward).distance;
      clearance = std::min(clearance, onAxis - std::hypot(outmost, 0.5 * (to - from)) - gap);
      from = to;
    }
    search_.clearance = clearance;
    search_.clearAt = te_;
    search_.clearAxis = axis_;
    return clearance >= 0.0;
  }

  /// True where what the last survey found elsewhere is still farther off: distances change by no
  /// more than the way of the tool. Places between those of its grid may be nearer than they are.
  [[nodiscard]] bool leads(const Contact& c) const {
    const double moved =
        (te_ - search_.leadAt).norm() + cutter_.h * (axis_ - search_.leadAxis).norm();
    return search_.lead > 0.0 && c.gap + moved <= search_.leadGap;
  }

  // ---- survey -----------------------------------------------------------------------------------

  Contact descend(SurveyRow::Piece piece, double along) {
    switch (piece) {
      case SurveyRow::bottom:
        return descent_.onBottom(along);
      case SurveyRow::side:
        return descent_.onSide(along);
      default:
        return descent_.nearestPiece();
    }
  }

  /// A minimum of the distance over the cutter, and its direction from the axis.
  struct Low {
    double gap;
    Vec3 point, toward;
    bool apart = false;  ///< from others in that direction
  };
  struct Lows {
    std::array<Low, 2 * SurveyRows::most * angles + 1> list;
    std::size_t count = 0;
    void add(const Low& low) { list[count++] = low; }
  };

  /// Descends from every low place of a grid over the whole cutter, and from those between its
  /// places that may be nearer than the best.
  Contact survey(const Contact& local) {
    constexpr double step = 2.0 * std::numbers::pi / angles;
    const SurveyRows all(cutter_);
    std::array<Vec3, angles> directions;
    for (int k = 0; k < angles; ++k) {
      directions[static_cast<std::size_t>(k)] = descent_.direction(step * k);
    }
    Contact best = local;
    Vec3 toward = search_.toward;
    auto hint = search_.hint;
    SurveyGrid grid(all, cutter_.alpha > 0.0);
    double skipped = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < all.count; ++r) {
      skipped = std::min(skipped,
                         fill(grid.values[r], grid.slopes[r], all.list[r], directions, best.gap));
    }
    grid.sharpen();
    Lows lows;
    lows.add({local.gap, local.point, toward});
    const auto look = [&](const SurveyRow& row, const Vec3& direction, bool apart) {
      descent_.turnTo(direction);
      const Contact c = descend(row.piece, row.along);
      lows.add({c.gap, c.point, search_.toward, apart});
      if (c.gap < best.gap) {
        best = c;
        toward = search_.toward;
        hint = search_.hint;
      }
    };
    for (std::size_t r = 0; r < all.count; ++r) {
      for (int k = 0; k < angles; ++k) {
        const Vec3& here = directions[static_cast<std::size_t>(k)];
        if (grid.isLow(r, k)) {
          look(all.list[r], here, false);
        }
        const auto [gap, share] = grid.behind(r, k);
        if (gap < best.gap) {
          const Vec3& next = directions[static_cast<std::size_t>((k + 1) % angles)];
          look(all.list[r], (1.0 - share) * here + share * next, true);
        }
      }
    }
    search_.toward = toward;
    search_.hint = hint;
    const Zone zone = zoneOf(best.point);
    const double others =
        std::min({skipped, leastBeside(grid.values, all, directions, toward, zone),
                  leastApart(lows, best, toward)});
    search_.lead = trustedShare * (others - best.gap);
    search_.leadGap = best.gap + search_.lead;
    search_.leadAt = te_;
    search_.leadAxis = axis_;
    return best;
  }

  /// The point of a drill, its cone and its corner are apart, though in one direction from the
  /// axis.
  enum class Zone { point, cone, corner };
  Zone zoneOf(const Vec3& place) const {
    const double out = (place - te_).cross(axis_).norm();
    return cutter_.alpha == 0.0 || out >= mostOfCone * cutter_.bottomEnd.rho ? Zone::corner
           : out < pointShare * cutter_.bottomEnd.rho                        ? Zone::point
                                                                             : Zone::cone;
  }

  /// The least minimum that is another contact: between two places of the grid the tool is nearer.
  double leastApart(const Lows& lows, const Contact& best, const Vec3& toward) const {
    const auto below = [&](const Vec3& p) { return (p - te_).dot(axis_) <= cutter_.sideStart.z; };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < lows.count; ++i) {
      const Low& low = lows.list[i];
      const bool beside = !low.apart && below(low.point) &&
                          low.toward.dot(toward) >= besideContact &&
                          zoneOf(low.point) == zoneOf(best.point);
      if (!(beside && below(best.point)) &&
          (low.point - best.point).norm() > tolerance::coincidence) {
        least = std::min(least, low.gap);
      }
    }
    return least;
  }

  /// The least distance of the grid but for the bottom and the corner next to the contact. Of
  /// point, cone and corner of a drill those that do not touch count.
  double leastBeside(const SurveyGrid::Values& grid,
                     const SurveyRows& all,
                     const std::array<Vec3, angles>& directions,
                     const Vec3& toward,
                     Zone zone) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < all.count; ++r) {
      const SurveyRow& row = all.list[r];
      if (row.piece != SurveyRow::side && row.q.rho == 0.0) {
        least = cutter_.alpha > 0.0 && zone != Zone::point ? std::min(least, grid[r][0]) : least;
        continue;
      }
      const bool onCone = cutter_.alpha > 0.0 && row.piece == SurveyRow::bottom;
      const bool apart = row.piece == SurveyRow::side ||
                         (row.piece == SurveyRow::corner && zone != Zone::corner) ||
                         (onCone && zone != Zone::cone);
      for (std::size_t k = 0; k < angles; ++k) {
        if (apart || directions[k].dot(toward) < besideContact) {
          least = std::min(least, grid[r][k]);
        }
      }
    }
    return least;
  }

  /// Distances around a row; infinite where the surface is so far from the axis there that the row
  /// cannot get below `bound`. What is below them then, else infinity.
  double fill(SurveyGrid::Row& values,
              SurveyGrid::Row& slopes,
              const SurveyRow& row,
              const std::array<Vec3, angles>& directions,
              double bound) {
    values.fill(std::numeric_limits<double>::infinity());
    slopes.fill(0.0);
    const double onAxis = side_ * descent_.footAt({0.0, row.q.z}, directions[0]).distance;
    const double lowest = onAxis - std::hypot(row.q.rho, row.halfHeight) - row.ball;
    if (lowest > bound) {
      return lowest;
    }
    for (std::size_t k = 0; k < angles; ++k) {
      if (row.q.rho == 0.0) {
        values[k] = onAxis - row.ball;
        continue;
      }
      const surface::Foot foot = descent_.footAt(row.q, directions[k]);
      values[k] = side_ * foot.distance - row.ball;
      slopes[k] = row.q.rho * side_ * foot.normal.dot(axis_.cross(directions[k]));
    }
    return std::numeric_limits<double>::infinity();
  }

  const S& surface_;
  double side_;
  const Profile& cutter_;
  const Vec3& te_;
  const Vec3& axis_;
  Search<S>& search_;
  ContactDescent<S> descent_;
};

}  // namespace arelem::tool
