#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"
#include "runtime/certify/prove.h"
#include "runtime/motion/gap_cubic.h"
#include "runtime/motion/path.h"

namespace arelem::motion {

namespace {
/// A cut vector that bulges is tried again shorter than this share of it.
constexpr double mostOfBulge = 0.97;
/// What bulges as often at any length from one place does so behind a corner, and is taken: a bulge
/// is less than what a motion that ends there would cost.
constexpr int mostBulges = 4;

/// The gap of one guide along a chord, by cubics between nodes: the ends, the middle, and as many
/// more as it takes where the contact jumps or runs about the cutter.
class ChordFit {
 public:
  ChordFit(Field& field,
           const PathPoint& a,
           const PathPoint& b,
           std::size_t guide,
           double length,
           const certify::Chord* turning)
      : field_(field),
        a_(a),
        turning_(turning),
        length_(length),
        direction_((b.toolEnd - a.toolEnd) / length),
        turn_(turning != nullptr ? Vec3(turning->turn() / length * turning->pole())
                                 : Vec3(Vec3::Zero())),
        first_(node(0.0, a.contacts[guide], a.toolEnd)),
        last_(node(length, b.contacts[guide], b.toolEnd)),
        ends_(first_, last_) {}

  double run(double inner, double outer) {
    inner_ = inner;
    outer_ = outer;
    smooth_ = std::min(smoothShare * (inner + outer), certify::slackOf(inner + outer));
    const Node middle = measure(0.5 * length_);
    middleSlope_ = middle.slope;
    // Where the axis turns the middle alone tells little: as a normal turns next to the tip of a
    // cone or at a knot of a curve, the gap may be foretold there and off beside it.
    const bool smooth = foretold(first_, last_, middle, smooth_);
    isEven_ = smooth;
    const int depth = smooth && turning_ == nullptr ? 0 : deepest;
    isSmooth_ = smooth || foretold(first_, last_, middle, roughShare * (inner + outer));
    consider(first_, middle, depth);
    consider(middle, last_, depth);
    return std::sqrt(squared_);
  }

  /// Where the chord is far too long: how far the gap leaves the line between its ends.
  [[nodiscard]] std::optional<double> farOff() const {
    return squared_ < farTooLong ? std::optional(swerve_) : std::nullopt;
  }
  [[nodiscard]] double middleSlope() const { return middleSlope_; }
  [[nodiscard]] std::array<double, 2> endSlopes() const { return {first_.slope, last_.slope}; }
  /// In the part that sets the factor.
  [[nodiscard]] const std::optional<Path::Ridge>& ridge() const { return ridge_; }
  /// Whether the gap may leave the band outwards next to an end, where its slopes do not foretell
  /// it as closely as the certificate looks: a start at the outer edge, from where it hardly falls.
  [[nodiscard]] bool mayBulge() const {
    const double band = inner_ + outer_;
    const double edge = outer_ - edgeShare * band;
    const double steep = flatShare * band / length_;
    return !isEven_ && first_.gap >= edge && first_.slope > -steep;
  }
  /// Whether the ends foretell the middle.
  [[nodiscard]] bool isSmooth() const { return isSmooth_; }
  /// The curvature next to the end, where the ends do not foretell the middle.
  [[nodiscard]] const std::optional<double>& behind() const { return behind_; }

 private:
  struct Node : GapNode {
    Vec3 normal = Vec3::UnitZ();
  };
  /// Nodes that a cubic foretells but for this share of the band, and for no more than the
  /// certificate allows beyond it, are smooth.
  static constexpr double smoothShare = 2e-3;
  /// What cubics foretell but for this share has the curvature that the slopes at nodes tell.
  static constexpr double roughShare = 0.05;
  /// Of kinks that no cubic foretells what is left of the band may be this share of it.
  static constexpr double kinkShare = 1e-4;
  static constexpr int deepest = 12;
  /// Starts that are nearer to the outer edge than this share of the band are at it.
  static constexpr double edgeShare = 0.01;
  /// Gaps that fall from there by more than this share of the band over the length do not bulge.
  static constexpr double flatShare = 0.5;
  /// Squares of factors below this are those of chords that are far too long: how much so need not
  /// be known well, and kinks may leave this share of the band.
  static constexpr double hopeless = 0.5;
  static constexpr double hopelessShare = 0.02;
  /// Squares of factors of chords that aim at the wrong edge of the band; so many looks tell that.
  static constexpr double farTooLong = 0.1;
  static constexpr int mostLooks = 48;

