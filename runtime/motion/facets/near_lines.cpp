#include "runtime/motion/facets/near_lines.h"

#include <algorithm>

namespace arelem::motion {

namespace {
/// After this many normals it is looked whether they are enough.
constexpr std::size_t fewNormals = 3;
}  // namespace

void NearLines::clear() {
  count_ = used_ = rounds_ = 0;
}

void NearLines::add(const tool::UprightFacet& facet,
                    const std::array<Line, 2>& own,
                    const UprightBounds::Range& range) {
  const std::size_t lane = count_++ % lanes;
  if (lane == 0) {
    if (++used_ > blocks_.size()) {
      blocks_.emplace_back();
    }
    blocks_[used_ - 1].base.fill(Lanes::Constant(nowhere));
  }
  Block& block = blocks_[used_ - 1];
  const auto j = static_cast<Eigen::Index>(lane);
  for (std::size_t k = 0; k < own.size(); ++k) {
    block.base[k][j] = own[k].base;
    block.slope[k][j] = own[k].slope;
  }
  block.first[j] = range.first;
  block.last[j] = range.last;
  for (std::size_t k = 0; k < block.corners.size(); ++k) {
    block.corners[k][j] = facet.corners[k / 3][static_cast<Eigen::Index>(k % 3)];
  }
}

/// Triangles that are not touched there: mostly none.
void NearLines::leaveOut(const Block& block, double from, double to, Lanes& values) {
  const Lanes beside = (block.first - to).max(from - block.last);
  if (beside.maxCoeff() <= 0.0) {
    return;
  }
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    values[j] = beside[j] > 0.0 ? nowhere : values[j];
  }
}

/// The lines of one more normal, in place of the oldest; lowers values to them, but for what is
/// `more` by their slope.
template <class More>
void NearLines::sweep(const Vec3& n, const More& more, std::vector<double>& values) {
  const std::size_t round = rounds_++ % kept;
  const double nxy = std::sqrt(n.x() * n.x() + n.y() * n.y());
  const double rise = 1.0 / n.z();
  const double x = n.x() * rise;
  const double y = n.y() * rise;
  const double base = bounds_.profile().support(n.z(), nxy) * rise;
  slopes_[round] = -x;
  const double besides = more(slopes_[round]);
  double* value = values.data();
  for (Block& block : used()) {
    const auto& c = block.corners;
    const Lanes a = x * c[0] + y * c[1] + c[2];
    const Lanes b = x * c[3] + y * c[4] + c[5];
    const Lanes d = x * c[6] + y * c[7] + c[8];
    const Lanes bases = base + a.max(b).max(d);
    block.bases[round] = bases;
    auto lowered = Lanes::Map(value);
    lowered = lowered.min(bases + besides);
    value += lanes;
  }
}

void NearLines::addNormal(const Vec3& normal, double s, std::vector<double>& heights) {
  sweep(
      normal, [&](double slope) { return slope * s; }, heights);
}

void NearLines::addNormal(const Vec3& normal,
                          const SectionPoint& from,
                          const SectionPoint& to,
                          std::vector<double>& excess) {
  sweep(
      normal, [&](double slope) { return over(slope, from, to); }, excess);
}

void NearLines::heightsAt(double s, std::vector<double>& heights) const {
  heights.resize(lanes * used_);
  const std::size_t rounds = std::min(rounds_, kept);
  double* value = heights.data();
  for (const Block& block : used()) {
    Lanes height = (block.base[0] + block.slope[0] * s).min(block.base[1] + block.slope[1] * s);
    leaveOut(block, s, s, height);
    for (std::size_t round = 0; round < rounds; ++round) {
      height = height.min(block.bases[round] + slopes_[round] * s);
    }
    Lanes::Map(value) = height;
    value += lanes;
  }
}

void NearLines::excessOver(const SectionPoint& from,
                           const SectionPoint& to,
                           std::vector<double>& excess) const {
  excess.resize(lanes * used_);
  // The last normals are those of places around.
  std::array<double, fewNormals> overs{};
  std::array<std::size_t, fewNormals> last{};
  const std::size_t few = std::min(rounds_, fewNormals);
  for (std::size_t back = 0; back < few; ++back) {
    last[back] = (rounds_ - back - 1) % kept;
    overs[back] = over(slopes_[last[back]], from, to);
  }
  Lanes most = Lanes::Constant(nowhere);
  double* value = excess.data();
  for (const Block& block : used()) {
    const auto own = [&](std::size_t k) -> Lanes {
      const Lanes& slope = block.slope[k];
      return block.base[k] + (slope * from.s - from.z).max(slope * to.s - to.z);
    };
    Lanes above = own(0).min(own(1));
    leaveOut(block, from.s, to.s, above);
    for (std::size_t back = 0; back < few; ++back) {
      above = above.min(block.bases[last[back]] + overs[back]);
    }
    most = most.max(above);
    Lanes::Map(value) = above;
    value += lanes;
  }
  if (few == fewNormals && most.maxCoeff() > 0.0) {
    lowerByOlder(from, to, excess);
  }
}

/// By the normals before the last few.
void NearLines::lowerByOlder(const SectionPoint& from,
                             const SectionPoint& to,
                             std::vector<double>& excess) const {
  for (std::size_t back = fewNormals; back < std::min(rounds_, kept); ++back) {
    const std::size_t round = (rounds_ - back - 1) % kept;
    const double besides = over(slopes_[round], from, to);
    double* value = excess.data();
    for (const Block& block : used()) {
      auto lowered = Lanes::Map(value);
      lowered = lowered.min(block.bases[round] + besides);
      value += lanes;
    }
  }
}

}  // namespace arelem::motion
