#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/geometry/kinds/polyconic_sheet.h"

/// What a POLCON knows of the part of the sheet about a place, by its patches.
namespace arelem::surface {

namespace {
/// Unit normals of one piece are not farther from the middle one, as places: then no way along it
/// need be longer than one and a half times the straight one, as 1 - 0.816^2 / 2 = 1 / 1.5.
constexpr double mostSpread = 0.816;
constexpr double slack = 1.5;
/// Boxes of s and t in which a small part is bounded by itself, and any other where that fails.
constexpr int fewBoxes = 4, mostBoxes = 1000;
/// Of the parts about a patch that are looked at, how much smaller each is than the one before, and
/// how many.
constexpr double smallerPart = 0.8;
constexpr int mostLooks = 20;
}  // namespace

const Polyconic::Sheet::Turned& Polyconic::Sheet::turned(const Number& number) const {
  LateTurned& late = turned_[indexOf(number)];
  std::call_once(late.asked, [&] {
    // Behind the outermost patches the sheet goes on.
    const auto row = static_cast<std::size_t>(number.row);
    const auto column = static_cast<std::size_t>(number.column);
    if (row > 0 && row + 2 < edgesS_.size() && column > 0 && column + 2 < edgesT_.size()) {
      late.turned =
          turnedOver({edgesS_[row], edgesS_[row + 1]}, {edgesT_[column], edgesT_[column + 1]});
    }
  });
  return late.turned;
}

Polyconic::Sheet::Part Polyconic::Sheet::partAbout(const Hull& hull,
                                                   const Number& number,
                                                   double reach,
                                                   double beside) const {
  Part part;
  const Turned& middle = turned(number);
  if (!middle.known) {
    return part;
  }
  Bends near = middle.curvatures;
  Bends all = middle.curvatures;
  part.alone = true;
  const auto widen = [](Bends& a, const Bends& b) {
    a = {std::min(a.low, b.low), std::max(a.high, b.high)};
  };
  const int rows = static_cast<int>(rows_.size());
  const int columns = static_cast<int>(edgesT_.size()) - 1;
  for (int row = 0; row < rows; ++row) {
    if (rows_[static_cast<std::size_t>(row)].squaredFrom(hull) > beside * beside) {
      continue;
    }
    for (int column = 0; column < columns; ++column) {
      const double squared = patches_[indexOf({row, column})].squaredFrom(hull);
      if (squared > beside * beside) {
        continue;
      }
      const Turned& here = turned({row, column});
      const bool isNear = squared <= reach * reach;
      if (!here.known && isNear) {
        return {};
      }
      part.alone = part.alone && here.known &&
                   (here.normal - middle.normal).norm() + here.spread <= mostSpread;
      widen(all, here.curvatures);
      if (isNear) {
        widen(near, here.curvatures);
      }
    }
  }
  part.curvatures = near;
  part.sharpest = std::max(std::abs(all.low), std::abs(all.high));
  return part;
}

/// Two feet of one place are at most `reach` from each other, ways between them one and a half
/// times as far, and no place of these is farther from the next foot than half of that.
Polyconic::Sheet::Part Polyconic::Sheet::about(const Hint& middle, double reach) const {
  const auto byItself = [&](int most) {
    Part part{curvatures(middle, reach, most)};
    if (part.curvatures) {
      part.sharpest = std::max(std::abs(part.curvatures->low), std::abs(part.curvatures->high));
      part.alone = true;
    }
    return part;
  };
  if (Part small = byItself(fewBoxes); small.curvatures) {
    return small;
  }
  Hull place;
  const auto jets = form_.at<double>(middle.s, middle.t, form_.partOf(middle.s),
                                     geometry::Polyconic::along(middle.t));
  place.middle = Vec3(jets[0].value, jets[1].value, jets[2].value);
  const Part part = partAbout(place, numberAt(middle), reach, (1.0 + 0.5 * slack) * reach);
  return part.curvatures && part.alone ? part : byItself(mostBoxes);
}

/// A ball that touches the sheet and is not sharper than the sheet bends towards it holds no place
/// of the piece about the place where it touches, and none at all if it is no larger than that.
void Polyconic::Sheet::lookAround(const Number& number, Surroundings& known) const {
  const Patch& patch = patches_[indexOf(number)];
  double reach = width_;
  for (int i = 0; i < mostLooks && 0.5 * reach > std::min(known.above, known.below); ++i) {
    const Part part = partAbout(patch, number, slack * reach, slack * reach);
    if (part.curvatures && part.alone) {
      known.above =
          std::max(known.above, std::min(0.5 * reach, 1.0 / std::max(0.0, -part.curvatures->low)));
      known.below =
          std::max(known.below, std::min(0.5 * reach, 1.0 / std::max(0.0, part.curvatures->high)));
    }
    reach *= smallerPart;
  }
}

bool Polyconic::Sheet::isNearest(const Vec3& p, const Reached& foot, const Number& number) const {
  Surroundings& known = around_[indexOf(number)];
  std::call_once(known.asked, [&] { lookAround(number, known); });
  const double distance = (p - foot.place.place).dot(normalAt(foot.at.s, foot.place));
  return std::abs(distance) <= (distance > 0.0 ? known.above : known.below);
}

}  // namespace arelem::surface
