#include "runtime/stencil/order.h"

#include <algorithm>
#include <limits>

#include "ir/space/stencil_tolerance.h"
#include "runtime/stencil/message.h"

namespace arelem::stencil {

namespace {
Vec2 beginOf(const Run& run) {
  return middleOf(run.lines.front());
}
Vec2 endOf(const Run& run) {
  return middleOf(run.lines.back());
}

double lengthOf(const std::vector<Visit>& visits, const Vec2& start) {
  double length = 0.0;
  Vec2 at = start;
  for (const Visit& visit : visits) {
    length += (visit.begin - at).norm();
    at = visit.end;
  }
  return length;
}

std::vector<Visit> nearestNext(std::vector<Visit> left, const Vec2& start) {
  std::vector<Visit> visits;
  Vec2 at = start;
  while (!left.empty()) {
    std::size_t best = 0;
    bool turn = false;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double forwards = (left[i].begin - at).norm();
      const double backwards = (left[i].end - at).norm();
      if (std::min(forwards, backwards) < least) {
        least = std::min(forwards, backwards);
        best = i;
        turn = backwards < forwards;
      }
    }
    visits.push_back(turn ? left[best].turned() : left[best]);
    at = visits.back().end;
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return visits;
}

/// Turns the part [i, k] of the order round when that is shorter.
bool turnPart(std::vector<Visit>& v, std::size_t i, std::size_t k, const Vec2& start) {
  const Vec2 before = i == 0 ? start : v[i - 1].end;
  double old = (v[i].begin - before).norm();
  double made = (v[k].end - before).norm();
  if (k + 1 < v.size()) {
    old += (v[k + 1].begin - v[k].end).norm();
    made += (v[k + 1].begin - v[i].begin).norm();
  }
  if (!(made < old * (1.0 - tolerance::shorterTravel))) {
    return false;
  }
  std::reverse(v.begin() + static_cast<std::ptrdiff_t>(i),
               v.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  for (std::size_t j = i; j <= k; ++j) {
    v[j] = v[j].turned();
  }
  return true;
}

void exchange(std::vector<Visit>& visits, const Vec2& start) {
  constexpr int mostRounds = 50;
  for (int round = 0; round < mostRounds; ++round) {
    bool better = false;
    for (std::size_t i = 0; i < visits.size(); ++i) {
      for (std::size_t k = i; k < visits.size(); ++k) {
        better = turnPart(visits, i, k, start) || better;
      }
    }
    if (!better) {
      return;
    }
  }
}
}  // namespace

double travelOf(const std::vector<Run>& runs, const Vec2& start) {
  double length = 0.0;
  Vec2 at = start;
  for (const Run& run : runs) {
    length += (beginOf(run) - at).norm();
    at = endOf(run);
  }
  return length;
}

std::vector<Visit> shortest(std::vector<Visit> given, const Vec2& start) {
  std::vector<Visit> near = nearestNext(given, start);
  exchange(near, start);
  exchange(given, start);
  return lengthOf(near, start) < lengthOf(given, start) ? near : given;
}

void shorten(std::vector<Run>& runs, const Vec2& start) {
  std::vector<Visit> given;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    given.push_back({i, beginOf(runs[i]), endOf(runs[i]), false});
  }
  std::vector<Run> ordered;
  for (const Visit& visit : shortest(std::move(given), start)) {
    ordered.push_back(std::move(runs[visit.run]));
    if (visit.backwards) {
      std::reverse(ordered.back().lines.begin(), ordered.back().lines.end());
      ordered.back().backwards = !ordered.back().backwards;
    }
  }
  runs = std::move(ordered);
}

}  // namespace arelem::stencil
