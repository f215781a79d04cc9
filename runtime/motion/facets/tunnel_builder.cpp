#include "runtime/motion/facets/tunnel_builder.h"

#include <algorithm>
#include <cmath>

#include "runtime/motion/facets/gap_heights.h"
#include "runtime/motion/facets/upright_heights.h"

namespace arelem::motion {

namespace {
/// Shares of the band: what the tunnel is narrower at each edge, the largest corner of a bottom,
/// and the rest of heights.
constexpr double spareShare = 0.005;
constexpr double bentShare = 0.1;
constexpr double restShare = 1e-4;
/// Corners of this share of what is spared are none.
constexpr double straightShare = 0.25;
/// Lengths of the lists, in lengths of a cut vector, at the beginning.
constexpr double wideReach = 4.0;
constexpr double nearReach = 0.5;
constexpr double stepReach = 0.125;
/// Cells shorter than this share of a cut vector are a wall or a cliff.
constexpr double leastReach = 1e-4;
constexpr int deepest = 40;
/// Lists are made longer or shorter until they hold between so many.
struct Counts {
  std::size_t few, many, fewNear, manyNear;
};
/// Those that are right at any height cost little for each triangle; slabs that are too thin or too
/// short cost searches of the tree.
constexpr Counts ofPlaces{60, 130, 6, 14};
constexpr Counts ofSlabs{100, 220, 30, 60};
constexpr std::size_t most = 4000;
constexpr double growth = 1.4;
constexpr double firstWide = 0.06, firstNear = 0.01;
constexpr double mostShare = 4.0;
/// Slabs are made this much higher than the last one had to be.
constexpr double roomy = 1.5;
constexpr double firstBands = 6.0;
constexpr double slabBands = 1.5;
/// How often a height is looked for, each time so much farther below.
constexpr int probes = 6;
constexpr double deeper = 4.0;
/// A way that bows by more than this share of half its length meets a wall there.
constexpr double steepest = 0.25;
constexpr double faster = 1.6;
constexpr double slower = 0.8;
/// A rest of a list shorter than this share of a step is no step.
constexpr double remainder = 0.3;

/// The length of the next list, where one of this length had `count` triangles. Short ones do not
/// get smaller for being shorter: what counts is what the cutter is near to in one place.
double better(
    double length, std::size_t count, std::size_t least, std::size_t greatest, double shortest) {
  return count < least                           ? growth * length
         : count > greatest && length > shortest ? length / growth
                                                 : length;
}

std::unique_ptr<HeightSource> sourceOf(const FacetTask& task, double rest) {
  if (auto upright = UprightHeights::of(task, rest)) {
    return upright;
  }
  return std::make_unique<GapHeights>(task, rest);
}
}  // namespace

TunnelBuilder::TunnelBuilder(const FacetTask& task, double reach)
    : task_(task),
      body_(*task.cutter),
      band_(task.high - task.low),
      spare_(spareShare * band_),
      bent_(bentShare * band_),
      heights_(sourceOf(task, restShare * band_)),
      above_(heights_->aboveBands() * band_),
      slab_(slabBands * band_ + above_),
      wide_{{}, wideReach * reach, firstWide / (wideReach * reach)},
      near_{{}, nearReach * reach, firstNear / (nearReach * reach)},
      step_(stepReach * reach),
      least_(leastReach * reach),
      shortest_(reach) {}

bool TunnelBuilder::begin(const SectionPoint& at) {
  tunnel_.clear();
  marks_.clear();
  ended_ = true;
  // A short list to find the first node: it is below the place by the band, along the normal.
  const Way around{
      {at.s - least_, at.z}, {at.s + least_, at.z}, slab_ + firstBands * band_ + least_};
  // The second time lists may be of another kind.
  if (!heights_->gather(around, most) && !heights_->gather(around, most)) {
    return false;
  }
  const auto node = heights_->node(at, Among::wide);
  if (!node || heights_->beside(around, node->point()) > around.slab) {
    return false;
  }
  last_ = *node;
  wide_.way.to.s = near_.way.to.s = at.s;
  ended_ = false;
  return extend();
}

void TunnelBuilder::List::settleBend() {
  bend = std::clamp(roomy * use, 0.5 * bend, 2.0 * bend);
  use = 0.0;
}

void TunnelBuilder::List::shorten(double s) {
  length /= 2.0;
  bend *= 4.0;
  use = bend;
  way.to.s = s;
}

/// The height at a place where it is about `guess`, to foresee the way.
std::optional<double> TunnelBuilder::probe(double s, double guess) {
  std::optional<double> z;
  double below = 0.25 * missed_ + slab_;
  for (int i = 0; i < probes && !z; ++i, below *= deeper) {
    z = heights_->heightAt(s, guess - below);
  }
  missed_ = z ? std::max(std::abs(*z - guess), 0.5 * missed_) : missed_;
  return z;
}

/// A way through three heights, where they are easily found, else straight.
Way TunnelBuilder::ahead(const SectionPoint& here, double slope, double length) {
  const double half = 0.5 * length;
  const Way& last = foreseen_;
  const double bow = last.bow;
  Way way{here, {here.s + length, here.z + slope * length}};
  // Slopes of facets jump, those of the last way do not.
  const double rise = bow == 0.0 ? slope
                                 : (last.to.z - last.from.z) / (last.to.s - last.from.s) +
                                       bow * (2.0 * here.s - last.from.s - last.to.s);
  const auto middle = probe(here.s + half, here.z + half * (rise + half * bow));
  const auto end =
      middle ? probe(way.to.s, 2.0 * *middle - here.z + 2.0 * half * half * bow) : std::nullopt;
  const double lift = end ? 0.5 * (here.z + *end - 2.0 * *middle) : 0.0;
  if (end && std::abs(lift) <= steepest * half) {
    way.to.z = *end;
    way.bow = lift / (half * half);
  }
  foreseen_ = way;
  return way;
}

/// The wide list for the piece of way from the last node on.
bool TunnelBuilder::gather() {
  const SectionPoint here = last_.point();
  const double slope = last_.highest().slope();
  const std::uint32_t highest = heights_->triangle(last_.highest().index);
  wide_.settleBend();
  const bool atAnyHeight = heights_->isOfAnyHeight();
  for (; wide_.length > least_; wide_.length /= 2.0) {
    wide_.way = ahead(here, slope, wide_.length);
    wide_.way.slab = wide_.bend * wide_.length * wide_.length + 2.0 * slab_;
    if (!heights_->gather(wide_.way, most)) {
      continue;
    }
    if (atAnyHeight && !heights_->isOfAnyHeight()) {
      near_.length = std::min(near_.length, nearReach * shortest_);
    }
    if (!resume(highest)) {
      return false;
    }
    const Counts& counts = heights_->isOfAnyHeight() ? ofPlaces : ofSlabs;
    wide_.length =
        better(wide_.length, heights_->count(Among::wide), counts.few, counts.many, shortest_);
    near_.way.to.s = here.s;
    return true;
  }
  return false;
}

/// The last node in a new wide list, in which its triangle has another number.
bool TunnelBuilder::resume(std::uint32_t highest) {
  const std::size_t count = heights_->count(Among::wide);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (heights_->triangle(i) == highest) {
      last_.renumber(i);
      return true;
    }
  }
  const auto node = heights_->node(last_.point(), Among::wide);
  last_ = node.value_or(last_);
  return node.has_value();
}

