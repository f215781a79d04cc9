#include <algorithm>
#include <iostream>
#include <numbers>

#include "app/cl_input.h"
#include "app/cl_moves.h"
#include "app/command.h"
#include "app/number_check.h"
#include "app/options.h"
#include "app/source_file.h"
#include <Eigen/Geometry>

#include "ir/diag/render_text.h"
#include "ir/space/tolerance.h"

namespace arelem::app {

namespace {
/// A move that one file has and the other not is looked for so far ahead.
constexpr std::size_t lookAhead = 64;

/// Feeds are written with few digits.
bool differ(double a, double b) {
  return std::abs(a - b) > tolerance::similarity * (std::abs(a) + std::abs(b));
}

struct Allowed {
  double distance = 1e-6;  ///< part unit of the first file
  double degrees = 1e-4;
};

/// One of the two files.
struct Side {
  explicit Side(const Settings& settings) : job(settings) {}
  Compilation job;
  ClMoves path;
  std::string name;
  double scale = 1.0;  ///< to the unit of the first file

  /// "a.cls:12" or, without a text, the statement number.
  [[nodiscard]] std::string place(const ClMove& move) const {
    if (move.origin.length > 0 && job.sources.size() > 0) {
      return fmt::format("{}:{}", job.sources.name(move.origin.buffer),
                         job.sources.locate(move.origin.buffer, move.origin.begin).line);
    }
    return fmt::format("{} statement {}", name, move.isn);
  }
};

struct Difference {
  std::size_t a = 0, b = 0;  ///< numbers of the moves, from 0
  double distance = 0.0;
  std::string what;
};

std::string_view wayName(const ClMove& move) {
  using Way = cl::Motion::Way;
  if (move.way == Way::spline) {
    return "along a spline";
  }
  return move.way != Way::straight ? "along an arc" : move.rapid ? "at rapid" : "straight";
}

class Comparison {
 public:
  Comparison(const Side& a, const Side& b, const Allowed& allowed)
      : a_(a), b_(b), allowed_(allowed) {}

  void run() {
    const auto& left = a_.path.moves;
    const auto& right = b_.path.moves;
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < left.size() && j < right.size()) {
      auto difference = between(i, j);
      if (difference && step(i, j)) {
        continue;
      }
      if (difference) {
        ++differing_;
        note(*std::move(difference));
      }
      ++i;
      ++j;
    }
    onlyA_ += left.size() - i;
    onlyB_ += right.size() - j;
  }

  [[nodiscard]] bool same() const { return differing_ + onlyA_ + onlyB_ == 0; }

  void print(std::ostream& out) const {
    if (first_) {
      print(out, "first difference", *first_);
      print(out, "largest difference", *largest_);
    }
    if (missing_) {
      const auto& [side, index] = *missing_;
      const ClMove& move = side->path.moves[index];
      out << fmt::format("first move of one file only: {} to ({:.9g}, {:.9g}, {:.9g})\n",
                         side->place(move), move.end.x(), move.end.y(), move.end.z());
    } else if (onlyA_ + onlyB_ > 0) {
      out << "one file goes on where the other ends\n";
    }
    out << fmt::format(
        "{}: {} moves, {}: {} moves; {} differ, {} only in the first, {} only in "
        "the second\n",
        a_.name, a_.path.moves.size(), b_.name, b_.path.moves.size(), differing_, onlyA_, onlyB_);
  }

 private:
  void print(std::ostream& out, std::string_view title, const Difference& d) const {
    const ClMove& left = a_.path.moves[d.a];
    const ClMove& right = b_.path.moves[d.b];
    out << fmt::format(
        "{}: move {} ({}) to ({:.9g}, {:.9g}, {:.9g}) and move {} ({}) to ({:.9g}, {:.9g}, "
        "{:.9g}): {}\n",
        title, d.a + 1, a_.place(left), left.end.x(), left.end.y(), left.end.z(), d.b + 1,
        b_.place(right), right.end.x(), right.end.y(), right.end.z(), d.what);
  }

  void note(Difference difference) {
    if (!largest_ || difference.distance > largest_->distance) {
      largest_ = difference;
    }
    if (!first_) {
      first_ = std::move(difference);
    }
  }

