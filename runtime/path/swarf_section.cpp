#include "runtime/path/swarf_section.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "ir/cl/post_word.h"
#include "ir/diag/interpret.h"
#include "ir/space/tolerance.h"

namespace arelem::path {

namespace {
constexpr double degree = std::numbers::pi / 180.0;
/// A larger turn between two moves is a corner, degrees.
constexpr double sharpest = 45.0;
constexpr std::size_t stride = 6;
constexpr int usualSteps = 6;

double numberAt(const cl::Post& post, std::size_t i) {
  return std::get<double>(post.arguments.at(i));
}
bool leftAt(const cl::Post& post, std::size_t i) {
  return std::get<Word>(post.arguments.at(i)) == Word::LEFT;
}
}  // namespace

bool hasSwarfForm(const cl::Post& post) {
  std::string kinds;
  for (const cl::Value& value : post.arguments) {
    kinds += std::holds_alternative<Word>(value)     ? 'w'
             : std::holds_alternative<double>(value) ? 'n'
                                                     : '?';
  }
  if (cl::is(post, Word::WCORN)) {
    return kinds == "wnwnn" || kinds == "wnwnnn";
  }
  const bool on = !post.arguments.empty() && post.arguments[0] == cl::Value(Word::ON);
  return on ? kinds == "wwnnnw" || kinds == "wwnnnww" : kinds == "wwn";
}

double swarfTilt(const cl::Post& post, std::size_t i) {
  return (leftAt(post, i) ? 1.0 : -1.0) * numberAt(post, i + 1) * degree;
}

SwarfTool swarfTool(const cl::Post& on) {
  SwarfTool tool;
  tool.radius = numberAt(on, 3) / 2.0;
  tool.corner = numberAt(on, 4);
  tool.wallLeft = !leftAt(on, 5);
  tool.deep = on.arguments.size() > 6;
  return tool;
}

SwarfSection::SwarfSection(const cl::Post& on) : tool_(swarfTool(on)), begin_(swarfTilt(on, 1)) {}

std::optional<Failure> SwarfSection::begin(const cl::Record& record) {
  records_.push_back(record);
  before_ = (std::get<cl::Motion>(record.body).points() - 1) * stride;
  return take(std::get<cl::Motion>(record.body).points() - 1);
}

std::optional<Failure> SwarfSection::begin(const End& end) {
  if (std::abs(end.tilt - begin_) > tolerance::parallel) {
    return fail(diag::SwarfSection,
                fmt::format("the section before ends with a tilt of {:.6g} degrees and this one "
                            "begins with {:.6g}",
                            std::abs(end.tilt) / degree, std::abs(begin_) / degree));
  }
  points_.push_back(end.upright);
  return std::nullopt;
}

std::optional<Failure> SwarfSection::add(const cl::Record& record) {
  records_.push_back(record);
  return std::holds_alternative<cl::Motion>(record.body) ? take(0) : std::nullopt;
}

std::optional<Failure> SwarfSection::corner(const cl::Record& record) {
  if (corner_) {
    return fail(diag::SwarfSection, "a second WCORN stands between VTLAXS/ON and VTLAXS/OFF");
  }
  records_.push_back(record);
  const auto& post = std::get<cl::Post>(record.body);
  corner_ = SwarfCorner{};
  corner_->tiltBefore = swarfTilt(post, 0);
  corner_->tiltAfter = swarfTilt(post, 2);
  corner_->height = numberAt(post, 4);
  corner_->steps = post.arguments.size() > 5 ? static_cast<int>(numberAt(post, 5)) : usualSteps;
  at_ = points_.size() - 1;
  return std::nullopt;
}

std::optional<Failure> SwarfSection::finish(const cl::Post& off) {
  const double end = swarfTilt(off, 1);
  if (points_.size() < 2) {
    return fail(diag::SwarfSection, "no move stands between VTLAXS/ON and VTLAXS/OFF");
  }
  if (auto failure = findDirections()) {
    return failure;
  }
  poses_.resize(points_.size());
  if (!corner_) {
    tilt(0, points_.size() - 1, begin_, end);
    at_ = points_.size();  // none
    write(at_, at_, {});
    return std::nullopt;
  }
  if (at_ == 0 || at_ + 1 == points_.size()) {
    return fail(diag::SwarfCorner, "no move stands between VTLAXS and WCORN");
  }
  tilt(0, at_, begin_, corner_->tiltBefore);
  tilt(at_, points_.size() - 1, corner_->tiltAfter, end);
  return turn();
}

std::optional<Failure> SwarfSection::take(std::size_t from) {
  const auto& motion = std::get<cl::Motion>(records_.back().body);
  if (motion.stride() != stride) {
    return fail(diag::SwarfPath, "MULTAX is not on, or the location has nine numbers");
  }
  for (std::size_t i = from; i < motion.points(); ++i) {
    const double* n = &motion.coordinates[i * stride];
    const Vec3 point(n[0], n[1], n[2]);
    const Vec3 axis(n[3], n[4], n[5]);
    if ((axis - Vec3::UnitZ()).norm() > tolerance::perpendicular) {
      return fail(diag::SwarfPath, fmt::format("the tool axis at ({:.6g}, {:.6g}, {:.6g}) is not z",
                                               n[0], n[1], n[2]));
    }
    if (!points_.empty() && std::abs(point.z() - points_[0].z()) > tolerance::coincidence) {
      return fail(diag::SwarfPath,
                  fmt::format("its heights are {:.6g} and {:.6g}", points_[0].z(), point.z()));
    }
    if (points_.empty() || (point - points_.back()).norm() > tolerance::coincidence) {
      points_.push_back(point);
    }
    locations_.push_back({records_.size() - 1, points_.size() - 1});
  }
  return std::nullopt;
}

std::optional<Failure> SwarfSection::findDirections() {
  forward_.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3 in = i > 0 ? step(i - 1) : step(0);
    const Vec3 out = i + 1 < points_.size() ? step(i) : in;
    if (corner_ && i == at_) {
      continue;  // each part has its own
    }
    const double turn = std::atan2(in.cross(out).norm(), in.dot(out)) / degree;
    if (turn > sharpest) {
      return fail(diag::SwarfCorner,
                  fmt::format("the path turns by {:.4g} degrees at ({:.6g}, {:.6g}): a corner "
                              "needs WCORN",
                              turn, points_[i].x(), points_[i].y()));
    }
    forward_[i] = (in + out).normalized();
  }
  return std::nullopt;
}