/// The short list for the next piece of way; false where there is none.
bool TunnelBuilder::focus() {
  near_.settleBend();
  for (;;) {
    if (last_.s >= wide_.way.to.s - least_ && !gather()) {
      return false;
    }
    const SectionPoint here = last_.point();
    const double length = std::min(near_.length, wide_.way.to.s - here.s);
    near_.way = wide_.way;
    near_.way.from = here;
    near_.way.to.s = here.s + length;
    near_.way.slab = near_.bend * length * length + slab_;
    near_.way.to.z = wide_.way.bow == 0.0 ? here.z + last_.highest().slope() * length
                                          : here.z + wide_.way.heightAt(here.s + length) -
                                                wide_.way.heightAt(here.s);
    const double beside =
        std::max(heights_->beside(wide_.way, here), heights_->beside(wide_.way, near_.way.to));
    if (heights_->isOfAnyHeight()) {
      wide_.use = wide_.bend / roomy;
    } else {
      wide_.see(beside + near_.way.slab - slab_);
    }
    if (beside + near_.way.slab > wide_.way.slab) {
      wide_.shorten(here.s);
      if (wide_.share() > mostShare) {
        return false;
      }
      continue;
    }
    heights_->focus(near_.way);
    const Counts& counts = heights_->isOfAnyHeight() ? ofPlaces : ofSlabs;
    near_.length = better(near_.length, heights_->count(Among::near), counts.fewNear,
                          counts.manyNear, nearReach * shortest_);
    return true;
  }
}

