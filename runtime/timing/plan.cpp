#include "runtime/timing/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "ir/space/smooth_tolerance.h"
#include "runtime/timing/ordered_marks.h"

namespace arelem::timing {

namespace {

constexpr int mostRepairs = 200;

Plan::Interval intervalOf(
    double place, double length, double from, double to, double most, const Limits& limits) {
  Plan::Interval one;
  one.place = place;
  one.length = length;
  one.from = from;
  one.to = to;
  one.mostSpeed = most;
  one.peak = peakBetween(from, to, length, most, limits);
  one.rise = Transition(from, one.peak, limits);
  one.fall = Transition(one.peak, to, limits);
  one.cruise = std::max(length - one.rise.distance() - one.fall.distance(), 0.0);
  return one;
}

/// Chooses the nodes. Limits are looked at from the lowest to the highest: where the profile so far
/// passes one, a node is set there at the speed of the limit; its neighbors are slower, so the
/// change to and from them fits. Where a node does not fit, the peak of the interval is cut.
class NodeChooser {
 public:
  NodeChooser(const SpeedLimits& path, const std::vector<double>& places, const Limits& limits)
      : path_(path),
        places_(places),
        limits_(limits),
        count_(path.lengths.size()),
        marks_(count_ + 1),
        speed_(count_ + 1, 0.0),
        slots_(count_ + 1, 0) {}

  std::vector<Plan::Interval> run() {
    marks_.insert(0);
    marks_.insert(count_);
    speed_[0] = endSpeed(0, path_.speeds.front());
    speed_[count_] = endSpeed(count_, path_.speeds.back());
    joinEnds();
    const double most = *std::max_element(path_.speeds.begin(), path_.speeds.end());
    connect(0, count_, most);
    for (const Candidate& c : candidates()) {
      c.isPiece ? holdPiece(c.index) : holdCorner(c.index);
    }
    return repaired();
  }

 private:
  struct Candidate {
    double speed;
    std::size_t index;
    bool isPiece;
  };

  [[nodiscard]] double endSpeed(std::size_t corner, double piece) const {
    return std::min(path_.corners[corner], piece);
  }
  [[nodiscard]] bool isFree(std::size_t node) const {
    return path_.freeEnds && (node == 0 || node == count_);
  }

  /// Two ends whose speeds are too different for the path between them: the faster one gives way.
  void joinEnds() {
    fit(0, count_);
    fit(count_, 0);
  }
  void fit(std::size_t slow, std::size_t fast) {
    const double distance = std::abs(places_[fast] - places_[slow]);
    speed_[fast] =
        std::min(speed_[fast],
                 std::max(speed_[slow], reachable(speed_[slow], distance, speed_[fast], limits_)));
  }

  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::vector<Candidate> all;
    all.reserve(2 * count_);
    for (std::size_t i = 0; i < count_; ++i) {
      all.push_back({path_.speeds[i], i, true});
      if (i > 0 && path_.corners[i] < std::min(path_.speeds[i - 1], path_.speeds[i])) {
        all.push_back({path_.corners[i], i, false});
      }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Candidate& a, const Candidate& b) { return a.speed < b.speed; });
    return all;
  }

  /// The interval that begins at a node.
  [[nodiscard]] Plan::Interval& after(std::size_t node) {
    if (slots_[node] == 0) {
      intervals_.emplace_back();
      slots_[node] = static_cast<std::uint32_t>(intervals_.size());
    }
    return intervals_[slots_[node] - 1];
  }

  void connect(std::size_t i, std::size_t j, double most) {
    after(i) = intervalOf(places_[i], places_[j] - places_[i], speed_[i], speed_[j], most, limits_);
  }
  void cutPeak(std::size_t i, std::size_t j, double speed) {
    connect(i, j, std::min(after(i).mostSpeed, speed));
  }

