#include "runtime/motion/facets/upright_list.h"

#include <algorithm>
#include <limits>

namespace arelem::motion {

namespace {
/// Normals that bound heights are not nearer to level than this, as a sine.
constexpr double mostLevel = 0.97;

constexpr double nowhere = -std::numeric_limits<double>::infinity();
/// Own normals of triangles that are nearer to level tell little.
constexpr double usefulRise = 0.05;

bool isBelow(const UprightList::Line& line, const Way& way) {
  return line.at(way.from.s) < way.from.z - way.slab && line.at(way.to.s) < way.to.z - way.slab;
}
double greatest(const tool::UprightFacet& f, const Vec3& n) {
  return std::max({n.dot(f.corners[0]), n.dot(f.corners[1]), n.dot(f.corners[2])});
}
}  // namespace

UprightList::UprightList(const FacetTask& task, const tool::UprightProfile& profile)
    : task_(task),
      profile_(profile),
      across_(task.section.up.cross(task.section.along)),
      radius_(task.cutter->maxRadius() + std::max(task.low, 0.0)) {}

bool UprightList::Own::isBelow(const Way& way) const {
  return first > way.to.s || last < way.from.s || motion::isBelow(lines[0], way) ||
         motion::isBelow(lines[1], way);
}

/// No place of a triangle is nearer to the section than its nearest corner's y says.
void UprightList::setRange(Own& own) const {
  const auto& c = own.facet.corners;
  const double left = std::max({c[0].y(), c[1].y(), c[2].y()});
  const double right = std::min({c[0].y(), c[1].y(), c[2].y()});
  const double beside = std::max({-left, right, 0.0});
  const double half = std::sqrt(std::max(0.0, radius_ * radius_ - beside * beside));
  own.first = beside > radius_ ? -nowhere : std::min({c[0].x(), c[1].x(), c[2].x()}) - half;
  own.last = beside > radius_ ? nowhere : std::max({c[0].x(), c[1].x(), c[2].x()}) + half;
}

Vec3 UprightList::turned(const Vec3& d) const {
  return {task_.section.along.dot(d), across_.dot(d), task_.section.up.dot(d)};
}

Vec3 UprightList::local(const Vec3& place) const {
  return turned(place - task_.section.origin);
}

/// The normal with which the cutter would touch a place there, seen from its axis.
Vec3 UprightList::normalTowards(double x, double y) const {
  const double rho = std::sqrt(x * x + y * y);
  const double beyond = rho - profile_.e;
  const double flattest = std::min(mostLevel, profile_.cosBeta);
  if (beyond <= 0.0 || (profile_.r == 0.0 && profile_.sinBeta <= 0.0)) {
    return Vec3::UnitZ();
  }
  const double nxy = beyond < profile_.r * flattest ? beyond / profile_.r : flattest;
  return {-nxy * x / rho, -nxy * y / rho, std::sqrt(1.0 - nxy * nxy)};
}

UprightList::Line UprightList::lineOf(double most, const Vec3& n) const {
  const double nxy = std::sqrt(n.x() * n.x() + n.y() * n.y());
  return {(most + profile_.support(n.z(), nxy)) / n.z(), -n.x() / n.z()};
}

UprightList::Line UprightList::line(std::uint32_t index, const Vec3& normal) const {
  return lineOf(greatest(all_[index].facet, normal), normal);
}

double UprightList::known(std::uint32_t index, double s) const {
  return std::min(all_[index].lines[0].at(s), all_[index].lines[1].at(s));
}

/// For the normal with which the cutter at s would touch the middle of a triangle.
UprightList::Line UprightList::lineTowards(const tool::UprightFacet& f, double s) const {
  const Vec3 middle = (f.corners[0] + f.corners[1] + f.corners[2]) / 3.0;
  const Vec3 n = normalTowards(middle.x() - s, middle.y());
  return lineOf(greatest(f, n), n);
}

/// Takes the triangles that the line for one normal does not exclude.
class UprightList::Collect {
 public:
  Collect(UprightList& list, const Way& way, std::size_t limit)
      : list_(list),
        way_(way),
        middle_(0.5 * (way.from.s + way.to.s)),
        half_(0.5 * (way.to.s - way.from.s)),
        lowest_(std::min(way.from.z, way.to.z) - way.slab + list.profile_.f - list.profile_.r),
        limit_(limit) {
    shares_.row(0) = list.task_.section.along.cwiseAbs();
    shares_.row(1) = list.across_.cwiseAbs();
    shares_.row(2) = list.task_.section.up.cwiseAbs();
  }

  bool enters(const Vec3& center, const Vec3& half) {
    const Vec3 c = list_.local(center);
    const Vec3 h = shares_ * half;
    const double x = c.x() - middle_;
    const double ahead = std::max(std::abs(x) - h.x() - half_, 0.0);
    const double beside = std::max(std::abs(c.y()) - h.y(), 0.0);
    if (full || c.z() + h.z() < lowest_ ||
        ahead * ahead + beside * beside > list_.radius_ * list_.radius_) {
      return false;
    }
    const Vec3 n = list_.normalTowards(x, c.y());
    return !isBelow(list_.lineOf(n.dot(c) + n.cwiseAbs().dot(h), n), way_);
  }
  void visit(std::size_t i) {
    if (full) {
      return;
    }
    const surface::MeshShape& shape = list_.task_.mesh->shape();
    const Vec3 up = list_.turned(shape.normals[i]);
    Own own;
    own.number = static_cast<std::uint32_t>(i);
    own.facet = {{list_.local(shape.mesh.corner(i, 0)), list_.local(shape.mesh.corner(i, 1)),
                  list_.local(shape.mesh.corner(i, 2))},
                 up.z() < 0.0 ? Vec3(-up) : up};
    list_.setRange(own);
    own.lines[0] = list_.lineTowards(own.facet, middle_);
    own.lines[1] = own.facet.up.z() < usefulRise
                       ? own.lines[0]
                       : list_.lineOf(greatest(own.facet, own.facet.up), own.facet.up);
    if (!own.isBelow(way_)) {
      list_.all_.push_back(own);
      full = list_.all_.size() >= limit_;
    }
  }

 private:
  UprightList& list_;
  const Way& way_;
  double middle_, half_, lowest_;
  std::size_t limit_;
  Eigen::Matrix3d shares_;

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

void UprightList::focus(const Way& way) {
  const double middle = 0.5 * (way.from.s + way.to.s);
  near_.clear();
  for (std::uint32_t i = 0; i < all_.size(); ++i) {
    Own& own = all_[i];
    if (!own.isBelow(way)) {
      own.lines[0] = lineTowards(own.facet, middle);
      if (!own.isBelow(way)) {
        near_.push_back(i);
      }
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
    first_[j] = own.first;
    last_[j] = own.last;
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
  const double base = profile_.support(n.z(), nxy) * rise;
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
  for (std::size_t round = 0; round < std::min(rounds_, kept); ++round) {
    const double slope = slopes_[round];
    const double most = std::min(from.z - slope * from.s, to.z - slope * to.s);
    const double* bases = bases_[round].data();
    for (std::size_t j = 0; j < count; ++j) {
      excess[j] = std::min(excess[j], bases[j] - most);
    }
  }
}

}  // namespace arelem::motion