bool TunnelBuilder::isInSlab(const TouchNode& node) {
  const double beside = heights_->beside(near_.way, node.point());
  if (heights_->isOfAnyHeight()) {
    near_.use = near_.bend / roomy;
    return true;
  }
  near_.see(beside - 0.5 * slab_);
  return beside + above_ <= near_.way.slab;
}

bool TunnelBuilder::extend() {
  const double before = last_.s;
  while (!ended_ && last_.s == before) {
    if (last_.s >= near_.way.to.s - least_ && !focus()) {
      ended_ = true;
      break;
    }
    const double rest = near_.way.to.s - last_.s;
    const bool toEnd = rest < (1.0 + remainder) * step_;
    const double s = toEnd ? near_.way.to.s : last_.s + step_;
    const SectionPoint here = last_.point();
    auto node = heights_->node({s, here.z + last_.highest().slope() * (s - here.s)}, Among::near);
    const Outcome outcome = node ? settle(last_, *node, 0) : Outcome::ends;
    if (outcome == Outcome::outside) {
      near_.shorten(last_.s);
      ended_ = near_.share() > mostShare;
    } else if (outcome == Outcome::ends) {
      step_ /= 4.0;
      ended_ = step_ < least_;
    }
  }
  return last_.s > before;
}

/// The triangle whose heights at both ends are the node's but for what may be spared.
std::optional<std::uint32_t> TunnelBuilder::witness(TouchNode& a, TouchNode& b) {
  const std::uint32_t i = a.highest().index;
  const std::uint32_t k = b.highest().index;
  if (i == k || heights_->nearTop(b, i, spare_)) {
    return i;
  }
  return heights_->nearTop(a, k, spare_) ? std::optional(k) : std::nullopt;
}

/// Below both tangents of the triangle that is touched at both ends.
HeightSource::Bottom TunnelBuilder::bottomOf(TouchNode& a, TouchNode& b, std::uint32_t i) const {
  const TouchHeight& first = *a.of(i);
  const TouchHeight& last = *b.of(i);
  const double length = b.s - a.s;
  // Heights of the tangents, over the heights of touch: nothing but rounding.
  const double over0 = first.tangentHeight(a.s, task_.low) - first.z;
  const double over1 = last.tangentHeight(b.s, task_.low) - last.z;
  const double mean = (last.z - first.z) / length;
  const double fall0 = first.slope() - mean;
  const double fall1 = mean - last.slope();
  const double turn = fall0 + fall1;
  const double share = turn > 0.0 ? std::clamp(fall1 / turn, 0.0, 1.0) : 0.5;
  const double rise = std::max(over0, over1) +
                      std::max(0.0, length * std::min(fall0 * share, fall1 * (1.0 - share)));
  Bottom bottom{{a.s, a.point().z + spare_}, {}, {b.s, b.point().z + spare_}, 0.0};
  bottom.corner.s = a.s + (share > 0.0 && share < 1.0 ? share : 0.5) * length;
  bottom.corner.z = heightOn(bottom.from, bottom.to, bottom.corner.s);
  if (rise > straightShare * spare_) {
    bottom.rise = rise;
    bottom.corner.z += rise;
  }
  return bottom;
}