  /// Sets a node at `corner`; false when a faster neighbor could not be reached from it.
  bool insert(std::size_t corner, double wanted) {
    const std::size_t i = marks_.before(corner);
    const std::size_t j = marks_.after(corner);
    double speed = wanted;
    for (const std::size_t neighbor : {i, j}) {
      if (isFree(neighbor)) {
        continue;
      }
      const double distance = std::abs(places_[corner] - places_[neighbor]);
      speed = std::min(speed, reachable(speed_[neighbor], distance, wanted, limits_));
    }
    for (const std::size_t neighbor : {i, j}) {
      const double distance = std::abs(places_[corner] - places_[neighbor]);
      if (!isFree(neighbor) && speed < speed_[neighbor] &&
          changeDistance(speed, speed_[neighbor], limits_) > distance) {
        return false;
      }
    }
    const double most = after(i).mostSpeed;
    marks_.insert(corner);
    speed_[corner] = speed;
    for (const std::size_t neighbor : {i, j}) {
      if (isFree(neighbor)) {
        fit(corner, neighbor);
      }
    }
    connect(i, corner, most);
    connect(corner, j, most);
    return true;
  }

  void holdCorner(std::size_t corner) {
    if (marks_.contains(corner)) {
      return;
    }
    const std::size_t i = marks_.before(corner);
    const double x = places_[corner] - places_[i];
    const double limit = path_.corners[corner];
    if (after(i).exceeds(limit * (1.0 + tolerance::planSlack), x, x) && !insert(corner, limit)) {
      cutPeak(i, marks_.after(corner), limit);
    }
  }

  /// The node at the start of the interval that piece k lies in.
  [[nodiscard]] std::size_t intervalOfPiece(std::size_t k) const {
    return marks_.contains(k) ? k : marks_.before(k);
  }

  void holdPiece(std::size_t k) {
    const std::size_t i = intervalOfPiece(k);
    const std::size_t j = marks_.after(k);
    const double limit = path_.speeds[k];
    const double allowed = limit * (1.0 + tolerance::planSlack);
    const double a = places_[k] - places_[i];
    const double b = places_[k + 1] - places_[i];
    if (!after(i).exceeds(allowed, a, b)) {
      return;
    }
    const bool startHigh = k != i && after(i).exceeds(allowed, a, a);
    const bool endHigh = k + 1 != j && after(i).exceeds(allowed, b, b);
    bool done = (startHigh || endHigh);
    if (startHigh) {
      done = insert(k, limit) && done;
    }
    if (endHigh) {
      done = insert(k + 1, limit) && done;
    }
    const std::size_t from = intervalOfPiece(k);
    const std::size_t to = marks_.after(k);
    // Between the nodes so set the piece is alone or at the slow end: its limit costs no more.
    cutPeak(from, to, limit);
  }

  // A rise that starts later can be faster further on, so what was within a limit before may not be
  // when all nodes are set. The faster neighbor then gives way, until nothing is left to do.
  std::vector<Plan::Interval> repaired() {
    for (int round = 0; round < mostRepairs; ++round) {
      if (!lowered()) {
        break;
      }
      sweep();
    }
    std::vector<Plan::Interval> all;
    double time = 0.0;
    for (std::size_t i = 0; i < count_;) {
      const std::size_t j = marks_.after(i);
      after(i).start = time;
      time += after(i).duration();
      all.push_back(after(i));
      i = j;
    }
    return all;
  }

  /// Lowers peaks and nodes that let a piece or corner be passed too fast. Whether any was.
  bool lowered() {
    bool any = false;
    for (std::size_t i = 0; i < count_;) {
      const std::size_t j = marks_.after(i);
      for (std::size_t k = i; k < j; ++k) {
        any = lower(i, j, places_[k] - places_[i], places_[k + 1] - places_[i], path_.speeds[k]) ||
              any;
        if (k > i) {
          const double x = places_[k] - places_[i];
          any = lower(i, j, x, x, path_.corners[k]) || any;
        }
      }
      i = j;
    }
    return any;
  }

  bool lower(std::size_t i, std::size_t j, double a, double b, double limit) {
    if (!after(i).exceeds(limit * (1.0 + 2.0 * tolerance::planSlack), a, b)) {
      return false;
    }
    speed_[i] = std::min(speed_[i], limit);
    speed_[j] = std::min(speed_[j], limit);
    cutPeak(i, j, limit);
    return true;
  }

