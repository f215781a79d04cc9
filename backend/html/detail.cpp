#include "backend/html/detail.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ir/space/vector.h"

namespace arelem::backend {

namespace {
constexpr double always = std::numeric_limits<double>::infinity();

/// Of one path, block by block.
class Thinner {
 public:
  Thinner(const std::vector<double>& places, const std::vector<std::uint8_t>& kinds, Detail& detail)
      : places_(places), kinds_(kinds), detail_(detail), turn_(kinds.size(), 0.0) {
    findTurns();
  }

  /// Levels of the locations between two that every level has. Each chord that is split hands down
  /// how far off it was: a location cannot be in a level that does not have the ends of its chord.
  void block(std::size_t first, std::size_t last) {
    detail_.levels[first] = detail_.levels[last] = Detail::highest;
    chords_.assign(1, {first, last, always});
    while (!chords_.empty()) {
      const Chord chord = chords_.back();
      chords_.pop_back();
      const auto [at, off] = furthest(chord.first, chord.last);
      if (at == 0) {
        continue;
      }
      const double kept = std::min(off, chord.off);
      const int level = levelOf(kept);
      if (level == 0) {
        continue;  // all of the locations between are in level 0 only
      }
      detail_.levels[at] = static_cast<std::uint8_t>(level);
      chords_.push_back({chord.first, at, kept});
      chords_.push_back({at, chord.last, kept});
    }
  }

 private:
  struct Chord {
    std::size_t first, last;
    double off;
  };

  [[nodiscard]] Vec3 place(std::size_t i) const {
    return {places_[3 * i], places_[3 * i + 1], places_[3 * i + 2]};
  }

  [[nodiscard]] bool breaksAt(std::size_t i) const {
    return static_cast<SceneMove>(kinds_[i] & 15U) == SceneMove::start;
  }

  /// Where one kind of move ends and another begins: the length of the shorter of the two runs.
  void findTurns() {
    std::size_t turn = 0;  // the last one
    double run = 0.0, before = always;
    for (std::size_t i = 1; i < kinds_.size(); ++i) {
      if (breaksAt(i)) {
        turn_[i - 1] = turn_[i] = always;
        closeRun(turn, before, run);
        turn = i;
        run = 0.0;
        before = always;
        continue;
      }
      if (kinds_[i] != kinds_[i - 1] && i - 1 != turn) {
        closeRun(turn, before, run);
        turn = i - 1;
        before = run;
        run = 0.0;
      }
      run += (place(i) - place(i - 1)).norm();
    }
    closeRun(turn, before, run);
  }

  void closeRun(std::size_t turn, double before, double after) {
    turn_[turn] = std::max(turn_[turn], std::min(before, after));
  }

  /// The location between two that is furthest from their chord, and how far; 0 where there is
  /// none.
  [[nodiscard]] std::pair<std::size_t, double> furthest(std::size_t first, std::size_t last) const {
    const Vec3 start = place(first), way = place(last) - start;
    const double length2 = way.squaredNorm();
    std::pair<std::size_t, double> result{0, -1.0};
    for (std::size_t i = first + 1; i < last; ++i) {
      const Vec3 from = place(i) - start;
      const double t = length2 > 0.0 ? std::clamp(from.dot(way) / length2, 0.0, 1.0) : 0.0;
      const double off = std::max((from - t * way).norm(), turn_[i]);
      if (off > result.second) {
        result = {i, off};
      }
    }
    return result;
  }

  [[nodiscard]] int levelOf(double off) const {
    int level = 0;
    while (level < Detail::highest && off > detail_.tolerance(level + 1)) {
      ++level;
    }
    return level;
  }

  const std::vector<double>& places_;
  const std::vector<std::uint8_t>& kinds_;
  Detail& detail_;
  std::vector<double> turn_;
  std::vector<Chord> chords_;
};

/// The box of the locations from `first` to `last`, rounded outward.
void addBox(const std::vector<double>& places,
            std::size_t first,
            std::size_t last,
            std::vector<float>& boxes) {
  constexpr float far = std::numeric_limits<float>::infinity();
  for (const bool high : {false, true}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double value = places[3 * first + axis];
      for (std::size_t i = first; i <= last; ++i) {
        const double v = places[3 * i + axis];
        value = high ? std::max(value, v) : std::min(value, v);
      }
      boxes.push_back(std::nextafter(static_cast<float>(value), high ? far : -far));
    }
  }
}

double sizeOf(const std::vector<double>& places) {
  Vec3 low = Vec3::Constant(always), high = -low;
  for (std::size_t i = 0; i + 3 <= places.size(); i += 3) {
    const Vec3 p(places[i], places[i + 1], places[i + 2]);
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return places.empty() ? 0.0 : (high - low).norm();
}
}  // namespace

double Detail::tolerance(int level) const {
  return level == 0 ? 0.0 : std::ldexp(size / finest, level - 1);
}

Detail detailOf(const std::vector<double>& places, const std::vector<std::uint8_t>& kinds) {
  Detail detail;
  detail.size = sizeOf(places);
  detail.levels.assign(kinds.size(), 0);
  if (kinds.empty()) {
    return detail;
  }
  Thinner thinner(places, kinds, detail);
  for (std::size_t first = 0; first == 0 || first + 1 < kinds.size();
       first += Detail::blockLength) {
    const std::size_t last = std::min(first + Detail::blockLength, kinds.size() - 1);
    thinner.block(first, last);
    addBox(places, first, last, detail.boxes);
  }
  return detail;
}

}  // namespace arelem::backend
