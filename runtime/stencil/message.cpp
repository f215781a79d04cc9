#include "runtime/stencil/message.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "ir/diag/stencil.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/angle.h"
#include "runtime/stencil/cell.h"

namespace arelem::stencil {

namespace {
std::string namesOf(const Alphabet& alphabet) {
  std::string names;
  for (const Symbol& symbol : alphabet.symbols) {
    names += (names.empty() ? "" : " ") + symbol.name;
  }
  return names;
}

/// The name of the symbol that begins at `i`: one character, or up to the closing bracket.
std::string_view nameAt(std::string_view text, std::size_t i) {
  if (text[i] == '<') {
    if (const std::size_t end = text.find('>', i); end != std::string_view::npos) {
      return text.substr(i, end - i + 1);
    }
  }
  return text.substr(i, 1);
}

/// Divides each stroke once: symbols of a text share their primitives.
class Divider {
 public:
  Divider(const Alphabet& alphabet, const Writing& writing)
      : alphabet_(alphabet), writing_(writing) {}

  std::vector<Line> lines(const Stroke& stroke, double width) {
    const bool straight = stroke.shape->isStraight();
    const int cells = straight || writing_.cells == 0 ? stroke.cells : writing_.cells;
    const auto [entry, isNew] = known_.try_emplace(Key{&stroke, cells}, std::vector<Line>{});
    if (isNew) {
      entry->second = linesOf(stroke, width, alphabet_.height, cells, writing_.division);
      if (writing_.best && !straight) {
        entry->second = improved(stroke, width, entry->second);
      }
    }
    return entry->second;
  }

 private:
  using Key = std::pair<const Stroke*, int>;

  /// The best division of the primitive as it stands in the file, put in its place.
  std::vector<Line> improved(const Stroke& stroke, double width, const std::vector<Line>& lines) {
    std::vector<Line>& best = best_[{stroke.shape.get(), static_cast<int>(lines.size())}];
    Stroke plain;
    plain.shape = stroke.shape;
    if (best.empty()) {
      best = linesOf(plain, width, alphabet_.height, static_cast<int>(lines.size()) - 1,
                     writing_.division);
      Edge second = stroke.shape->second;
      const Measured measured(second);
      best = bestDivision(best, measured, (*writing_.best)[0], (*writing_.best)[1]);
    }
    std::vector<Line> placedLines = best;
    for (Line& line : placedLines) {
      line.first = placed(stroke.placing, width, alphabet_.height, line.first);
      line.second = placed(stroke.placing, width, alphabet_.height, line.second);
      if (stroke.swap) {
        std::swap(line.first, line.second);
      }
    }
    if (stroke.reverse) {
      std::reverse(placedLines.begin(), placedLines.end());
    }
    return placedLines;
  }

  const Alphabet& alphabet_;
  const Writing& writing_;
  std::map<Key, std::vector<Line>> known_;
  std::map<std::pair<const Shape*, int>, std::vector<Line>> best_;
};

bool isSame(const Line& a, const Line& b) {
  return (a.first - b.first).norm() <= tolerance::coincidence &&
         (a.second - b.second).norm() <= tolerance::coincidence;
}

/// The strokes of one symbol as runs, on the grid.
std::vector<Run> runsOnGrid(const Symbol& symbol, Divider& divider, Division division) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < symbol.strokes.size(); ++i) {
    const Stroke& stroke = symbol.strokes[i];
    std::vector<Line> lines = divider.lines(stroke, symbol.width);
    if (!stroke.join || runs.empty()) {
      runs.push_back({symbol.name, 0, i + 1, std::move(lines)});
      continue;
    }
    std::vector<Line>& before = runs.back().lines;
    const bool drop = division == Division::asSource || isSame(before.back(), lines.front());
    before.insert(before.end(), lines.begin() + (drop ? 1 : 0), lines.end());
  }
  return runs;
}
}  // namespace

Result<std::vector<const Symbol*>> symbolsOf(std::string_view text, const Alphabet& alphabet) {
  std::vector<const Symbol*> symbols;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == ' ') {
      symbols.push_back(nullptr);
      ++i;
      continue;
    }
    const std::string_view name = nameAt(text, i);
    const Symbol* symbol = alphabet.find(name);
    if (symbol == nullptr) {
      Failure failure = fail(diag::StencilCharacter, i + 1, name, alphabet.file, namesOf(alphabet));
      std::string capitals(name);
      std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
      if (alphabet.find(capitals) != nullptr) {
        failure =
            std::move(failure).withHelp("capitals are other symbols: `" + capitals + "` is there");
      }
      return failure;
    }
    symbols.push_back(symbol);
    i += name.size();
  }
  return symbols;
}

Result<std::vector<Run>> runsOf(std::string_view text,
                                const Alphabet& alphabet,
                                const Placement& placement,
                                const Writing& writing,
                                const Limits& limits) {
  Result<std::vector<const Symbol*>> symbols = symbolsOf(text, alphabet);
  if (!symbols) {
    return symbols.takeFailure();
  }
  const double scale = placement.height / alphabet.height;
  const double gap = placement.space.value_or(alphabet.spacing * scale);
  const auto [sine, cosine] = geometry::sinCosDegrees(placement.angle);
  const Vec2 along(cosine, sine);
  const Vec2 up(-sine, cosine);
  Divider divider(alphabet, writing);
  std::vector<Run> runs;
  std::size_t poses = 0;
  double x = 0.0;
  for (std::size_t position = 0; position < symbols->size(); ++position) {
    const Symbol* symbol = (*symbols)[position];
    if (symbol != nullptr) {
      for (Run& run : runsOnGrid(*symbol, divider, writing.division)) {
        for (Line& line : run.lines) {
          for (Vec2* p : {&line.first, &line.second}) {
            *p = placement.origin + (x + scale * p->x()) * along + scale * p->y() * up;
          }
        }
        poses += run.lines.size();
        run.position = position;
        runs.push_back(std::move(run));
      }
      if (poses > limits.points) {
        return fail(diag::StencilSize, poses, limits.points);
      }
    }
    x += (symbol != nullptr ? symbol->width : alphabet.width) * scale + gap;
  }
  if (runs.empty()) {
    return fail(diag::StencilEmpty);
  }
  return runs;
}

}  // namespace arelem::stencil
