#include "runtime/motion/facets/upright_list.h"

#include <algorithm>
#include <limits>

namespace arelem::motion {

namespace {
constexpr double nowhere = -std::numeric_limits<double>::infinity();

/// After this many normals it is looked whether they are enough.
constexpr std::size_t fewNormals = 3;

}  // namespace

UprightList::UprightList(const FacetTask& task, const tool::UprightProfile& profile)
    : task_(task),
      bounds_(profile, task.cutter->maxRadius() + std::max(task.low, 0.0)),
      across_(task.section.up.cross(task.section.along)),
      upright_(task.section.up == Vec3::UnitZ()) {}

Vec3 UprightList::turned(const Vec3& d) const {
  if (upright_) {
    return {task_.section.along.x() * d.x() + task_.section.along.y() * d.y(),
            across_.x() * d.x() + across_.y() * d.y(), d.z()};
  }
  return {task_.section.along.dot(d), across_.dot(d), task_.section.up.dot(d)};
}

Vec3 UprightList::local(const Vec3& place) const {
  return turned(place - task_.section.origin);
}

UprightList::Line UprightList::line(std::uint32_t index, const Vec3& normal) const {
  return bounds_.lineOf(all_[index].facet, Normal::of(normal));
}

double UprightList::known(std::uint32_t index, double s) const {
  return std::min(all_[index].lines[0].at(s), all_[index].lines[1].at(s));
}

/// Takes the triangles that the line for one normal does not exclude.
class UprightList::Collect {
 public:
  Collect(UprightList& list, const Way& way, std::size_t limit)
      : list_(list),
        doubt_(way),
        middle_(0.5 * (way.from.s + way.to.s)),
        half_(0.5 * (way.to.s - way.from.s)),
        lowest_(std::min(way.from.z, way.to.z) - way.slab + list.bounds_.profile().f -
                list.bounds_.profile().r),
        limit_(limit),
        upright_(list.upright_),
        along_(list.task_.section.along),
        up_(list.task_.section.up),
        share_(along_.cwiseAbs()) {}

  bool enters(const Vec3& center, const Vec3& half) {
    const Vec3 w = center - list_.task_.section.origin;
    const double z = upright_ ? w.z() : up_.dot(w);
    const double hz = upright_ ? half.z() : up_.cwiseAbs().dot(half);
    if (full || z + hz < lowest_) {
      return false;
    }
    const double y = upright_ ? along_.x() * w.y() - along_.y() * w.x() : list_.across_.dot(w);
    const double hy = upright_ ? share_.x() * half.y() + share_.y() * half.x()
                               : list_.across_.cwiseAbs().dot(half);
    const double radius = list_.bounds_.radius();
    if (std::abs(y) - hy > radius) {
      return false;
    }
    const double x = (upright_ ? along_.x() * w.x() + along_.y() * w.y() : along_.dot(w)) - middle_;
    const double hx = upright_ ? share_.x() * half.x() + share_.y() * half.y() : share_.dot(half);
    const double out = x - std::clamp(x, -half_, half_);
    const double distance = std::sqrt(out * out + y * y);
    if (distance * (distance - radius) > std::abs(out) * hx + std::abs(y) * hy) {
      return false;
    }
    const auto towards = [&](double beside) {
      const Normal n = list_.bounds_.normalTowards(x - beside, y);
      return list_.bounds_.lineOf(n.n.x() * (x + middle_) + n.n.y() * y + n.n.z() * z +
                                      std::abs(n.n.x()) * hx + std::abs(n.n.y()) * hy +
                                      n.n.z() * hz,
                                  n);
    };
    const Line line = towards(0.0);
    if (doubt_.isInMiddle(line, middle_)) {
      return true;
    }
    Doubt doubt = doubt_;
    return !doubt.isSettled(line) && !doubt.isSettled(towards(-half_)) &&
           !doubt.isSettled(towards(half_));
  }
  void visit(std::size_t i) {
    if (full) {
      return;
    }
    const surface::MeshShape& shape = list_.task_.mesh->shape();
    own_.facet.corners = {list_.local(shape.mesh.corner(i, 0)),
                          list_.local(shape.mesh.corner(i, 1)),
                          list_.local(shape.mesh.corner(i, 2))};
    if (list_.bounds_.isBeside(own_.facet, middle_, half_)) {
      return;
    }
    const Vec3 up = list_.turned(shape.normals[i]);
    own_.facet.up = up.z() < 0.0 ? Vec3(-up) : up;
    const auto& c = own_.facet.corners;
    const double x = (c[0].x() + c[1].x() + c[2].x()) / 3.0 - middle_;
    const double y = (c[0].y() + c[1].y() + c[2].y()) / 3.0;
    const auto towards = [&](double beside) {
      return list_.bounds_.lineOf(own_.facet,
                                  list_.bounds_.normalTowards(x - beside, y, own_.facet.up));
    };
    Doubt doubt = doubt_;
    own_.lines[0] = own_.lines[1] = towards(0.0);
    if (doubt.isSettled(own_.lines[0])) {
      return;
    }
    if (own_.facet.up.z() >= UprightBounds::usefulRise) {
      own_.lines[1] = list_.bounds_.lineOf(own_.facet, Normal::of(own_.facet.up));
    }
    if (doubt.isSettled(own_.lines[1])) {
      return;
    }
    const bool certain = list_.bounds_.isSharp() || (doubt_.isInMiddle(own_.lines[0], middle_) &&
                                                     doubt_.isInMiddle(own_.lines[1], middle_));
    if (certain || (!doubt.isSettled(towards(-half_)) && !doubt.isSettled(towards(half_)))) {
      own_.number = static_cast<std::uint32_t>(i);
      list_.all_.push_back(own_);
      full = list_.all_.size() >= limit_;
    }
  }

