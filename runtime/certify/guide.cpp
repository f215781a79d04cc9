#include "runtime/certify/guide.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::certify {

namespace {
constexpr std::uint64_t pollMask = 0xFF;

/// How far a gap is outside the band.
double excess(double gap, const Allowed& a) {
  return std::max({0.0, -a.inner - gap, gap - a.outer});
}

class GuideProof {
 public:
  GuideProof(const GuideTask& task, double side, std::span<const Location> path)
      : task_(task),
        path_(path),
        probe_(makeProbe(task.surface.surface, {task.cutter, side, task.thick})) {
    result_.side = side;
    result_.verdict.least = {unbounded, unbounded, 0.0};
    result_.verdict.greatest = {-unbounded, -unbounded, 0.0};
  }

  GuideResult run(const InterruptFlag* interrupted) {
    begin();
    Node first;
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) {
      const Chord chord(path_[i].toolEnd, path_[i + 1].toolEnd, path_[i].axis, path_[i + 1].axis);
      probe_->take(chord);
      first = i == 0 ? probe_->at(0.0) : probe_->resume(first);
      const Allowed allowed = allowedFor(i);
      Verdict verdict = prove(*probe_, allowed, first);
      if (!verdict.good() && probe_->widen()) {
        first = probe_->at(0.0);
        verdict = prove(*probe_, allowed, first);
      }
      take(verdict, i, chord);
      if ((i & pollMask) == 0 && interrupted != nullptr &&
          interrupted->load(std::memory_order_relaxed)) {
        break;
      }
    }
    return result_;
  }

 private:
  /// The contact of the whole cutter where the motion begins.
  void begin() {
    const Location& start = path_.front();
    probe_->take(Chord(start.toolEnd, start.toolEnd, start.axis, start.axis));
    probe_->widen();
    const Node node = probe_->at(0.0);
    result_.firstNormal = node.normal;
    result_.startGap = node.high;
  }

  /// A motion may begin a little outside of its band; its first cut vector leads back.
  [[nodiscard]] Allowed allowedFor(std::size_t i) const {
    Allowed a = task_.allowed;
    const double gap = result_.startGap;
    if (i == 0 && excess(gap, a) <= task_.startSlack) {
      a.inner = std::max(a.inner, -gap);
      a.outer = std::max(a.outer, gap);
    }
    return a;
  }

  void take(const Verdict& v, std::size_t vector, const Chord& chord) {
    Verdict& all = result_.verdict;
    all.nodes += v.nodes;
    worsen(all.inner, v.inner);
    worsen(all.outer, v.outer);
    all.least.proven = std::min(all.least.proven, v.least.proven);
    all.greatest.proven = std::max(all.greatest.proven, v.greatest.proven);
    if (v.least.measured < all.least.measured) {
      all.least.measured = v.least.measured;
      result_.leastVector = vector;
      result_.leastPlace = chord.toolEnd(v.least.at);
    }
    if (v.greatest.measured > all.greatest.measured) {
      all.greatest.measured = v.greatest.measured;
      result_.greatestVector = vector;
      result_.greatestPlace = chord.toolEnd(v.greatest.at);
    }
  }

  static void worsen(Verdict::State& worst, Verdict::State state) {
    using State = Verdict::State;
    if (state == State::refuted || (state == State::undecided && worst == State::proven)) {
      worst = state;
    }
  }

  const GuideTask& task_;
  std::span<const Location> path_;
  std::unique_ptr<Probe> probe_;
  GuideResult result_;
};

/// The gap at the beginning of a path on one side of the surface.
double startGap(const GuideTask& task, double side, std::span<const Location> path) {
  return touch(task.surface.surface, {task.cutter, side, task.thick}, path.front(), task.allowed)
      .high;
}
}  // namespace

Touch touch(const surface::AnySurface& surface,
            const Relation& relation,
            const Location& at,
            const Allowed& allowed) {
  const auto probe = makeProbe(surface, relation);
  probe->take(Chord(at.toolEnd, at.toolEnd, at.axis, at.axis));
  probe->widen();
  Node n = probe->at(0.0);
  if (n.low < -allowed.inner - allowed.slack && n.high >= -allowed.inner - allowed.slack) {
    probe->settle(n, -allowed.inner - allowed.slack);
  }
  return {n.low, n.high, n.normal};
}

GuideResult proveGuide(const GuideTask& task,
                       std::span<const Location> path,
                       const InterruptFlag* interrupted) {
  const double plus = startGap(task, 1.0, path);
  const double minus = startGap(task, -1.0, path);
  const double first = std::abs(plus) <= std::abs(minus) ? 1.0 : -1.0;
  GuideResult result = GuideProof(task, first, path).run(interrupted);
  const bool either = task.cutter == nullptr ||
                      std::abs(std::abs(plus) - std::abs(minus)) <= tolerance::coincidence;
  if (either && !result.verdict.good()) {
    const GuideResult other = GuideProof(task, -first, path).run(interrupted);
    if (other.verdict.good()) {
      return other;
    }
  }
  return result;
}

}  // namespace arelem::certify
