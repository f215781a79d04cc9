#pragma once
#include <array>
#include <limits>
#include <numbers>

#include "runtime/tool/contact_descent.h"

/// The general contact: the least side * distance over the whole cutter. Private to runtime/tool.
///
/// A descent from the last contact finds a local minimum. Where the distance is a convex function
/// on this side, it is the least of all if the cutter lies wholly before the plane through the
/// contact square to its normal. Elsewhere the search follows every minimum that it knows and
/// surveys the whole cutter after each stretch of path.
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
      : cutter_(cutter),
        te_(te),
        axis_(axis),
        search_(search),
        known_(search.valid),
        descent_(s, sign, cutter, te, axis, search) {}

  /// `convex`: side * distance is a convex function of the place.
  Contact run(bool convex) {
    const Contact local = descent_.nearestPiece();
    if (convex) {
      return supports(local) ? local : survey(local);
    }
    return known_ && !surveyIsDue() ? bestOfKnown(local) : survey(local);
  }

 private:
  using Minimum = typename Search<S>::Minimum;

  static constexpr double supportSlack = 1e-9;
  /// Share of the cutter's radius that the tool may move from one survey to the next.
  static constexpr double surveyShare = 0.5;
  /// The same for tools without a radius, as a share of the height.
  static constexpr double heightShare = 0.05;
  static constexpr int angles = 16;
  /// Minima whose contacts are nearer than this share of the height are one.
  static constexpr double sameShare = 1e-6;

  /// True where the cutter lies before the plane through the contact square to its normal; a convex
  /// distance lies above the distance from that plane.
  [[nodiscard]] bool supports(const Contact& c) const {
    const double far = reach(cutter_, c.normal.dot(axis_));
    return c.normal.dot(te_ - c.point) >= far - supportSlack * (1.0 + far);
  }

  [[nodiscard]] double moved(const Vec3& te, const Vec3& axis) const {
    return (te_ - te).norm() + cutter_.h * (axis_ - axis).norm();
  }
  /// What the tool may move from one survey to the next.
  [[nodiscard]] double stretch() const {
    return std::max(surveyShare * cutter_.maxRadius(), heightShare * cutter_.h);
  }
  [[nodiscard]] bool surveyIsDue() const {
    return moved(search_.surveyedAt, search_.surveyedAxis) > stretch();
  }

  // ---- the minima that are known --------------------------------------------------------------

  enum Piece { corner, bottom, side };

  Contact descend(int piece, double along) {
    switch (piece) {
      case bottom:
        return descent_.onBottom();
      case side:
        return descent_.onSide(along);
      default:
        return descent_.nearestPiece();
    }
  }

  Minimum minimum(const Contact& c, int piece, double along) const {
    return {search_.toward, search_.hint, c.gap, c.point, te_, axis_, piece, along};
  }
  void resume(const Minimum& m) {
    search_.hint = m.hint;
    descent_.turnTo(m.toward);
  }

  /// A minimum that was m deep when the tool was d away is at most m + d deep now.
  Contact bestOfKnown(const Contact& local) {
    Contact best = local;
    Minimum first = minimum(local, corner, 0.0);
    for (std::size_t i = 0; i < search_.others; ++i) {
      Minimum& other = search_.minima[i];
      if (other.gap - moved(other.toolEnd, other.axis) >= best.gap) {
        continue;
      }
      resume(other);
      const Contact c = descend(other.piece, other.along);
      other = minimum(c, other.piece, other.along);
      if (c.gap < best.gap) {
        best = c;
        // The next descent from the corner goes on from the better one.
        if (other.piece == corner) {
          std::swap(first, other);
        }
      }
    }
    resume(first);
    return best;
  }

  // ---- survey -----------------------------------------------------------------------------------

  struct Row {
    ProfilePoint q;
    double ball = 0.0;
    Piece piece = corner;
    double along = 0.0;       ///< share of the side's length
    double halfHeight = 0.0;  ///< half the distance to the next row
  };
  static constexpr std::size_t mostRows = 8;
  struct Rows {
    std::array<Row, mostRows> list;
    std::size_t count = 0;
    void add(const Row& r) { list[count++] = r; }
  };

  /// The corner stands for its whole arc; pieces without length are left out.
  [[nodiscard]] Rows rows() const {
    Rows rows;
    const ProfilePoint& from = cutter_.sideStart;
    const ProfilePoint& to = cutter_.sideEnd;
    if (!cutter_.ring && cutter_.bottomEnd.rho > 0.0) {
      rows.add({{0.0, 0.0}, 0.0, bottom});
      rows.add({{0.5 * cutter_.bottomEnd.rho, 0.5 * cutter_.bottomEnd.z}, 0.0, bottom});
    }
    rows.add({{cutter_.e, cutter_.f}, cutter_.r, corner});
    if (to.z > from.z) {
      for (const double s : {0.25, 0.5, 0.75, 1.0}) {
        rows.add({{from.rho + s * (to.rho - from.rho), from.z + s * (to.z - from.z)},
                  0.0,
                  side,
                  s,
                  0.125 * (to.z - from.z)});
      }
    }
    return rows;
  }

  using Grid = std::array<std::array<double, angles>, mostRows>;

  /// The lowest of its neighbors; of equal ones the first.
  static bool isLow(const Grid& grid, std::size_t count, std::size_t row, int k) {
    for (int dr = -1; dr <= 1; ++dr) {
      const auto r = static_cast<std::size_t>(static_cast<int>(row) + dr);
      for (int dk = -1; dk <= 1 && r < count; ++dk) {
        const int neighbor = (k + dk + angles) % angles;
        const bool before = r < row || (r == row && neighbor < k);
        const double value = grid[r][static_cast<std::size_t>(neighbor)];
        const double here = grid[row][static_cast<std::size_t>(k)];
        if ((dr != 0 || dk != 0) && (before ? value <= here : value < here)) {
          return false;
        }
      }
    }
    return true;
  }

  /// Descends from every low place of a grid over the whole cutter.
  Contact survey(const Contact& local) {
    constexpr double step = 2.0 * std::numbers::pi / angles;
    const Rows all = rows();
    std::array<Vec3, angles> directions;
    for (int k = 0; k < angles; ++k) {
      directions[static_cast<std::size_t>(k)] = descent_.direction(step * k);
    }
    Contact best = local;
    Minimum first = minimum(local, corner, 0.0);
    Grid grid;
    for (std::size_t r = 0; r < all.count; ++r) {
      fill(grid[r], all.list[r], directions, best.gap + 2.0 * stretch());
    }
    search_.others = 0;
    for (std::size_t r = 0; r < all.count; ++r) {
      for (int k = 0; k < angles; ++k) {
        if (isLow(grid, all.count, r, k)) {
          const Row& row = all.list[r];
          descent_.turnTo(directions[static_cast<std::size_t>(k)]);
          const Contact c = descend(row.piece, row.along);
          keep(minimum(c, row.piece, row.along), first);
          best = c.gap < best.gap ? c : best;
        }
      }
    }
    resume(first);
    search_.surveyedAt = te_;
    search_.surveyedAxis = axis_;
    return best;
  }

  /// Distances around a row; infinite where the surface is so far from the axis there that the row
  /// cannot get below `bound`.
  void fill(std::array<double, angles>& values,
            const Row& row,
            const std::array<Vec3, angles>& directions,
            double bound) {
    values.fill(std::numeric_limits<double>::infinity());
    const double onAxis = descent_.valueAt({0.0, row.q.z}, directions[0]);
    if (onAxis - std::hypot(row.q.rho, row.halfHeight) - row.ball > bound) {
      return;
    }
    for (std::size_t k = 0; k < angles; ++k) {
      values[k] =
          row.q.rho == 0.0 ? onAxis - row.ball : descent_.valueAt(row.q, directions[k]) - row.ball;
    }
  }

  /// The best to which a descent from the corner leads stands in `first`, the others in the list.
  void keep(Minimum m, Minimum& first) {
    const double same = sameShare * (1.0 + cutter_.h);
    bool known = (first.point - m.point).norm() <= same;
    for (std::size_t i = 0; i < search_.others; ++i) {
      known = known || (search_.minima[i].point - m.point).norm() <= same;
    }
    if (known) {
      return;
    }
    if (m.piece == corner && m.gap < first.gap) {
      std::swap(first, m);
    }
    if (search_.others < search_.minima.size()) {
      search_.minima[search_.others++] = m;
    } else {
      const auto highest =
          std::max_element(search_.minima.begin(), search_.minima.end(),
                           [](const auto& a, const auto& c) { return a.gap < c.gap; });
      *highest = highest->gap > m.gap ? m : *highest;
    }
  }

  const Profile& cutter_;
  const Vec3& te_;
  const Vec3& axis_;
  Search<S>& search_;
  bool known_;
  ContactDescent<S> descent_;
};

}  // namespace arelem::tool
