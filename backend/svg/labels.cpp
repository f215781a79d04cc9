#include "backend/svg/labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace arelem::backend::svg {

namespace {
constexpr double letterWidth = 6.6;
constexpr double letterHeight = 11.0;
constexpr std::size_t longest = 24;
constexpr double cell = 4.0;         // pixels
constexpr std::size_t places = 12;   // along a curve
constexpr double elementGap = 90.0;  // pixels between two named elements of an array
constexpr double clearance = 1.5;    // pixels round a name
/// What a name may cover, for each pixel of its width: about two lines that cross it.
constexpr double mostCovered = 0.55;

bool overlap(const Box& a, const Box& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

bool inside(const Box& a, const Box& area) {
  return a.left >= area.left && a.top >= area.top && a.left + a.width <= area.left + area.width &&
         a.top + a.height <= area.top + area.height;
}

/// Where a name of this width may stand beside a place: right, left, above, below.
std::array<Pixel, 6> besides(const Pixel& p, double width) {
  return {Pixel{p.x + 5, p.y - 4},     {p.x + 5, p.y + 13},          {p.x - width - 5, p.y - 4},
          {p.x - width - 5, p.y + 13}, {p.x - 0.5 * width, p.y - 8}, {p.x - 0.5 * width, p.y + 17}};
}

Box boxOf(const Pixel& at, double width) {
  return {at.x, at.y - letterHeight, width, letterHeight + 2.0};
}
}  // namespace

Labels::Labels(const Box& area)
    : area_(area),
      columns_(static_cast<std::size_t>(std::ceil(area.width / cell)) + 1),
      rows_(static_cast<std::size_t>(std::ceil(area.height / cell)) + 1),
      crossed_(columns_ * rows_, 0) {}

void Labels::avoid(Pixel a, Pixel b, Line line) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double longestLine =
      4.0 * (area_.width + area_.height);  // what is longer lies outside anyway
  const int steps = static_cast<int>(std::ceil(std::min(length, longestLine) / (0.5 * cell)));
  for (int i = 0; i <= steps; ++i) {
    const double t = steps == 0 ? 0.0 : static_cast<double>(i) / steps;
    const double x = (a.x + t * (b.x - a.x) - area_.left) / cell;
    const double y = (a.y + t * (b.y - a.y) - area_.top) / cell;
    if (x >= 0.0 && y >= 0.0 && x < static_cast<double>(columns_) &&
        y < static_cast<double>(rows_)) {
      unsigned char& known =
          crossed_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)];
      known = std::max(known, static_cast<unsigned char>(line));
    }
  }
}

/// `box` lies in the area.
unsigned Labels::cost(const Box& box) const {
  const auto column = static_cast<std::size_t>((box.left - area_.left) / cell);
  const auto row = static_cast<std::size_t>((box.top - area_.top) / cell);
  const auto lastColumn = static_cast<std::size_t>((box.left + box.width - area_.left) / cell);
  const auto lastRow = static_cast<std::size_t>((box.top + box.height - area_.top) / cell);
  unsigned sum = 0;
  for (std::size_t r = row; r <= lastRow; ++r) {
    for (std::size_t c = column; c <= lastColumn; ++c) {
      sum += crossed_[r * columns_ + c];
    }
  }
  return sum;
}

void Labels::add(const std::string& words, std::vector<Pixel> anchors) {
  if (!words.empty() && words.size() <= longest && requests_.size() < most) {
    requests_.push_back({words, std::move(anchors), false, ""});
  }
}

void Labels::addFirst(const std::string& words, const Pixel& anchor) {
  requests_.insert(requests_.begin(), {words, {anchor}, true, ""});
}

void Labels::addAlong(const std::string& words, const std::vector<Pixel>& curve) {
  std::vector<Pixel> anchors;
  for (std::size_t k = 0; k < places && !curve.empty(); ++k) {
    // From a third on, going round.
    anchors.push_back(curve[(curve.size() / 3 + k * curve.size() / places) % curve.size()]);
  }
  add(words, std::move(anchors));
}

void Labels::addElement(const std::string& array, const std::string& words, const Pixel& anchor) {
  const std::size_t before = requests_.size();
  add(words, {anchor});
  if (requests_.size() > before) {
    requests_.back().array = array;
  }
}

std::optional<Labels::Place> Labels::placeOf(const Request& request,
                                             const std::vector<Box>& taken) const {
  const double width = letterWidth * static_cast<double>(request.words.size());
  std::optional<Place> best;
  for (const Pixel& anchor : request.anchors) {
    for (const Pixel& at : besides(anchor, width)) {
      const Box box = boxOf(at, width);
      if (!inside(box, area_) || std::any_of(taken.begin(), taken.end(), [&](const Box& other) {
            return overlap(other, box);
          })) {
        continue;
      }
      const unsigned covered = cost(box);
      if (!best || covered < best->cost) {
        best = Place{at, covered};
      }
    }
  }
  return best;
}

std::vector<std::string> Labels::draw(Canvas& canvas) {
  std::vector<std::string> left;
  std::vector<Box> taken;
  std::multimap<std::string, Pixel> elements;
  for (const Request& request : requests_) {
    const auto [first, last] = elements.equal_range(request.array);
    const Pixel anchor = request.anchors.empty() ? Pixel() : request.anchors.front();
    const bool thinned = !request.array.empty() && std::any_of(first, last, [&](const auto& other) {
      return std::hypot(other.second.x - anchor.x, other.second.y - anchor.y) < elementGap;
    });
    if (thinned) {
      continue;
    }
    const std::optional<Place> place = placeOf(request, taken);
    const double width = letterWidth * static_cast<double>(request.words.size());
    if (!place || (!request.wrong && place->cost > mostCovered * width)) {
      left.push_back(request.words);
      continue;
    }
    const Box box = boxOf(place->at, width);
    taken.push_back({box.left - clearance, box.top - clearance, box.width + 2 * clearance,
                     box.height + 2 * clearance});
    if (!request.array.empty()) {
      elements.emplace(request.array, anchor);
    }
    drawn_.push_back(request.words);
    canvas.text(place->at, request.words,
                request.wrong ? "class=\"name wrong\"" : "class=\"name\"");
  }
  return left;
}

}  // namespace arelem::backend::svg
