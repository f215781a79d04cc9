#include "runtime/path/frame.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "ir/cl/post_word.h"
#include "ir/space/cl_file_tolerance.h"
#include "runtime/geometry/angle.h"

namespace arelem::path {

namespace {
constexpr double hundredths = 100.0;
constexpr double degreesOfRadian = 180.0 / std::numbers::pi;

std::string_view textOf(const cl::Value& value) {
  if (const Word* word = std::get_if<Word>(&value)) {
    return spell(*word);
  }
  const std::string* text = std::get_if<std::string>(&value);
  return text == nullptr ? std::string_view() : *text;
}

/// The frame of an origin and two axes, made square and of unit length.
std::optional<Affine> squared(Vec3 x, Vec3 y, const Vec3& origin) {
  const bool unit = std::abs(x.norm() - 1.0) < tolerance::printedAxis &&
                    std::abs(y.norm() - 1.0) < tolerance::printedAxis;
  if (!unit || std::abs(x.dot(y)) > tolerance::printedAxis) {
    return std::nullopt;
  }
  x.normalize();
  y = (y - y.dot(x) * x).normalized();
  Affine frame;
  frame.linear.col(0) = x;
  frame.linear.col(1) = y;
  frame.linear.col(2) = x.cross(y);
  frame.shift = origin;
  return frame;
}

/// An angle that is whole hundredths of a degree as far as it is printed is meant to be one.
double meantDegrees(double radians) {
  const double degrees = radians * degreesOfRadian;
  const double near = std::round(degrees * hundredths) / hundredths;
  return std::abs(near - degrees) < tolerance::printedRadians * degreesOfRadian ? near : degrees;
}
}  // namespace

std::optional<Affine> frameOf(const cl::Post& post) {
  const std::vector<double> n = cl::numbersOf(post);
  if (post.foreign == "MSYS" && n.size() == 9) {
    return squared({n[3], n[4], n[5]}, {n[6], n[7], n[8]}, {n[0], n[1], n[2]});
  }
  if (post.foreign == "CATIA0" && n.size() == 12) {
    return squared({n[0], n[4], n[8]}, {n[1], n[5], n[9]}, {n[3], n[7], n[11]});
  }
  if (post.foreign == "LOCAL_ORIGIN" && n.size() == 3) {
    return Affine::translation({n[0], n[1], n[2]});
  }
  return std::nullopt;
}

std::optional<Affine> turnOf(const cl::Post& post) {
  const auto& a = post.arguments;
  const bool form = post.foreign.empty() && post.word == Word::ROTABL && a.size() == 4 &&
                    std::holds_alternative<double>(a[0]) && textOf(a[2]) == "TABLE";
  const std::string_view way = form ? textOf(a[3]) : "";
  constexpr std::array<std::string_view, 3> axes = {"AAXIS", "BAXIS", "CAXIS"};
  for (std::size_t i = 0; i < axes.size() && (way == "CCLW" || way == "CLW"); ++i) {
    if (textOf(a[1]) == axes.at(i)) {
      const double angle = std::get<double>(a[0]);
      const auto [s, c] = geometry::sinCosDegrees(meantDegrees(way == "CLW" ? -angle : angle));
      const auto from = static_cast<Eigen::Index>((i + 1) % 3);
      const auto to = static_cast<Eigen::Index>((i + 2) % 3);
      Affine turn;
      turn.linear(from, from) = turn.linear(to, to) = c;
      turn.linear(to, from) = s;
      turn.linear(from, to) = -s;
      return turn;
    }
  }
  return std::nullopt;
}

cl::Post withoutFrame(const cl::Post& post) {
  cl::Post plain = post;
  if (turnOf(post)) {
    plain.arguments[0] = 0.0;
    return plain;
  }
  if (!frameOf(post)) {
    return plain;
  }
  std::size_t next = 0;
  for (cl::Value& value : plain.arguments) {
    if (double* number = std::get_if<double>(&value)) {
      // MSYS: origin, x axis, y axis. CATIA0: rows of four.
      const bool one = post.foreign == "MSYS" ? next == 3 || next == 7
                                              : post.foreign == "CATIA0" && next % 5 == 0;
      *number = one ? 1.0 : 0.0;
      ++next;
    }
  }
  return plain;
}

bool endsTurns(const cl::Post& post) {
  return post.foreign == "OPFEATEND";
}

bool FrameOfPlaces::take(const cl::Post& post) {
  if (endsTurns(post)) {
    turn_ = {};
    return false;
  }
  if (const std::optional<Affine> turn = turnOf(post)) {
    turn_ = turn_.after(*turn);
    return true;
  }
  const std::optional<Affine> frame = frameOf(post);
  if (!frame) {
    return false;
  }
  if (post.foreign == "LOCAL_ORIGIN") {
    shift_ = *frame;
  } else {
    base_ = *frame;
    shift_ = {};
  }
  return true;
}

}  // namespace arelem::path
