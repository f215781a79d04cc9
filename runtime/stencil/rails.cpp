#include "runtime/stencil/rails.h"

#include <algorithm>
#include <cmath>

#include "ir/space/stencil_tolerance.h"
#include "ir/space/tolerance.h"
#include "runtime/stencil/cell.h"
#include "runtime/stencil/divide.h"

namespace arelem::stencil {

namespace {
/// Moves the lines between two rails.
class Search {
 public:
  Search(const Rail& first, const Rail& second, double bow)
      : sides_{Side(first), Side(second)}, bow_(bow) {
    for (std::size_t i = 0; i < first.places().size(); ++i) {
      lines_.push_back({first.at(first.places()[i]), second.at(second.places()[i])});
    }
    for (std::size_t i = 0; i + 1 < lines_.size(); ++i) {
      cost_.push_back(leanCost(lines_[i], lines_[i + 1]));
    }
  }

  std::vector<Line> run() {
    if (lines_.size() < 3 || *std::max_element(cost_.begin(), cost_.end()) < tolerance::evenLean) {
      return std::move(lines_);
    }
    double step = 1.0;  // in mean cells
    constexpr int rounds = 44;
    constexpr double finer = 0.88;
    for (int round = 0; round < rounds; ++round, step *= finer) {
      for (std::size_t i = 1; i + 1 < lines_.size(); ++i) {
        for (Side& side : sides_) {
          if (!side.stays[i]) {
            move(side, i, step) || move(side, i, -step);
          }
        }
      }
    }
    return std::move(lines_);
  }

 private:
  struct Side {
    explicit Side(const Rail& r) : rail(&r), given(r.places()), places(r.places()) {
      mean = r.length() / static_cast<double>(std::max<std::size_t>(1, places.size() - 1));
      for (std::size_t i = 0; i < places.size(); ++i) {
        stays.push_back(r.isCorner(i));
      }
    }
    /// The square of how much a cell between two places is longer or shorter than it was.
    [[nodiscard]] double change(std::size_t cell, double from, double to) const {
      const double was = given[cell + 1] - given[cell];
      const double ratio = was > tolerance::coincidence ? (to - from) / was - 1.0 : 0.0;
      return ratio * ratio;
    }
    const Rail* rail;
    std::vector<double> given;
    std::vector<double> places;
    std::vector<bool> stays;
    double mean = 0.0;  // length of a cell
  };

  static double leanCost(const Line& from, const Line& to) {
    const double lean = balanceOf(from, to).lean;
    const double fourth = lean * lean * lean * lean;
    return fourth * fourth;
  }

  /// How far a circle's arc of this length leaves its chord: sqrt(3/8 arc (arc - chord)) for flat
  /// ones.
  static double bowOf(double arc, double chord) {
    return std::sqrt(0.375 * arc * std::max(0.0, arc - chord));
  }

  bool move(Side& side, std::size_t i, double cells) {
    constexpr double shortest = 0.1;  // of a mean cell: none shrinks to nothing
    const double place = side.places[i] + cells * side.mean;
    if (place < side.places[i - 1] + shortest * side.mean ||
        place > side.places[i + 1] - shortest * side.mean) {
      return false;
    }
    Line tried = lines_[i];
    Vec2 Line::*const end = &side == sides_.data() ? &Line::first : &Line::second;
    tried.*end = side.rail->at(place);
    const double before = leanCost(lines_[i - 1], tried);
    const double behind = leanCost(tried, lines_[i + 1]);
    const auto changes = [&](double at) {
      return side.change(i - 1, side.places[i - 1], at) + side.change(i, at, side.places[i + 1]);
    };
    const double gain = cost_[i - 1] + cost_[i] - before - behind;
    if (!(gain > tolerance::unevenDivision * (changes(place) - changes(side.places[i])))) {
      return false;
    }
    const auto bowTo = [&](std::size_t other, const Line& line, double at) {
      return bowOf(std::abs(side.places[other] - at), (line.*end - lines_[other].*end).norm());
    };
    for (const std::size_t other : {i - 1, i + 1}) {
      const double bow = bowTo(other, tried, place);
      if (bow > bow_ && bow > bowTo(other, lines_[i], side.places[i])) {
        return false;
      }
    }
    lines_[i] = tried;
    side.places[i] = place;
    cost_[i - 1] = before;
    cost_[i] = behind;
    return true;
  }

