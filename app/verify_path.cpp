#include "app/verify_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/cl/post_word.h"
#include "ir/diag/render_text.h"
#include "ir/diag/verify.h"
#include "ir/words/units.h"

namespace arelem::app {

void Path::accept(const cl::Record& record) {
  if (const auto* units = std::get_if<cl::Units>(&record.body)) {
    millimeters = millimetersOf(units->unit);
  }
  if (const cl::Post* post = cl::postOf(record.body, Word::SPRAY);
      post != nullptr && !locations.empty()) {
    switchOutput(*post);
  }
  const auto* motion = std::get_if<cl::Motion>(&record.body);
  if (motion == nullptr) {
    return;
  }
  for (std::size_t i = 0; i + motion->stride() <= motion->coordinates.size();
       i += motion->stride()) {
    const double* c = motion->coordinates.data() + i;
    Location location{{c[0], c[1], c[2]}, std::nullopt, std::nullopt, record.origin, {}};
    location.on = locations.empty() ? std::set<int>() : locations.back().on;
    if (motion->withAxis) {
      location.axis = Vec3(c[3], c[4], c[5]);
    }
    if (motion->withSide) {
      location.side = Vec3(c[6], c[7], c[8]);
    }
    locations.push_back(location);
  }
}

void Path::switchOutput(const cl::Post& post) {
  int output = 1;
  bool on = false;
  for (const cl::Value& value : post.arguments) {
    if (const double* number = std::get_if<double>(&value)) {
      output = static_cast<int>(*number);
    } else if (const Word* word = std::get_if<Word>(&value)) {
      on = *word == Word::ON;
    }
  }
  std::set<int>& state = locations.back().on;
  on ? void(state.insert(output)) : void(state.erase(output));
}

double degreesBetween(const Vec3& a, const Vec3& b) {
  constexpr double degreesOfARadian = 180.0 / std::numbers::pi;
  return degreesOfARadian * std::atan2(a.cross(b).norm(), a.dot(b));
}

std::optional<Diagnostic> difference(const Location& wanted,
                                     const Location& found,
                                     std::size_t number,
                                     const std::string& name,
                                     const Allowed& allowed) {
  const double distance = (wanted.point - found.point).norm();
  if (!(distance <= allowed.distance)) {
    return diagnose(wanted.origin, diag::PathDiffers, number, name, distance, allowed.distance);
  }
  const double turned = wanted.axis && found.axis ? degreesBetween(*wanted.axis, *found.axis) : 0.0;
  if (!(turned <= allowed.degrees)) {
    return diagnose(wanted.origin, diag::AxisDiffers, number, name, turned, allowed.degrees);
  }
  const double about = wanted.side && found.side ? degreesBetween(*wanted.side, *found.side) : 0.0;
  if (!(about <= allowed.degrees)) {
    return diagnose(wanted.origin, diag::SideDiffers, number, name, about, allowed.degrees);
  }
  return std::nullopt;
}

std::optional<Diagnostic> firstDifference(const Path& wanted,
                                          const Path& found,
                                          const std::string& name,
                                          const Allowed& allowed) {
  const std::size_t count = std::min(wanted.locations.size(), found.locations.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (auto other = difference(wanted.locations[i], found.locations[i], i + 1, name, allowed)) {
      return other;
    }
  }
  if (wanted.locations.size() != found.locations.size()) {
    return diagnose(nowhere, diag::PathLength, name, found.locations.size(),
                    wanted.locations.size());
  }
  return std::nullopt;
}

}  // namespace arelem::app
