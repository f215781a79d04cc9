#include "runtime/path/upright_section.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "ir/diag/interpret.h"
#include "ir/diag/verify.h"
#include "ir/space/tolerance.h"

namespace arelem::path {

namespace {
constexpr std::size_t stride = 6;
}

UprightSection::UprightSection(const cl::Post& on, double slack)
    : on_(on), tool_(swarfTool(on)), slack_(std::max(slack, tolerance::coincidence)) {}

std::optional<Failure> UprightSection::begin(const cl::Record& record) {
  const std::size_t points = std::get<cl::Motion>(record.body).points();
  before_ = (points - 1) * stride;
  return take(record, points - 1);
}

std::optional<Failure> UprightSection::begin(const End& end) {
  from_ = end;
  return std::nullopt;
}

std::optional<Failure> UprightSection::add(const cl::Record& record) {
  return take(record, 0);
}

std::optional<Failure> UprightSection::corner(const cl::Record& /*record*/) {
  return fail(diag::NotCertified,
              "WCORN has turned the tool in a corner, where its locations no "
              "longer follow from those of the upright tool");
}

std::optional<Failure> UprightSection::take(const cl::Record& record, std::size_t from) {
  records_.push_back(record);
  const auto* motion = std::get_if<cl::Motion>(&record.body);
  if (motion == nullptr) {
    return std::nullopt;
  }
  if (motion->stride() != stride) {
    return fail(diag::SwarfPath, "MULTAX is not on, or the location has nine numbers");
  }
  for (std::size_t i = from; i < motion->points(); ++i) {
    const double* n = &motion->coordinates[i * stride];
    poses_.push_back({Vec3(n), Vec3(n + 3).normalized()});
  }
  return std::nullopt;
}

/// The side to which the tool leans decides with the way of the tool ends whether that is left.
void UprightSection::makeUpright() {
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const SwarfPose& pose = poses_[i];
    const Vec3 in = i > 0   ? Vec3(pose.toolEnd - poses_[i - 1].toolEnd)
                    : from_ ? Vec3(pose.toolEnd - from_->upright)
                            : Vec3::Zero().eval();
    const Vec3 out = i + 1 < poses_.size() ? Vec3(poses_[i + 1].toolEnd - pose.toolEnd) : in;
    const Vec3 way = in + out;
    const Vec3 lean(pose.axis.x(), pose.axis.y(), 0.0);
    const double tilt = std::atan2(lean.norm(), pose.axis.z());
    const bool left = Vec3(-way.y(), way.x(), 0.0).dot(lean) >= 0.0;
    const Vec3 side = tilt > 0.0 ? Vec3(lean.normalized() * (left ? 1.0 : -1.0)) : Vec3::UnitX();
    upright_.push_back(swarfUpright(tool_, pose, side, left ? tilt : -tilt));
  }
}

/// At one height, as the section was before rounding.
std::vector<Vec3> UprightSection::level() const {
  std::vector<Vec3> points = upright_;
  const double height = from_ ? from_->upright.z() : points.front().z();
  for (Vec3& point : points) {
    point.z() = height;
  }
  return points;
}

std::optional<Failure> UprightSection::finish(const cl::Post& off) {
  if (poses_.empty()) {
    return fail(diag::SwarfSection, "no move stands between VTLAXS/ON and VTLAXS/OFF");
  }
  makeUpright();
  SwarfSection again(on_);
  if (from_) {
    if (auto failure = again.begin(*from_)) {
      return failure;
    }
  }
  cl::Record all = records_.front();
  cl::Motion motion;
  motion.withAxis = true;
  for (const Vec3& point : level()) {
    motion.coordinates.insert(motion.coordinates.end(),
                              {point.x(), point.y(), point.z(), 0.0, 0.0, 1.0});
  }
  all.body = std::move(motion);
  if (auto failure = again.add(all)) {
    return failure;
  }
  if (auto failure = again.finish(off)) {
    return failure;
  }
  if (auto failure = compare(again)) {
    return failure;
  }
  write();
  return std::nullopt;
}

std::optional<Failure> UprightSection::compare(const SwarfSection& again) const {
  const auto& tilted = std::get<cl::Motion>(again.records().front().body).coordinates;
  // Rounding moves a place, the foot of the tilt and the directions of the moves to it and from it.
  const double allowed = 4.0 * slack_;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const Vec3 end(&tilted[i * stride]);
    const Vec3 axis(&tilted[i * stride + 3]);
    const double off = (poses_[i].toolEnd - end).norm();
    const double turned = (poses_[i].axis - axis).norm();
    if (!(off <= allowed && turned <= allowed)) {
      return fail(diag::NotCertified,
                  fmt::format("location {} of this section of VTLAXS is {:.3g} away from where the "
                              "upright tool comes by tilting, and its axis {:.3g} (allowed {:.3g})",
                              i + 1, off, turned, allowed));
    }
  }
  return std::nullopt;
}

void UprightSection::write() {
  std::size_t next = 0;
  for (std::size_t r = 0; r < records_.size(); ++r) {
    auto* motion = std::get_if<cl::Motion>(&records_[r].body);
    if (motion == nullptr) {
      continue;
    }
    auto& numbers = motion->coordinates;
    for (std::size_t at = r == 0 ? before_ : 0; at < numbers.size(); at += stride) {
      const Vec3& place = upright_[next++];
      std::copy_n(place.data(), 3, numbers.begin() + static_cast<std::ptrdiff_t>(at));
      numbers[at + 3] = numbers[at + 4] = 0.0;
      numbers[at + 5] = 1.0;
    }
  }
}

}  // namespace arelem::path
