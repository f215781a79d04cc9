#include "runtime/motion/records.h"

#include <algorithm>

#include "runtime/path/point_records.h"

namespace arelem::motion {

namespace {
/// A minus zero would print as one.
double plain(double x) {
  return x + 0.0;
}
}  // namespace

void RecordWriter::begin(const runtime::Action& action) {
  record_.isn = action.isn;
  record_.cardId = action.cardId;
  record_.origin = action.origin;
  written_ = false;
}

void RecordWriter::end() {
  if (!written_ && record_.isn != lastIsn_) {
    put(cl::Card{});
  }
}

void RecordWriter::put(cl::Body body) {
  record_.body = std::move(body);
  sink_.accept(record_);
  lastIsn_ = record_.isn;
  written_ = true;
  ++count_;
}

void RecordWriter::startPoints(cl::Motion::Kind kind,
                               const std::string& name,
                               int subscript,
                               bool withAxis) {
  points_.isn = record_.isn;
  points_.cardId = record_.cardId;
  points_.origin = record_.origin;
  if (!std::holds_alternative<cl::Motion>(points_.body)) {
    points_.body = cl::Motion{};
  }
  auto& motion = std::get<cl::Motion>(points_.body);
  motion.kind = kind;
  motion.name = name;
  motion.subscript = subscript;
  motion.withAxis = withAxis;
  motion.withSide = false;
  motion.way = cl::Motion::Way::straight;
  motion.coordinates.clear();
}

void RecordWriter::add(const Vec3& toolEnd, const Vec3& axis) {
  auto& motion = std::get<cl::Motion>(points_.body);
  if (motion.coordinates.size() + motion.stride() > path::numbersPerRecord) {
    flush();
  }
  for (int i = 0; i < 3; ++i) {
    motion.coordinates.push_back(plain(toolEnd[i]));
  }
  for (int i = 0; motion.withAxis && i < 3; ++i) {
    motion.coordinates.push_back(plain(axis[i]));
  }
}

void RecordWriter::add(std::span<const double> locations) {
  auto& motion = std::get<cl::Motion>(points_.body);
  std::vector<double>& all = motion.coordinates;
  const std::size_t whole = path::numbersPerRecord / motion.stride() * motion.stride();
  while (!locations.empty()) {
    if (all.size() >= whole) {
      flush();
    }
    const auto from = static_cast<std::ptrdiff_t>(all.size());
    const std::size_t count = std::min(locations.size(), whole - all.size());
    all.insert(all.end(), locations.begin(),
               locations.begin() + static_cast<std::ptrdiff_t>(count));
    std::transform(all.begin() + from, all.end(), all.begin() + from, plain);
    locations = locations.subspan(count);
  }
}

void RecordWriter::putCurve(cl::Motion::Way way, const Vec3& end, const Vec3& axis, bool withAxis) {
  startPoints(cl::Motion::Kind::go, "", 0, withAxis);
  std::get<cl::Motion>(points_.body).way = way;
  add(end, axis);
  finishPoints();
}

void RecordWriter::putPose(const runtime::Locate& locate, const Vec3& axis, const Vec3& side) {
  startPoints(locate.word == Word::FROM ? cl::Motion::Kind::from : cl::Motion::Kind::go,
              locate.name, locate.subscript, true);
  auto& motion = std::get<cl::Motion>(points_.body);
  motion.withSide = true;
  for (const Vec3& part : {locate.point, axis, side}) {
    for (int i = 0; i < 3; ++i) {
      motion.coordinates.push_back(plain(part[i]));
    }
  }
  finishPoints();
}

void RecordWriter::flush() {
  auto& motion = std::get<cl::Motion>(points_.body);
  if (motion.coordinates.empty()) {
    return;
  }
  sink_.accept(points_);
  lastIsn_ = points_.isn;
  written_ = true;
  ++count_;
  motion.coordinates.clear();
  motion.kind = cl::Motion::Kind::continuation;
}

void RecordWriter::finishPoints() {
  flush();
}

}  // namespace arelem::motion