void TunnelBuilder::emit(TouchNode& a, TouchNode& b, const Bottom& bottom, std::uint32_t i) {
  const double before = heights_->top(a.s, *a.of(i));
  if (tunnel_.empty()) {
    tunnel_.addBottom(bottom.from);
    tunnel_.addTop({a.s, before});
    marks_.push_back({a.s, heights_->triangle(i)});
  }
  tunnel_.lowerTop(before);
  if (bottom.rise > 0.0) {
    tunnel_.addBottom(bottom.corner);
  }
  tunnel_.addBottom(bottom.to);
  tunnel_.addTop({b.s, heights_->top(b.s, *b.of(i))});
  marks_.push_back({b.s, heights_->triangle(b.highest().index)});
}

TunnelBuilder::Outcome TunnelBuilder::divide(TouchNode& a, TouchNode& b, double s, int depth) {
  const double edge = 0.05 * (b.s - a.s);
  s = std::clamp(s, a.s + edge, b.s - edge);
  if (depth >= deepest || b.s - a.s <= least_) {
    return Outcome::ends;
  }
  const SectionPoint guess{s, heightOn(a.point(), b.point(), s)};
  auto middle = heights_->node(guess, Among::near);
  if (!middle) {
    return Outcome::ends;
  }
  if (depth == 0) {
    step_ *= slower;
  }
  const Outcome first = settle(a, *middle, depth + 1);
  return first == Outcome::done ? settle(*middle, b, depth + 1) : first;
}

TunnelBuilder::Outcome TunnelBuilder::settle(TouchNode& a, TouchNode& b, int depth) {
  if (!isInSlab(b)) {
    return Outcome::outside;
  }
  const auto i = witness(a, b);
  if (!i) {
    // Where the two tangents cross: the ridge or the valley between two triangles.
    const double turn = a.highest().slope() - b.highest().slope();
    const double ahead = b.point().z - a.point().z - b.highest().slope() * (b.s - a.s);
    const double share = turn == 0.0 ? 0.5 : ahead / turn / (b.s - a.s);
    return divide(a, b, a.s + (share > 0.0 && share < 1.0 ? share : 0.5) * (b.s - a.s), depth);
  }
  const Bottom bottom = bottomOf(a, b, *i);
  if (bottom.rise > bent_) {
    return divide(a, b, bottom.corner.s, depth);
  }
  if (const auto s = heights_->penetration(bottom, *i)) {
    return divide(a, b, *s, depth);
  }
  emit(a, b, bottom, *i);
  if (depth == 0) {
    step_ = std::min(faster * step_, near_.length);
  }
  if (&b != &last_) {
    last_ = b;
  }
  return Outcome::done;
}

void TunnelBuilder::forget(double s) {
  tunnel_.forget(s);
  constexpr std::size_t enough = 512;
  const auto behind = std::lower_bound(marks_.begin(), marks_.end(), s,
                                       [](const Mark& m, double at) { return m.s < at; });
  if (behind - marks_.begin() > static_cast<std::ptrdiff_t>(enough)) {
    marks_.erase(marks_.begin(), behind - 1);
  }
}

tool::TriangleGap TunnelBuilder::touchAt(const SectionPoint& p) const {
  auto behind = std::lower_bound(marks_.begin(), marks_.end(), p.s,
                                 [](const Mark& m, double at) { return m.s < at; });
  behind = behind == marks_.end() ? behind - 1 : behind;
  const tool::PlacedBody body(body_, task_.section.at(p), task_.axis);
  const auto gapTo = [&](std::size_t triangle) {
    const surface::MeshShape& shape = task_.mesh->shape();
    return tool::gapOf(body, {shape.mesh.corner(triangle, 0), shape.mesh.corner(triangle, 1),
                              shape.mesh.corner(triangle, 2), shape.normals[triangle]});
  };
  tool::TriangleGap best = gapTo(behind->triangle);
  if (behind != marks_.begin() && (behind - 1)->triangle != behind->triangle) {
    const tool::TriangleGap other = gapTo((behind - 1)->triangle);
    best = other.gap < best.gap ? other : best;
  }
  return best;
}

}  // namespace arelem::motion