  std::array<Side, 2> sides_;
  std::vector<Line> lines_;
  std::vector<double> cost_;  // of each cell
  double bow_;
};

std::vector<Vec2> pointsOf(const Edge& edge) {
  std::vector<Vec2> points = {firstPoint(edge)};
  for (const Piece& piece : edge.pieces) {
    constexpr int ofACurve = 128;
    const int count = std::holds_alternative<LinePiece>(piece) ? 1 : ofACurve;
    for (int i = 1; i <= count; ++i) {
      points.push_back(pointOf(piece, static_cast<double>(i) / count));
    }
  }
  return points;
}
}  // namespace

void Rail::add(const Vec2& point) {
  along_.push_back(points_.empty() ? 0.0 : along_.back() + (point - points_.back()).norm());
  points_.push_back(point);
}

void Rail::extend(const std::vector<Vec2>& points,
                  const std::vector<double>& shares,
                  bool withoutFirst) {
  add(points.front());
  const double begin = length();
  for (std::size_t i = 1; i < points.size(); ++i) {
    add(points[i]);
  }
  for (std::size_t i = withoutFirst ? 1 : 0; i < shares.size(); ++i) {
    places_.push_back(begin + shares[i] * (length() - begin));
  }
}

Vec2 Rail::at(double place) const {
  const auto next = std::lower_bound(along_.begin() + 1, along_.end() - 1, place);
  const auto i = static_cast<std::size_t>(next - along_.begin());
  const double step = along_[i] - along_[i - 1];
  const double t = step > 0.0 ? std::clamp((place - along_[i - 1]) / step, 0.0, 1.0) : 0.0;
  return points_[i - 1] + t * (points_[i] - points_[i - 1]);
}

bool Rail::isCorner(std::size_t line) const {
  constexpr double smooth = 0.98;  // cosine of 11 degrees; points of a curve turn less
  const double place = places_[line];
  const auto isStep = [&](std::size_t i) {
    return along_[i] - along_[i - 1] > tolerance::coincidence;
  };
  // The last piece that ends at the place, and the first that begins there.
  const auto after = static_cast<std::size_t>(
      std::upper_bound(along_.begin(), along_.end(), place + tolerance::coincidence) -
      along_.begin());
  std::size_t before = after - 1;
  while (before > 0 && !isStep(before)) {
    --before;
  }
  std::size_t behind = after;
  while (behind < along_.size() && !isStep(behind)) {
    ++behind;
  }
  if (before == 0 || behind == along_.size() || along_[before] < place - tolerance::coincidence) {
    return false;  // an end, or within a piece
  }
  const Vec2 in = points_[before] - points_[before - 1];
  const Vec2 out = points_[behind] - points_[behind - 1];
  return in.dot(out) < smooth * in.norm() * out.norm();
}

Edges edgesOf(const Stroke& stroke, double symbolWidth, double gridHeight) {
  const Shape& shape = *stroke.shape;
  Edges edges;
  if (shape.isStraight()) {
    for (const Line& line : shape.lines) {
      edges.first.push_back(line.first);
      edges.second.push_back(line.second);
    }
  } else {
    edges = {pointsOf(shape.first), pointsOf(shape.second)};
    if (shape.firstBack) {
      std::reverse(edges.first.begin(), edges.first.end());
    }
    if (shape.secondBack) {
      std::reverse(edges.second.begin(), edges.second.end());
    }
  }
  for (std::vector<Vec2>* side : {&edges.first, &edges.second}) {
    for (Vec2& point : *side) {
      point = placed(stroke.placing, symbolWidth, gridHeight, point);
    }
    if (stroke.reverse) {
      std::reverse(side->begin(), side->end());
    }
  }
  if (stroke.swap) {
    std::swap(edges.first, edges.second);
  }
  return edges;
}

std::vector<Line> evenlyLeaning(const Rail& first, const Rail& second, double bow) {
  return Search(first, second, bow).run();
}

}  // namespace arelem::stencil