 private:
  using Doubt = UprightBounds::Doubt;

  UprightList& list_;
  Doubt doubt_;
  double middle_, half_, lowest_;
  std::size_t limit_;
  bool upright_;
  Vec3 along_, up_, share_;  ///< of the section; how far boxes reach along it
  Own own_;

 public:
  bool full = false;
};

bool UprightList::gather(const Way& way, std::size_t limit) {
  all_.clear();
  near_.clear();
  rounds_ = 0;
  Collect search(*this, way, limit);
  task_.mesh->shape().tree.search(search);
  return !search.full;
}

/// Whether the cutter comes to a triangle at all. Those that it covers all the way need no range.
bool UprightList::reaches(Own& own, const Way& way) {
  const double middle = 0.5 * (way.from.s + way.to.s);
  const double half = 0.5 * (way.to.s - way.from.s);
  if (!own.hasRange) {
    if (bounds_.isBeside(own.facet, middle, half)) {
      return false;
    }
    if (bounds_.covers(own.facet, middle, half)) {
      own.range = {nowhere, -nowhere};
      return true;
    }
    own.range = bounds_.rangeOf(own.facet);
    own.hasRange = true;
  }
  return own.range.first <= way.to.s && own.range.last >= way.from.s;
}

void UprightList::focus(const Way& way) {
  const double middle = 0.5 * (way.from.s + way.to.s);
  near_.clear();
  for (std::uint32_t i = 0; i < all_.size(); ++i) {
    Own& own = all_[i];
    if (own.isBelow(way) || !reaches(own, way)) {
      continue;
    }
    const auto& c = own.facet.corners;
    const double x = (c[0].x() + c[1].x() + c[2].x()) / 3.0 - middle;
    const double y = (c[0].y() + c[1].y() + c[2].y()) / 3.0;
    own.lines[0] = bounds_.lineOf(own.facet, bounds_.normalTowards(x, y, own.facet.up));
    if (!own.lines[0].isBelow(way)) {
      near_.push_back(i);
    }
  }
  fill();
}

void UprightList::fill() {
  const std::size_t count = near_.size();
  for (auto& coordinates : corners_) {
    coordinates.resize(count);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    base_[k].resize(count);
    slope_[k].resize(count);
  }
  first_.resize(count);
  last_.resize(count);
  for (auto& bases : bases_) {
    bases.resize(count);
  }
  for (std::size_t j = 0; j < count; ++j) {
    const Own& own = all_[near_[j]];
    for (std::size_t k = 0; k < 9; ++k) {
      corners_[k][j] = own.facet.corners[k / 3][static_cast<Eigen::Index>(k % 3)];
    }
    for (std::size_t k = 0; k < 2; ++k) {
      base_[k][j] = own.lines[k].base;
      slope_[k][j] = own.lines[k].slope;
    }
    first_[j] = own.range.first;
    last_[j] = own.range.last;
  }
  rounds_ = 0;
}

/// The lines of one more normal, in place of the oldest.
void UprightList::sweep(const Vec3& n) {
  const std::size_t round = rounds_++ % kept;
  const double nxy = std::sqrt(n.x() * n.x() + n.y() * n.y());
  const double rise = 1.0 / n.z();
  const double x = n.x() * rise;
  const double y = n.y() * rise;
  const double base = bounds_.profile().support(n.z(), nxy) * rise;
  const auto& c = corners_;
  double* bases = bases_[round].data();
  const std::size_t count = near_.size();
  for (std::size_t j = 0; j < count; ++j) {
    const double a = x * c[0][j] + y * c[1][j] + c[2][j];
    const double b = x * c[3][j] + y * c[4][j] + c[5][j];
    const double d = x * c[6][j] + y * c[7][j] + c[8][j];
    const double most = a > b ? a : b;
    bases[j] = base + (most > d ? most : d);
  }
  slopes_[round] = -x;
}

void UprightList::addNormal(const Vec3& normal, double s, std::vector<double>& heights) {
  sweep(normal);
  const std::size_t round = (rounds_ - 1) % kept;
  const double more = slopes_[round] * s;
  for (std::size_t j = 0; j < heights.size(); ++j) {
    heights[j] = std::min(heights[j], bases_[round][j] + more);
  }
}

void UprightList::addNormal(const Vec3& normal,
                            const SectionPoint& from,
                            const SectionPoint& to,
                            std::vector<double>& excess) {
  sweep(normal);
  const std::size_t round = (rounds_ - 1) % kept;
  const double slope = slopes_[round];
  const double most = std::min(from.z - slope * from.s, to.z - slope * to.s);
  for (std::size_t j = 0; j < excess.size(); ++j) {
    excess[j] = std::min(excess[j], bases_[round][j] - most);
  }
}

void UprightList::heightsAt(double s, std::vector<double>& heights) const {
  const std::size_t count = near_.size();
  heights.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    const double height = std::min(base_[0][j] + slope_[0][j] * s, base_[1][j] + slope_[1][j] * s);
    heights[j] = s < first_[j] || s > last_[j] ? nowhere : height;
  }
  for (std::size_t round = 0; round < std::min(rounds_, kept); ++round) {
    const double more = slopes_[round] * s;
    const double* bases = bases_[round].data();
    for (std::size_t j = 0; j < count; ++j) {
      heights[j] = std::min(heights[j], bases[j] + more);
    }
  }
}

void UprightList::excessOver(const SectionPoint& from,
                             const SectionPoint& to,
                             std::vector<double>& excess) const {
  const std::size_t count = near_.size();
  excess.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    const double first =
        base_[0][j] + std::max(slope_[0][j] * from.s - from.z, slope_[0][j] * to.s - to.z);
    const double second =
        base_[1][j] + std::max(slope_[1][j] * from.s - from.z, slope_[1][j] * to.s - to.z);
    excess[j] = to.s < first_[j] || from.s > last_[j] ? nowhere : std::min(first, second);
  }
  // The last normals are those of places around.
  const std::size_t rounds = std::min(rounds_, kept);
  for (std::size_t back = 1; back <= rounds; ++back) {
    const std::size_t round = (rounds_ - back) % kept;
    const double slope = slopes_[round];
    const double most = std::min(from.z - slope * from.s, to.z - slope * to.s);
    const double* bases = bases_[round].data();
    for (std::size_t j = 0; j < count; ++j) {
      excess[j] = std::min(excess[j], bases[j] - most);
    }
    if (back == fewNormals && *std::max_element(excess.begin(), excess.end()) <= 0.0) {
      return;
    }
  }
}

}  // namespace arelem::motion