  void sweep() {
    for (std::size_t i = 0; i < count_;) {
      const std::size_t j = marks_.after(i);
      fit(i, j);
      i = j;
    }
    for (std::size_t j = count_; j > 0;) {
      const std::size_t i = marks_.before(j);
      fit(j, i);
      connect(i, j, after(i).mostSpeed);
      if (j != count_) {
        connect(j, marks_.after(j), after(j).mostSpeed);
      }
      j = i;
    }
  }

  const SpeedLimits& path_;
  const std::vector<double>& places_;
  const Limits& limits_;
  std::size_t count_;
  OrderedMarks marks_;
  std::vector<double> speed_;
  // Far fewer nodes than places: an interval is ten times as large as a place.
  std::vector<std::uint32_t> slots_;  // of the interval behind a node, from 1 on; 0: none
  std::vector<Plan::Interval> intervals_;
};

}  // namespace

double Plan::Interval::duration() const {
  const double flat = cruise > 0.0 && peak > 0.0 ? cruise / peak : 0.0;
  return rise.duration() + flat + fall.duration();
}

Plan::State Plan::Interval::at(double t) const {
  if (t < rise.duration()) {
    const Transition::State s = rise.at(t);
    return {place + s.place, s.speed, s.acceleration};
  }
  const double flat = cruise > 0.0 && peak > 0.0 ? cruise / peak : 0.0;
  const double later = t - rise.duration();
  if (later < flat) {
    return {place + rise.distance() + later * peak, peak, 0.0};
  }
  const Transition::State s = fall.at(std::min(later - flat, fall.duration()));
  return {place + rise.distance() + cruise + s.place, s.speed, s.acceleration};
}

bool Plan::Interval::exceeds(double speed, double a, double b) const {
  if (peak <= speed) {
    return false;
  }
  const double down = length - fall.distance();
  if (b < rise.distance()) {
    return speed < from || rise.placeOf(speed) < b;
  }
  return a <= down || speed < to || down + fall.placeOf(speed) > a;
}

double Plan::Interval::timeAt(double x) const {
  const double top = rise.distance();
  if (x < top) {
    return rise.timeAt(x);
  }
  const double down = top + cruise;
  if (x <= down) {
    return rise.duration() + (peak > 0.0 ? (x - top) / peak : 0.0);
  }
  const double flat = cruise > 0.0 && peak > 0.0 ? cruise / peak : 0.0;
  return rise.duration() + flat + fall.timeAt(std::min(x - down, fall.distance()));
}

Plan::Plan(SpeedLimits path, const Limits& limits) : limits_(limits) {
  places_.assign(path.lengths.size() + 1, 0.0);
  std::partial_sum(path.lengths.begin(), path.lengths.end(), places_.begin() + 1);
  if (!path.lengths.empty()) {
    intervals_ = NodeChooser(path, places_, limits_).run();
    total_ = intervals_.back().start + intervals_.back().duration();
  }
  lengths_ = std::move(path.lengths);
}

std::vector<double> Plan::pieceTimes() const {
  std::vector<double> times(lengths_.size());
  std::size_t which = 0;
  double before = 0.0;
  for (std::size_t k = 0; k < lengths_.size(); ++k) {
    const double end = places_[k + 1];
    while (which + 1 < intervals_.size() && intervals_[which + 1].place <= end) {
      ++which;
    }
    const Interval& one = intervals_[which];
    const double now = k + 1 == lengths_.size() ? total_ : one.start + one.timeAt(end - one.place);
    times[k] = now - before;
    before = now;
  }
  return times;
}

Plan::State Plan::at(double t) const {
  const auto next = std::upper_bound(intervals_.begin(), intervals_.end(), t,
                                     [](double at, const Interval& one) { return at < one.start; });
  const Interval& one = next == intervals_.begin() ? intervals_.front() : *(next - 1);
  return one.at(t - one.start);
}

}  // namespace arelem::timing
