#include "backend/svg/labels.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace arelem::backend::svg {

namespace {
constexpr double letterWidth = 6.6;
constexpr double letterHeight = 11.0;
constexpr std::size_t longest = 24;
constexpr double cell = 4.0;  // pixels

bool overlap(const Box& a, const Box& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

bool inside(const Box& a, const Box& area) {
  return a.left >= area.left && a.top >= area.top && a.left + a.width <= area.left + area.width &&
         a.top + a.height <= area.top + area.height;
}
}  // namespace

Labels::Labels(const Box& area)
    : area_(area),
      columns_(static_cast<std::size_t>(std::ceil(area.width / cell)) + 1),
      rows_(static_cast<std::size_t>(std::ceil(area.height / cell)) + 1),
      crossed_(columns_ * rows_, false) {}

void Labels::avoid(Pixel a, Pixel b) {
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
      crossed_[static_cast<std::size_t>(y) * columns_ + static_cast<std::size_t>(x)] = true;
    }
  }
}

/// `box` lies in the area.
bool Labels::isCrossed(const Box& box) const {
  const auto column = static_cast<std::size_t>((box.left - area_.left) / cell);
  const auto row = static_cast<std::size_t>((box.top - area_.top) / cell);
  const auto lastColumn = static_cast<std::size_t>((box.left + box.width - area_.left) / cell);
  const auto lastRow = static_cast<std::size_t>((box.top + box.height - area_.top) / cell);
  for (std::size_t r = row; r <= lastRow; ++r) {
    for (std::size_t c = column; c <= lastColumn; ++c) {
      if (crossed_[r * columns_ + c]) {
        return true;
      }
    }
  }
  return false;
}

void Labels::place(const std::string& words, const std::vector<Pixel>& candidates) {
  if (words.empty() || words.size() > longest || labels_.size() >= most) {
    return;
  }
  std::optional<Label> found;
  for (const Pixel& at : candidates) {
    const Box box{at.x, at.y - letterHeight, letterWidth * static_cast<double>(words.size()),
                  letterHeight + 2.0};
    const bool taken = std::any_of(labels_.begin(), labels_.end(),
                                   [&](const Label& l) { return overlap(l.box, box); });
    if (taken || !inside(box, area_)) {
      continue;
    }
    const bool crossed = isCrossed(box);
    if (!found || !crossed) {
      found = {words, at, box};
    }
    if (!crossed) {
      break;
    }
  }
  if (found) {
    labels_.push_back(*std::move(found));
  }
}

void Labels::draw(Canvas& canvas) const {
  for (const Label& label : labels_) {
    canvas.text(label.at, label.words, "class=\"name\"");
  }
}

}  // namespace arelem::backend::svg
