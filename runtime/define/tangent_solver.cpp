// Tangents of the curvature-continuous chain of cubics.
//
// In the frame of its chord of length L a cubic with end slopes s, e is
//   v = a t^3 + b t^2 + s t,  a = (s + e)/L^2,  b = -(2 s + e)/L,
// so v''(0) = -2 (2 s + e)/L and v''(L) = 2 (s + 2 e)/L; the curvature is v''/(1 + v'^2)^(3/2).
#include "runtime/define/tangent_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ir/diag/geometry.h"
#include "ir/space/tolerance.h"

namespace arelem::define {

namespace {

constexpr int mostSteps = 100;
constexpr int mostHalvings = 40;
constexpr int mostSweeps = 40;
constexpr double degree = std::numbers::pi / 180.0;

/// A curvature with its derivatives by the tangent angles at both ends of the chord.
struct Curvature {
  double value = 0.0, byStart = 0.0, byEnd = 0.0;
};

/// factor * (2 here + there) / (1 + here^2)^(3/2): `here` is the slope at the place asked for,
/// `there` at the other end of the chord.
struct Weighted {
  double curvature, byHere, byThere;  ///< derivatives by the angles
};
Weighted weigh(double here, double there, double factor) {
  const double h = 1.0 + here * here;
  const double root = std::sqrt(h);
  const double bend = factor * (2.0 * here + there);
  const double curvature = bend / (h * root);
  // d here/d angle = 1 + here^2 = h
  return {curvature, 2.0 * factor / root - 3.0 * here * curvature,
          factor * (1.0 + there * there) / (h * root)};
}

Curvature atStart(const Chord& chord, double startAngle, double endAngle) {
  const Weighted w = weigh(std::tan(startAngle - chord.angle), std::tan(endAngle - chord.angle),
                           -2.0 / chord.length);
  return {w.curvature, w.byHere, w.byThere};
}

Curvature atEnd(const Chord& chord, double startAngle, double endAngle) {
  const Weighted w = weigh(std::tan(endAngle - chord.angle), std::tan(startAngle - chord.angle),
                           2.0 / chord.length);
  return {w.curvature, w.byThere, w.byHere};
}

class Solver {
 public:
  Solver(const std::vector<Chord>& chords, const std::vector<bool>& fixed)
      : chords_(chords), fixed_(fixed), size_(fixed.size()) {}

  Result<std::optional<std::vector<double>>> run(const std::vector<double>& guess) {
    if (!allowed(guess)) {
      return refusal(guess);
    }
    std::vector<double> angles = guess;
    if (!newton(angles)) {
      return std::optional<std::vector<double>>();
    }
    return std::optional(std::move(angles));
  }

  RelaxedTangents relax(std::vector<double> angles) {
    for (int sweep = 0; sweep < mostSweeps; ++sweep) {
      for (std::size_t i = 0; i < size_; ++i) {
        if (!fixed_[i]) {
          relaxAt(angles, i);
        }
      }
    }
    const bool smooth = newton(angles);
    return {std::move(angles), smooth ? 0.0 : worstJump_, worst_};
  }

 private:
  /// The longest halved Newton step of one angle that lessens its own jump.
  void relaxAt(std::vector<double>& angles, std::size_t i) {
    resize();
    fillRow(angles, i);
    const double jump = std::abs(residual_[i]);
    const double before = angles[i];
    const double step = residual_[i] / main_[i];
    double fraction = 1.0;
    for (int half = 0; half < mostHalvings / 4; ++half, fraction *= 0.5) {
      for (const double sense : {1.0, -1.0}) {  // where the derivative has the wrong sign
        angles[i] = before - sense * fraction * step;
        if (!allowedAt(angles, i)) {
          continue;
        }
        fillRow(angles, i);
        if (std::abs(residual_[i]) < jump) {
          return;
        }
      }
    }
    angles[i] = before;
  }

  [[nodiscard]] bool allowedAt(const std::vector<double>& angles, std::size_t i) const {
    const double limit = largestTangentAngle * degree;
    return (i == 0 || std::abs(angles[i] - chords_[i - 1].angle) < limit) &&
           (i + 1 == size_ || std::abs(angles[i] - chords_[i].angle) < limit);
  }

  void resize() {
    for (auto* row : {&residual_, &below_, &main_, &above_}) {
      row->resize(size_);
    }
  }

  /// A jump far below the curvatures' own rounding cannot be reached.
  [[nodiscard]] double goal() const { return 8.0 * tolerance::rounding * largestCurvature_; }

  /// Improves the angles until the curvature jumps vanish; false where it cannot.
  bool newton(std::vector<double>& angles) {
    double jump = evaluate(angles);
    for (int step = 0; step < mostSteps && jump > goal(); ++step) {
      if (!descend(angles, solveTridiagonal(), jump)) {
        break;
      }
    }
    return jump <= tolerance::curvatureJump * largestCurvature_;
  }