  [[nodiscard]] Node node(double along, const tool::Contact& c, const Vec3& toolEnd) const {
    const double slope =
        turning_ != nullptr ? slopeAlong(c, toolEnd, direction_, turn_) : c.normal.dot(direction_);
    return {{along, c.gap, slope}, c.normal};
  }
  [[nodiscard]] Path::Ridge ridgeBetween(const Node& a, const Node& b) const {
    const double along = crossing(a, b);
    const double gap = a.gap + (along - a.along) * a.slope;
    const Vec3 place = a_.toolEnd + along * direction_;
    return {0, place, gap, a.slope - b.slope, {a.normal, b.normal}};
  }
  Node measure(double along) {
    ++looks_;
    const Vec3 place = a_.toolEnd + along * direction_;
    const Vec3 axis = turning_ != nullptr ? turning_->axis(along / length_) : a_.axis;
    return node(along, field_.at(place, axis), place);
  }
  /// Whether kinks between two nodes cost next to nothing of the band.
  [[nodiscard]] bool isStraight(const Node& a, const Node& b) const {
    const double length = b.along - a.along;
    // Where the contact jumps right at an end, both slopes may agree though the gap goes otherwise.
    const double astray = (b.gap - a.gap) / length - 0.5 * (a.slope + b.slope);
    const double kink = length * (0.125 * std::abs(a.slope - b.slope) + 0.5 * std::abs(astray));
    const double share = squared_ < hopeless ? hopelessShare : kinkShare;
    return kink <= share * (inner_ + outer_);
  }
  void consider(const Node& a, const Node& b, int depth) {
    depth = squared_ < farTooLong && looks_ >= mostLooks ? 0 : depth;
    if (depth == 0 || isStraight(a, b)) {
      const double squared = squaredFit(ends_, a, b, inner_, outer_);
      if (squared < squared_) {
        squared_ = squared;
        if (squared < farTooLong) {
          swerve_ = swerve(ends_, a, b, inner_, outer_);
        }
        ridge_.reset();
        if (depth > 0 && a.slope > b.slope) {
          ridge_ = ridgeBetween(a, b);
        }
      }
      if (!isSmooth_ && b.along == last_.along) {
        behind_ = (b.slope - a.slope) / (b.along - a.along);
      }
      return;
    }
    const Node between = measure(crossing(a, b));
    const double over = between.gap - ends_.at(between.along);
    const double room = outer_ - ends_.at(between.along);
    if (room < hopeless * over && std::max(0.0, room) / over < squared_) {
      squared_ = std::max(0.0, room) / over;
      swerve_ = -over;
    }
    const int deeper = foretold(a, b, between, smooth_) ? 0 : depth - 1;
    consider(a, between, deeper);
    consider(between, b, deeper);
  }

