#include "runtime/stencil/alphabet.h"

#include <algorithm>

namespace arelem::stencil {

const Symbol* Alphabet::find(std::string_view name) const {
  const auto found = std::find_if(symbols.begin(), symbols.end(),
                                  [&](const Symbol& symbol) { return symbol.name == name; });
  return found == symbols.end() ? nullptr : &*found;
}

Vec2 placed(const Placing& placing, double width, double height, const Vec2& point) {
  return Vec2(placing.flipX ? width - point.x() : point.x(),
              placing.flipY ? height - point.y() : point.y()) +
         placing.move;
}

}  // namespace arelem::stencil
