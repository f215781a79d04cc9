#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "runtime/geometry/kinds/polyconic_sheet.h"

/// Which of the feet of a point on a POLCON is the nearest.
namespace arelem::surface {

namespace {
constexpr double unbounded = std::numeric_limits<double>::infinity();
/// Patches of each half of the range of s, and of that of t.
constexpr int patchesOfS = 16;
constexpr int patchesOfT = 12;
/// Patches beyond the ends: their borders, in ranges from there.
constexpr std::array beyond{0.25, 1.0, 4.0, 16.0};
/// Feet nearer than the best by less than this share of its distance are as near.
constexpr double asNear = 1e-12;
/// Patches from which a foot is looked for.
constexpr std::size_t mostStarts = 16;
constexpr int noPatch = -2;

/// Borders of patches over a range and beyond it, as far as from `least` to `most`.
std::vector<double> bordersOf(double low, double high, int parts, double least, double most) {
  std::vector<double> borders;
  for (auto step = beyond.rbegin(); step != beyond.rend(); ++step) {
    borders.push_back(std::max(least, low - *step));
  }
  for (int i = 0; i <= parts; ++i) {
    borders.push_back(low + (high - low) * i / parts);
  }
  for (const double step : beyond) {
    borders.push_back(std::min(most, high + step));
  }
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

int patchAt(const std::vector<double>& borders, double x) {
  const auto next = std::upper_bound(borders.begin() + 1, borders.end() - 1, x);
  return static_cast<int>(next - borders.begin()) - 1;
}
}  // namespace

Polyconic::Sheet::Sheet(const geometry::Polyconic& form)
    : form_(form),
      mirrored_(form.rows.determinant() < 0.0 ? -1.0 : 1.0),
      properLow_(form.properEnd(geometry::Polyconic::Part::before)),
      properHigh_(form.properEnd(geometry::Polyconic::Part::behind)) {
  const double high = geometry::Polyconic::high;
  findEnds();
  edgesS_ = bordersOf(form.low(), high, form.hasRoots() ? 2 * patchesOfS : patchesOfS, properLow_,
                      properHigh_);
  edgesT_ = bordersOf(0.0, 1.0, patchesOfT, -unbounded, unbounded);
  for (std::size_t i = 0; i + 1 < edgesS_.size(); ++i) {
    for (std::size_t k = 0; k + 1 < edgesT_.size(); ++k) {
      patches_.push_back(patchOver({edgesS_[i], edgesS_[i + 1]}, {edgesT_[k], edgesT_[k + 1]}));
      k == 0 ? rows_.push_back(patches_.back()) : rows_.back().widen(patches_.back());
    }
  }
  alone_ = std::make_unique<std::atomic<double>[]>(patches_.size());
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    alone_[i].store(-1.0, std::memory_order_relaxed);
  }
  Hull all{at(form_.low(), 0.0).place};
  for (const double s : {form_.low(), 0.0, high}) {
    for (const double t : {0.0, 0.5, 1.0}) {
      all.widen({at(s, t).place});
    }
  }
  width_ = 2.0 * all.half.norm();
  turned_ = std::make_unique<LateTurned[]>(patches_.size());
  around_ = std::make_unique<Surroundings[]>(patches_.size());
}

Polyconic::Sheet::Number Polyconic::Sheet::numberAt(const Hint& at) const {
  return {patchAt(edgesS_, at.s), patchAt(edgesT_, at.t)};
}

double Polyconic::Sheet::squaredAlone(const Number& number) const {
  const int columns = static_cast<int>(edgesT_.size()) - 1;
  const std::size_t here = indexOf(number);
  double least = alone_[here].load(std::memory_order_relaxed);
  if (least >= 0.0) {
    return least;
  }
  least = unbounded;
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    if (!number.isBeside(static_cast<int>(i) / columns, static_cast<int>(i) % columns)) {
      least = std::min(least, patches_[here].squaredFrom(patches_[i]));
    }
  }
  alone_[here].store(least, std::memory_order_relaxed);
  return least;
}

/// By the mean value theorem: intervals of the places themselves are wider.
Polyconic::Sheet::Patch Polyconic::Sheet::patchOver(const Interval& s, const Interval& t) const {
  Patch patch;
  const Hint middle{true, s.middle(), t.middle()};
  const auto center = form_.at<double>(middle.s, middle.t, form_.partOf(middle.s),
                                       geometry::Polyconic::along(middle.t));
  patch.middle = patch.on = Vec3(center[0].value, center[1].value, center[2].value);
  patch.half = Vec3::Constant(unbounded);
  if (const auto range = around(middle, s.half(), t.half())) {
    for (int i = 0; i < 3; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      patch.half[i] = range->s[axis].size() * s.half() + range->t[axis].size() * t.half();
    }
  }
  return patch;
}