void SwarfSection::tilt(std::size_t from, std::size_t to, double first, double last) {
  double whole = 0.0;
  for (std::size_t i = from; i < to; ++i) {
    whole += (points_[i + 1] - points_[i]).norm();
  }
  double gone = 0.0;
  for (std::size_t i = from; i <= to; ++i) {
    const double angle = first + (last - first) * gone / whole;
    const bool isCorner = corner_ && i == at_;
    const Vec3 forward = !isCorner ? forward_[i] : step(i == to ? i - 1 : i);
    poses_[i] = swarfPose(tool_, points_[i], forward, angle);
    gone += i < to ? (points_[i + 1] - points_[i]).norm() : 0.0;
  }
}

std::optional<Failure> SwarfSection::turn() {
  corner_->upright = points_[at_];
  corner_->before = step(at_ - 1);
  corner_->after = step(at_);
  const double across = corner_->before.cross(corner_->after).z();
  if (tool_.deep) {
    return fail(diag::SwarfCorner, "ZSMALL and WCORN together are not computed");
  }
  if ((across > 0.0) == tool_.wallLeft) {
    return fail(diag::SwarfCorner, "the path turns round the wall: WCORN is for inside corners");
  }
  const auto turned = swarfTurn(tool_, *corner_);
  if (!turned) {
    return fail(diag::SwarfCorner,
                "the walls meet in a line that leans 80 degrees or more, or in none");
  }
  // What the turn has taken over: locations nearer to the corner than its first and its last.
  std::size_t first = at_;
  const double begins = turned->before.front().toolEnd.dot(corner_->before);
  while (first > 0 && poses_[first - 1].toolEnd.dot(corner_->before) >= begins) {
    --first;
  }
  std::size_t last = at_;
  const double ends = turned->after.back().toolEnd.dot(corner_->after);
  while (last + 1 < points_.size() && poses_[last + 1].toolEnd.dot(corner_->after) <= ends) {
    ++last;
  }
  if (first == 0 || last + 1 == points_.size()) {
    return fail(diag::SwarfCorner,
                fmt::format("the path {} the corner is too short for the tool to turn",
                            first == 0 ? "before" : "behind"));
  }
  write(first, last, *turned);
  return std::nullopt;
}

void SwarfSection::put(std::size_t record, const SwarfPose& pose) {
  auto& numbers = std::get<cl::Motion>(records_[record].body).coordinates;
  numbers.insert(numbers.end(), {pose.toolEnd.x(), pose.toolEnd.y(), pose.toolEnd.z(),
                                 pose.axis.x(), pose.axis.y(), pose.axis.z()});
}

void SwarfSection::write(std::size_t first, std::size_t last, const SwarfTurn& turn) {
  for (std::size_t r = 0; r < records_.size(); ++r) {
    if (auto* motion = std::get_if<cl::Motion>(&records_[r].body)) {
      motion->coordinates.resize(r == 0 ? before_ : 0);
    }
  }
  bool turned = false, left = false;
  for (const Location& location : locations_) {
    const std::size_t i = location.point;
    if (i >= first && i <= last) {
      for (std::size_t k = 0; i == at_ && !turned && k < turn.before.size(); ++k) {
        put(location.record, turn.before[k]);
      }
      turned = turned || i == at_;
      continue;
    }
    for (std::size_t k = 0; turned && !left && k < turn.after.size(); ++k) {
      put(location.record, turn.after[k]);
    }
    left = turned;
    put(location.record, poses_[i]);
  }
  std::erase_if(records_, [](const cl::Record& record) {
    const auto* motion = std::get_if<cl::Motion>(&record.body);
    return motion != nullptr && motion->coordinates.empty();
  });
}

}  // namespace arelem::path