  [[nodiscard]] std::optional<Difference> between(std::size_t i, std::size_t j) const {
    const ClMove& left = a_.path.moves[i];
    const ClMove& right = b_.path.moves[j];
    const double apart = (left.end - b_.scale * right.end).norm();
    Difference d{i, j, apart, {}};
    if (!(apart <= allowed_.distance)) {
      d.what = fmt::format("{:.6g} apart", apart);
      return d;
    }
    constexpr double degrees = 180.0 / std::numbers::pi;
    const double turned =
        degrees * std::atan2(left.axis.cross(right.axis).norm(), left.axis.dot(right.axis));
    if (!(turned <= allowed_.degrees)) {
      d.what = fmt::format("tool axes {:.6g} degrees apart", turned);
    } else if (left.way != right.way || left.rapid != right.rapid) {
      d.what = fmt::format("{} and {}", wayName(left), wayName(right));
    } else if (left.center && right.center &&
               (*left.center - b_.scale * *right.center).norm() > allowed_.distance) {
      d.what = fmt::format("centers of the arcs {:.6g} apart",
                           (*left.center - b_.scale * *right.center).norm());
    } else if (!left.rapid && differ(left.feed, right.feed)) {
      d.what = fmt::format("feeds {:.9g} and {:.9g}", left.feed, right.feed);
    } else {
      return std::nullopt;
    }
    return d;
  }

  /// Steps over moves that only one file has, where the files agree again behind them.
  bool step(std::size_t& i, std::size_t& j) {
    for (std::size_t k = 1; k <= lookAhead; ++k) {
      if (i + k < a_.path.moves.size() && !between(i + k, j)) {
        missing_ = missing_.value_or(std::pair(&a_, i));
        onlyA_ += k;
        i += k;
        return true;
      }
      if (j + k < b_.path.moves.size() && !between(i, j + k)) {
        missing_ = missing_.value_or(std::pair(&b_, j));
        onlyB_ += k;
        j += k;
        return true;
      }
    }
    return false;
  }

  const Side& a_;
  const Side& b_;
  Allowed allowed_;
  std::optional<Difference> first_, largest_;
  std::optional<std::pair<const Side*, std::size_t>> missing_;
  std::size_t differing_ = 0, onlyA_ = 0, onlyB_ = 0;
};

ExitCode readSide(Side& side, const std::string& path, const InterruptFlag& interrupted) {
  side.name = displayName(path);
  Result<std::string> bytes = readBytes(path, side.job.settings.limits);
  if (!bytes) {
    side.job.log.accept(bytes.takeFailure());
  } else {
    static_cast<void>(readRecords(side.job, path, *std::move(bytes), side.path, interrupted));
  }
  side.job.log.print(side.job.sources, side.job.main, side.job.settings);
  return side.job.log.exitCode();
}
}  // namespace

int runDiff(const Invocation& invocation) {
  CLI::App app(
      "Compares two CL files (CL text of any system, CL tape, json; a part program is compiled) "
      "move by move:\n"
      "ends, tool axes, arcs, rapid and feed. The exit code is 0 where they agree, 5 where they "
      "differ.",
      "diff");
  Settings settings;
  Allowed allowed;
  std::string first, second;
  app.add_option("A", first, "a CL file")->required();
  app.add_option("B", second, "another one")->required();
  app.add_option("--tolerance", allowed.distance,
                 "largest distance of ends and centers, part unit of A (1e-6)")
      ->check(numberFromZero());
  app.add_option("--degrees", allowed.degrees, "largest angle between tool axes (1e-4)")
      ->check(numberFromZero());
  addSourceOptions(app, settings);
  addMessageOptions(app, settings);
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  const InterruptFlag& interrupted = invocation.interrupt.flag();
  Side a(settings);
  Side b(settings);
  ExitCode code = readSide(a, first, interrupted);
  code = worse(code, readSide(b, second, interrupted));
  if (code != ExitCode::ok || interrupted) {
    return static_cast<int>(code);
  }
  if (a.path.hasUnit && b.path.hasUnit) {
    b.scale = b.path.millimeters / a.path.millimeters;
  }
  Comparison comparison(a, b, allowed);
  comparison.run();
  if (!settings.quiet || !comparison.same()) {
    comparison.print(std::cout);
  }
  return static_cast<int>(comparison.same() ? ExitCode::ok : ExitCode::verificationFailed);
}

}  // namespace arelem::app