  Field& field_;
  const PathPoint& a_;
  const certify::Chord* turning_;  ///< null where the axis stays
  double length_;
  Vec3 direction_, turn_;
  Node first_, last_;
  GapLine ends_;
  double inner_ = 0.0, outer_ = 0.0, smooth_ = 0.0, middleSlope_ = 0.0;
  double squared_ = tolerance::farAway;  ///< square of the factor
  double swerve_ = 0.0;                  ///< where that is
  int looks_ = 0;
  std::optional<Path::Ridge> ridge_;
  std::optional<double> behind_;
  bool isSmooth_ = true, isEven_ = true;
};
}  // namespace

/// One look at the middle, which most chords that are too long do not stand; then the proof.
double Path::fitFacets(std::size_t guide, const PathPoint& a, const PathPoint& b) {
  const Guide& g = guides[guide];
  // A start outside its band by the slack allowed there must not stop the motion.
  const double inner = std::max({g.inner, -a.contacts[guide].gap, -b.contacts[guide].gap});
  const double outer = std::max({g.outer, a.contacts[guide].gap, b.contacts[guide].gap});
  const certify::Chord straight(a.toolEnd, b.toolEnd, a.axis, b.axis);
  const double gap = g.field->at(straight.toolEnd(0.5), straight.axis(0.5)).gap;
  Judgement judgement = judgeGap(gap, inner, outer);
  if (judgement.miss == 0) {
    judgement = g.field->judge(straight, inner, outer);
  }
  misses[guide] = judgement.miss;
  return judgement.factor;
}

double Path::fitBulge(
    std::size_t guide, const PathPoint& a, const PathPoint& b, double inner, double outer) {
  if (a.toolEnd != bulges_.from) {
    bulges_ = {a.toolEnd, 0};
  }
  if (bulges_.count >= mostBulges) {
    return tolerance::farAway;
  }
  const certify::Chord chord(a.toolEnd, b.toolEnd, a.axis, b.axis);
  const double slack = certify::slackOf(inner + outer);
  const auto bulge = guides[guide].field->bulge(chord, outer + 0.5 * slack);
  bulges_.count += bulge ? 1 : 0;
  return bulge ? std::min(judgeGap(bulge->gap, inner, outer).factor, mostOfBulge)
               : tolerance::farAway;
}

/// In the corner both contacts have the same gap, and the other guide keeps its own.
double Path::alongRidge(const PathPoint& a, double to) const {
  const Vec3& other = a.contacts[1 - ridge->guide].normal;
  const auto& [n0, n1] = ridge->normals;
  const double det = n0.dot(n1.cross(other));
  const Vec3 way = std::abs(det) > tolerance::nullDirection
                       ? Vec3((to - ridge->gap) / det * (n1.cross(other) + other.cross(n0)))
                       : Vec3(Vec3::Zero());
  return (ridge->place + way - a.toolEnd).dot(a.tangent);
}

double Path::fit(const PathPoint& a, const PathPoint& b) {
  if (a.axis == b.axis) {
    return fitAlong(a, b, nullptr);
  }
  // The proof takes the axis to turn evenly too.
  const certify::Chord evenly(a.toolEnd, b.toolEnd, a.axis, b.axis);
  return fitAlong(a, b, &evenly);
}

double Path::fitAlong(const PathPoint& a, const PathPoint& b, const certify::Chord* turning) {
  const double length = (b.toolEnd - a.toolEnd).norm();
  if (length <= 0.0 && turning == nullptr) {
    return tolerance::farAway;
  }
  // A cut vector that only turns the axis is measured by the angle.
  const double scale = length > 0.0 ? length : (b.axis - a.axis).norm();
  double factor = tolerance::farAway;
  middle.end = b.toolEnd;
  middle.straight = turning == nullptr;
  misses = {0, 0};
  swerves = {};
  ridge.reset();
  for (std::size_t i = 0; i < guides.size(); ++i) {
    if (guides[i].field->flat() && !turning) {
      continue;
    }
    if (guides[i].field->isFaceted()) {
      factor = std::min(factor, fitFacets(i, a, b));
      continue;
    }
    // A start outside its band by the slack allowed there must not stop the motion.
    const double inner = std::max({guides[i].inner, -a.contacts[i].gap, -b.contacts[i].gap});
    const double outer = std::max({guides[i].outer, a.contacts[i].gap, b.contacts[i].gap});
    ChordFit chordFit(*guides[i].field, a, b, i, scale, turning);
    double fits = chordFit.run(inner, outer);
    if (fits >= 1.0 && chordFit.mayBulge()) {
      fits = std::min(fits, fitBulge(i, a, b, inner, outer));
    }
    if (fits < factor) {
      factor = fits;
      ridge = chordFit.ridge();
      if (ridge) {
        ridge->guide = i;
      }
    }
    if (const auto off = chordFit.farOff()) {
      swerves[i] = 8.0 * *off / (scale * scale);
    }
    middle.smooth[i] = chordFit.isSmooth();
    middle.behind[i] = chordFit.behind();
    middle.slope[i] = chordFit.middleSlope();
    middle.ends[i] = chordFit.endSlopes();
  }
  return factor;
}

double Path::fitWithTurn(const PathPoint& a, const PathPoint& b) {
  const double factor = fit(a, b);
  const double sine = axis.isFixed() ? 0.0 : a.axis.cross(b.axis).norm();
  return sine > 0.0 ? std::min(factor, tolerance::axisTurn / std::atan2(sine, a.axis.dot(b.axis)))
                    : factor;
}

}  // namespace arelem::motion