  /// The longest halved step along `change` that lessens the largest jump.
  bool descend(std::vector<double>& angles, const std::vector<double>& change, double& jump) {
    double fraction = 1.0;
    for (int half = 0; half < mostHalvings; ++half, fraction *= 0.5) {
      std::vector<double> trial = angles;
      for (std::size_t i = 0; i < size_; ++i) {
        trial[i] -= fraction * change[i];
      }
      if (!allowed(trial)) {
        continue;
      }
      const double trialJump = evaluate(trial);
      if (trialJump < jump) {
        angles = std::move(trial);
        jump = trialJump;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool allowed(const std::vector<double>& angles) const {
    const double limit = largestTangentAngle * degree;
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      if (std::abs(angles[i] - chords_[i].angle) >= limit ||
          std::abs(angles[i + 1] - chords_[i].angle) >= limit) {
        return false;
      }
    }
    return true;
  }

  Failure refusal(const std::vector<double>& angles) const {
    std::size_t at = 0;
    std::size_t other = 1;
    double worst = 0.0;
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      for (const std::size_t end : {i, i + 1}) {
        const double off = std::abs(angles[end] - chords_[i].angle);
        if (off > worst) {
          worst = off;
          at = end;
          other = end == i ? i + 1 : i;
        }
      }
    }
    return fail(diag::TangentAcrossChord, at + 1, worst / degree, other + 1, largestTangentAngle);
  }

  /// Fills the residuals and the three diagonals; returns the largest residual.
  double evaluate(const std::vector<double>& angles) {
    residual_.assign(size_, 0.0);
    below_.assign(size_, 0.0);
    main_.assign(size_, 1.0);
    above_.assign(size_, 0.0);
    largestCurvature_ = 0.0;
    worstJump_ = 0.0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (!fixed_[i]) {
        fillRow(angles, i);
      }
      if (std::abs(residual_[i]) > worstJump_) {
        worstJump_ = std::abs(residual_[i]);
        worst_ = i;
      }
    }
    return worstJump_;
  }

  void fillRow(const std::vector<double>& angles, std::size_t i) {
    if (i == 0 || i + 1 == size_) {
      const std::size_t chord = i == 0 ? 0 : i - 1;
      const std::size_t neighbor = i == 0 ? 1 : i - 1;
      // Scaled to a curvature so that all residuals have one unit.
      const double scale = 1.0 / chords_[chord].length;
      residual_[i] = scale * (angles[i] + angles[neighbor] - 2.0 * chords_[chord].angle);
      main_[i] = scale;
      (i == 0 ? above_[i] : below_[i]) = scale;
      largestCurvature_ = std::max(largestCurvature_, scale);
      return;
    }
    const Curvature before = atEnd(chords_[i - 1], angles[i - 1], angles[i]);
    const Curvature behind = atStart(chords_[i], angles[i], angles[i + 1]);
    residual_[i] = before.value - behind.value;
    below_[i] = before.byStart;
    main_[i] = before.byEnd - behind.byStart;
    above_[i] = -behind.byEnd;
    largestCurvature_ =
        std::max({largestCurvature_, 1.0 / chords_[i - 1].length, 1.0 / chords_[i].length});
  }

  /// Solves the system with the residuals as right side, in place (Thomas).
  std::vector<double> solveTridiagonal() {
    std::vector<double> right = residual_;
    std::vector<double> diagonal = main_;
    for (std::size_t i = 1; i < size_; ++i) {
      const double factor = below_[i] / diagonal[i - 1];
      diagonal[i] -= factor * above_[i - 1];
      right[i] -= factor * right[i - 1];
    }
    for (std::size_t i = size_; i-- > 0;) {
      const double later = i + 1 < size_ ? above_[i] * right[i + 1] : 0.0;
      right[i] = (right[i] - later) / diagonal[i];
    }
    return right;
  }

  const std::vector<Chord>& chords_;
  const std::vector<bool>& fixed_;
  std::size_t size_;
  std::vector<double> residual_, below_, main_, above_;
  double largestCurvature_ = 0.0, worstJump_ = 0.0;
  std::size_t worst_ = 0;
};

}  // namespace

Result<std::optional<std::vector<double>>> solveTangents(const std::vector<Chord>& chords,
                                                         const std::vector<bool>& fixed,
                                                         const std::vector<double>& angles) {
  return Solver(chords, fixed).run(angles);
}

RelaxedTangents relaxTangents(const std::vector<Chord>& chords,
                              const std::vector<bool>& fixed,
                              const std::vector<double>& angles) {
  return Solver(chords, fixed).relax(angles);
}

}  // namespace arelem::define
