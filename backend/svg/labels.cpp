#include "backend/svg/labels.h"

#include <algorithm>

namespace arelem::backend::svg {

namespace {
constexpr double letterWidth = 6.6;
constexpr double letterHeight = 11.0;
constexpr std::size_t longest = 24;

bool overlap(const Box& a, const Box& b) {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height &&
         b.top < a.top + a.height;
}

bool inside(const Box& a, const Box& area) {
  return a.left >= area.left && a.top >= area.top && a.left + a.width <= area.left + area.width &&
         a.top + a.height <= area.top + area.height;
}
}  // namespace

void Labels::place(const std::string& words, const std::vector<Pixel>& candidates) {
  if (words.empty() || words.size() > longest || labels_.size() >= most) {
    return;
  }
  for (const Pixel& at : candidates) {
    const Box box{at.x, at.y - letterHeight, letterWidth * static_cast<double>(words.size()),
                  letterHeight + 2.0};
    const bool taken = std::any_of(labels_.begin(), labels_.end(),
                                   [&](const Label& l) { return overlap(l.box, box); });
    if (!taken && inside(box, area_)) {
      labels_.push_back({words, at, box});
      return;
    }
  }
}

void Labels::draw(Canvas& canvas) const {
  for (const Label& label : labels_) {
    canvas.text(label.at, label.words, "class=\"name\"");
  }
}

}  // namespace arelem::backend::svg