/// Patches that are nearer in the middle than all beside them, and may hold a nearer place than is
/// known: where feet may be.
class Polyconic::Sheet::Lows {
 public:
  struct Low {
    double squared = unbounded;  ///< of the distance of the middle
    std::size_t patch = 0;
  };
  void take(const Low& low) {
    if (count_ < mostStarts) {
      list_[count_++] = low;
    }
  }
  /// The nearest first.
  [[nodiscard]] std::span<const Low> sorted() {
    const auto end = list_.begin() + static_cast<std::ptrdiff_t>(count_);
    std::sort(list_.begin(), end, [](const Low& a, const Low& b) {
      return a.squared < b.squared || (a.squared == b.squared && a.patch < b.patch);
    });
    return {list_.begin(), end};
  }

 private:
  std::array<Low, mostStarts> list_;
  std::size_t count_ = 0;
};

/// True where the middle of no patch beside one is nearer to q.
bool Polyconic::Sheet::isLow(const Vec3& q, int row, int column, double squared) const {
  const int rows = static_cast<int>(rows_.size());
  const int columns = static_cast<int>(edgesT_.size()) - 1;
  for (int i = std::max(0, row - 1); i <= std::min(rows - 1, row + 1); ++i) {
    for (int k = std::max(0, column - 1); k <= std::min(columns - 1, column + 1); ++k) {
      if ((q - patches_[static_cast<std::size_t>(i * columns + k)].on).squaredNorm() < squared) {
        return false;
      }
    }
  }
  return true;
}

Polyconic::Sheet::Lows Polyconic::Sheet::lows(const Vec3& q,
                                              double upper,
                                              const Number& known) const {
  const int columns = static_cast<int>(edgesT_.size()) - 1;
  if (upper == unbounded) {
    // The middles of patches are on the sheet, and beyond by less than rounding is as near.
    for (const Patch& patch : patches_) {
      upper = std::min(upper, (q - patch.on).squaredNorm());
    }
    upper *= 1.0 + asNear;
  }
  Lows found;
  for (int row = 0; row < static_cast<int>(rows_.size()); ++row) {
    if (rows_[static_cast<std::size_t>(row)].squaredFrom(q) >= upper) {
      continue;
    }
    for (int column = 0; column < columns; ++column) {
      const auto number = static_cast<std::size_t>(row * columns + column);
      const Patch& patch = patches_[number];
      // What was gone down from there led to what is known.
      if (known.isBeside(row, column) || patch.squaredFrom(q) >= upper) {
        continue;
      }
      const double squared = (q - patch.on).squaredNorm();
      if (isLow(q, row, column, squared)) {
        found.take({squared, number});
      }
    }
  }
  return found;
}

Polyconic::Sheet::Reached Polyconic::Sheet::nearest(const Vec3& p, const Reached* known) const {
  const bool isKnown = known != nullptr && isProper(known->at.s);
  const Number number = isKnown ? numberAt(known->at) : Number{noPatch, noPatch};
  double best = isKnown ? (p - known->place.place).squaredNorm() : unbounded;
  // All that is nearer is at most twice as far from the foot.
  if (isKnown && (4.0 * best <= squaredAlone(number) || isNearest(p, *known, number))) {
    return *known;
  }
  best *= 1.0 - asNear;
  const Vec3 q = form_.rows * p + form_.shift;
  const std::size_t columns = edgesT_.size() - 1;
  Lows found = lows(q, best, number);
  Reached result = known != nullptr ? *known : Reached{};
  bool any = known != nullptr;
  for (const Lows::Low& low : found.sorted()) {
    if (patches_[low.patch].squaredFrom(q) >= best) {
      continue;
    }
    const std::size_t row = low.patch / columns;
    const std::size_t column = low.patch % columns;
    const Reached there = descend(p, {true, 0.5 * (edgesS_[row] + edgesS_[row + 1]),
                                      0.5 * (edgesT_[column] + edgesT_[column + 1])});
    const double squared = (p - there.place.place).squaredNorm();
    if (!any || (there.found && isProper(there.at.s) && squared < best)) {
      best = there.found && isProper(there.at.s) ? squared * (1.0 - asNear) : best;
      result = there;
      any = true;
    }
  }
  return result;
}

}  // namespace arelem::surface
