#include "app/comparison.h"

#include <numbers>
#include <ostream>
#include <utility>

#include "app/chord_run.h"
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "ir/space/tolerance.h"

namespace arelem::app {

namespace {
/// A move that one file has and the other not is looked for so far ahead.
constexpr std::size_t lookAhead = 64;
/// Longest run of straight moves that stands for an arc.
constexpr std::size_t longestRun = 100'000;

/// Feeds are written with few digits.
bool differ(double a, double b) {
  return std::abs(a - b) > tolerance::similarity * (std::abs(a) + std::abs(b));
}

/// From the unit of the right file to that of the left one. A file that names none is in the
/// other's.
double scaleOf(const ClMove& left, const ClMove& right) {
  return left.millimeters > 0.0 && right.millimeters > 0.0 ? right.millimeters / left.millimeters
                                                           : 1.0;
}

std::string_view wayName(const ClMove& move) {
  using Way = cl::Motion::Way;
  if (move.way == Way::spline) {
    return "along a spline";
  }
  return move.way != Way::straight ? "along an arc" : move.rapid ? "at rapid" : "straight";
}

std::string quoted(const std::string& words) {
  return words.empty() ? "none" : "`" + words + "`";
}

double apart(const ClMove& left, const ClMove& right) {
  return (left.end - scaleOf(left, right) * right.end).norm();
}

/// Whether two moves go to different places or in different ways, and how; empty where they do not.
std::string wayDiffers(const ClMove& left, const ClMove& right, const DiffAllowed& allowed) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  const double distance = apart(left, right);
  if (!(distance <= allowed.distance)) {
    return fmt::format("{:.6g} apart", distance);
  }
  const double turned =
      degrees * std::atan2(left.axis.cross(right.axis).norm(), left.axis.dot(right.axis));
  if (!(turned <= allowed.degrees)) {
    return fmt::format("tool axes {:.6g} degrees apart", turned);
  }
  if (left.way != right.way || left.rapid != right.rapid) {
    return fmt::format("{} and {}", wayName(left), wayName(right));
  }
  if (left.center && right.center) {
    const double centers = (*left.center - scaleOf(left, right) * *right.center).norm();
    if (!(centers <= allowed.distance)) {
      return fmt::format("centers of the arcs {:.6g} apart", centers);
    }
  }
  return "";
}

/// The same of feeds and words.
std::string orderDiffers(const ClMove& left, const ClMove& right, const DiffAllowed& allowed) {
  if (!left.rapid && differ(left.feed, right.feed)) {
    return fmt::format("feeds {:.9g} and {:.9g}", left.feed, right.feed);
  }
  if (allowed.words && left.words != right.words) {
    return fmt::format("words before it {} and {}", quoted(left.words), quoted(right.words));
  }
  return "";
}

nlohmann::ordered_json jsonOf(const DiffSide& side, const ClMove& move, std::size_t number) {
  nlohmann::ordered_json all = {{"move", number + 1}};
  if (move.line != 0) {
    all["line"] = move.line;
  }
  all["isn"] = move.isn;
  all["place"] = side.place(move);
  all["end"] = {move.end.x(), move.end.y(), move.end.z()};
  all["axis"] = {move.axis.x(), move.axis.y(), move.axis.z()};
  return all;
}
}  // namespace

void Comparison::run() {
  while (a_.peek() != nullptr && b_.peek() != nullptr) {
    const ClMove& left = *a_.peek();
    const ClMove& right = *b_.peek();
    std::string what = wayDiffers(left, right, allowed_);
    if (!what.empty() && (stepChords() || step())) {
      continue;
    }
    what = what.empty() ? orderDiffers(left, right, allowed_) : std::move(what);
    if (!what.empty()) {
      ++differing_;
      note({a_.index(), b_.index(), *a_.peek(), *b_.peek(), apart(*a_.peek(), *b_.peek()),
            std::move(what)});
    }
    a_.skip(1);
    b_.skip(1);
  }
  const std::size_t leftBefore = a_.index();
  const std::size_t rightBefore = b_.index();
  a_.drain();
  b_.drain();
  onlyA_ += a_.index() - leftBefore;
  onlyB_ += b_.index() - rightBefore;
}

void Comparison::finish() {
  if (allowed_.words && a_.wordsBehind() != b_.wordsBehind()) {
    endWords_ = fmt::format("words behind the last move: {} and {}", quoted(a_.wordsBehind()),
                            quoted(b_.wordsBehind()));
    ++differing_;
  }
}

void Comparison::note(Difference difference) {
  if (!largest_ || difference.distance > largest_->distance) {
    largest_ = difference;
  }
  if (!first_) {
    first_ = std::move(difference);
  }
}

