#include "runtime/certify/guide.h"

#include <algorithm>
#include <cmath>

#include "ir/space/tolerance.h"

namespace arelem::certify {

namespace {
/// How far a gap is outside the band.
double excess(double gap, const Allowed& a) {
  return std::max({0.0, -a.inner - gap, gap - a.outer});
}

}  // namespace

class GuideStream::Proof {
 public:
  Proof(const GuideTask& task, double side, const Location& first)
      : task_(task),
        last_(first),
        probe_(makeProbe(task.surface.surface, {task.cutter, side, task.thick})) {
    result_.side = side;
    result_.verdict.least = {unbounded, unbounded, 0.0};
    result_.verdict.greatest = {-unbounded, -unbounded, 0.0};
    begin();
  }

  void add(const Location& next) {
    const Chord chord = chordTo(next);
    take(proven(chord, node_), count_, chord);
    last_ = next;
    ++count_;
  }
  [[nodiscard]] bool keeps(const Location& next) {
    Node node = node_;
    return proven(chordTo(next), node).good();
  }
  [[nodiscard]] const GuideResult& result() const { return result_; }

 private:
  [[nodiscard]] Chord chordTo(const Location& next) const {
    return {last_.toolEnd, next.toolEnd, last_.axis, next.axis};
  }
  /// `node`: at the last location, and then at the end of the chord.
  Verdict proven(const Chord& chord, Node& node) {
    probe_->take(chord);
    node = count_ == 0 ? probe_->at(0.0) : probe_->resume(node);
    const Allowed allowed = allowedNow();
    if (node.high > allowed.outer + allowed.slack && probe_->widen()) {
      node = probe_->at(0.0);  // the ball end is not what touches
    }
    return prove(*probe_, allowed, node);
  }

  /// The contact of the whole cutter where the motion begins.
  void begin() {
    probe_->take(Chord(last_.toolEnd, last_.toolEnd, last_.axis, last_.axis));
    probe_->widen();
    const Node node = probe_->at(0.0);
    result_.firstNormal = node.normal;
    result_.startGap = node.high;
  }

  /// A motion may begin a little outside of its band; its first cut vector leads back.
  [[nodiscard]] Allowed allowedNow() const {
    Allowed a = task_.allowed;
    const double gap = result_.startGap;
    if (count_ == 0 && excess(gap, a) <= task_.startSlack) {
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
  Location last_;
  std::size_t count_ = 0;
  Node node_;  ///< at the last location
  std::unique_ptr<Probe> probe_;
  GuideResult result_;
};

namespace {

/// The gap at the beginning of a path on one side of the surface.
double startGap(const GuideTask& task, double side, const Location& first) {
  return touch(task.surface.surface, {task.cutter, side, task.thick}, first, task.allowed).high;
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
  return {n.low, n.high, n.normal, n.point - at.toolEnd};
}

GuideStream::GuideStream(GuideTask task, const Location& first)
    : task_(std::make_unique<GuideTask>(std::move(task))) {
  const double plus = startGap(*task_, 1.0, first);
  const double minus = startGap(*task_, -1.0, first);
  const double side = std::abs(plus) <= std::abs(minus) ? 1.0 : -1.0;
  proof_ = std::make_unique<Proof>(*task_, side, first);
  const bool on = task_->cutter == nullptr;
  const bool even = task_->allowed.inner == task_->allowed.outer;
  if (on ? !even : std::abs(std::abs(plus) - std::abs(minus)) <= tolerance::coincidence) {
    other_ = std::make_unique<Proof>(*task_, -side, first);
  }
}

GuideStream::GuideStream(GuideStream&&) noexcept = default;
GuideStream::~GuideStream() = default;

void GuideStream::add(const Location& next) {
  proof_->add(next);
  if (other_ != nullptr) {
    other_->add(next);
    if (!other_->result().verdict.good()) {
      other_.reset();
    }
  }
}

bool GuideStream::keeps(const Location& next) {
  return proof_->keeps(next) || (other_ != nullptr && other_->keeps(next));
}

const GuideResult& GuideStream::result() const {
  const bool other = other_ != nullptr && !proof_->result().verdict.good();
  return (other ? *other_ : *proof_).result();
}

}  // namespace arelem::certify