void Comparison::only(DiffSide& side, std::size_t count) {
  if (!missing_) {
    missing_ = Missing{&side, *side.peek()};
  }
  (&side == &a_ ? onlyA_ : onlyB_) += count;
  side.skip(count);
}

/// Steps over moves that only one file has.
bool Comparison::step() {
  for (std::size_t k = 1; k <= lookAhead; ++k) {
    const ClMove* left = a_.peek(k);
    if (left != nullptr && wayDiffers(*left, *b_.peek(), allowed_).empty()) {
      only(a_, k);
      return true;
    }
    const ClMove* right = b_.peek(k);
    if (right != nullptr && wayDiffers(*a_.peek(), *right, allowed_).empty()) {
      only(b_, k);
      return true;
    }
  }
  return false;
}

/// Steps over an arc of one file and the straight moves of the other that keep to it.
bool Comparison::stepChords() {
  if (!(allowed_.chords > 0.0) || a_.peek()->isArc() == b_.peek()->isArc()) {
    return false;
  }
  const bool leftHasArc = a_.peek()->isArc();
  DiffSide& arcs = leftHasArc ? a_ : b_;
  DiffSide& lines = leftHasArc ? b_ : a_;
  const double scale = scaleOf(*a_.peek(), *b_.peek());
  ChordRun run(*arcs.peek(), leftHasArc ? 1.0 : scale, {allowed_.distance, allowed_.chords});
  for (std::size_t k = 0; k < longestRun; ++k) {
    const ClMove* line = lines.peek(k);
    if (line == nullptr || !run.take(*line, leftHasArc ? scale : 1.0)) {
      return false;
    }
    if (run.arrived()) {
      ++arcs_;
      arcs.skip(1);
      lines.skip(k + 1);
      return true;
    }
  }
  return false;
}

void Comparison::print(std::ostream& out, std::string_view title, const Difference& d) const {
  out << fmt::format(
      "{}: move {} ({}) to ({:.9g}, {:.9g}, {:.9g}) and move {} ({}) to ({:.9g}, {:.9g}, "
      "{:.9g}): {}\n",
      title, d.a + 1, a_.place(d.left), d.left.end.x(), d.left.end.y(), d.left.end.z(), d.b + 1,
      b_.place(d.right), d.right.end.x(), d.right.end.y(), d.right.end.z(), d.what);
}

void Comparison::print(std::ostream& out) const {
  if (first_) {
    print(out, "first difference", *first_);
    print(out, "largest difference", *largest_);
  }
  if (missing_) {
    const ClMove& move = missing_->move;
    out << fmt::format("first move of one file only: {} to ({:.9g}, {:.9g}, {:.9g})\n",
                       missing_->side->place(move), move.end.x(), move.end.y(), move.end.z());
  } else if (onlyA_ + onlyB_ > 0) {
    out << "one file goes on where the other ends\n";
  }
  out << endWords_ << (endWords_.empty() ? "" : "\n");
  if (arcs_ > 0) {
    out << fmt::format("{} of one file {} straight moves of the other\n",
                       arcs_ == 1 ? "1 arc" : fmt::format("{} arcs", arcs_),
                       arcs_ == 1 ? "is" : "are");
  }
  out << fmt::format(
      "{}: {} moves, {}: {} moves; {} differ, {} only in the first, {} only in "
      "the second\n",
      a_.name(), a_.index(), b_.name(), b_.index(), differing_, onlyA_, onlyB_);
}

void Comparison::printJson(std::ostream& out) const {
  nlohmann::ordered_json all = {{"same", same()},
                                {"a", {{"file", a_.name()}, {"moves", a_.index()}}},
                                {"b", {{"file", b_.name()}, {"moves", b_.index()}}},
                                {"differing", differing_},
                                {"onlyA", onlyA_},
                                {"onlyB", onlyB_},
                                {"arcsAsChords", arcs_}};
  const auto difference = [&](const char* title, const std::optional<Difference>& d) {
    if (d) {
      all[title] = {{"a", jsonOf(a_, d->left, d->a)},
                    {"b", jsonOf(b_, d->right, d->b)},
                    {"distance", d->distance},
                    {"what", d->what}};
    }
  };
  difference("first", first_);
  difference("largest", largest_);
  if (missing_) {
    const ClMove& move = missing_->move;
    all["firstMissing"] = {{"file", missing_->side->name()},
                           {"place", missing_->side->place(move)},
                           {"end", {move.end.x(), move.end.y(), move.end.z()}}};
  }
  if (!endWords_.empty()) {
    all["end"] = endWords_;
  }
  out << all.dump(1) << '\n';
}

}  // namespace arelem::app
