#include "runtime/stencil/message.h"

#include <algorithm>
#include <map>

#include "ir/diag/stencil.h"
#include "ir/space/tolerance.h"
#include "runtime/geometry/angle.h"
#include "runtime/stencil/rails.h"

namespace arelem::stencil {

namespace {
std::string namesOf(const Alphabet& alphabet) {
  std::string names;
  for (const Symbol& symbol : alphabet.symbols) {
    names += (names.empty() ? "" : " ") + symbol.name;
  }
  return names;
}

/// Whether the byte goes on with a character of UTF-8.
bool goesOn(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// The name of the symbol that begins at `i`: one character, or up to the closing bracket.
std::string_view nameAt(std::string_view text, std::size_t i) {
  if (text[i] == '<') {
    if (const std::size_t end = text.find('>', i); end != std::string_view::npos) {
      return text.substr(i, end - i + 1);
    }
  }
  std::size_t length = 1;
  while (i + length < text.size() && goesOn(text[i + length])) {
    ++length;
  }
  return text.substr(i, length);
}

/// The shares of its edge's length at which the lines of a stroke stand.
std::vector<double> sharesOf(const Stroke& stroke, const std::vector<Vec2>& ends) {
  std::vector<double> shares = {0.0};
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double step = stroke.shape->isStraight() ? (ends[i] - ends[i - 1]).norm() : 1.0;
    shares.push_back(shares.back() + step);
  }
  const double all = shares.back();
  for (double& share : shares) {
    share = all > 0.0 ? share / all : 0.0;
  }
  return shares;
}

bool isSame(const Line& a, const Line& b) {
  return (a.first - b.first).norm() <= tolerance::coincidence &&
         (a.second - b.second).norm() <= tolerance::coincidence;
}

/// The strokes of one symbol as runs, on the grid.
class Grid {
 public:
  Grid(const Alphabet& alphabet, const Writing& writing) : alphabet_(alphabet), writing_(writing) {}

  std::vector<Run> runs(const Symbol& symbol) {
    std::vector<Run> runs;
    std::array<Rail, 2> rails;
    for (std::size_t i = 0; i < symbol.strokes.size(); ++i) {
      const Stroke& stroke = symbol.strokes[i];
      const std::vector<Line> lines =
          placedLines(stroke, divided(stroke), symbol.width, alphabet_.height);
      const bool joins = stroke.join && !runs.empty();
      if (!joins) {
        finish(runs, rails);
        runs.push_back({symbol.name, 0, i + 1, {}});
      }
      std::vector<Line>& all = runs.back().lines;
      const bool drop =
          joins && (writing_.division == Division::asSource || isSame(all.back(), lines.front()));
      all.insert(all.end(), lines.begin() + (drop ? 1 : 0), lines.end());
      if (writing_.leaning) {
        extend(rails, stroke, symbol.width, lines, drop);
      }
    }
    finish(runs, rails);
    return runs;
  }

 private:
  void extend(std::array<Rail, 2>& rails,
              const Stroke& stroke,
              double width,
              const std::vector<Line>& lines,
              bool drop) const {
    const Edges edges = edgesOf(stroke, width, alphabet_.height);
    std::array<std::vector<Vec2>, 2> ends;
    for (const Line& line : lines) {
      ends[0].push_back(line.first);
      ends[1].push_back(line.second);
    }
    rails[0].extend(edges.first, sharesOf(stroke, ends[0]), drop);
    rails[1].extend(edges.second, sharesOf(stroke, ends[1]), drop);
  }
  void finish(std::vector<Run>& runs, std::array<Rail, 2>& rails) const {
    if (writing_.leaning && !runs.empty()) {
      constexpr double bow = 0.0008;  // of the height: 2 mm of letters of 2440 mm
      runs.back().lines = evenlyLeaning(rails[0], rails[1], bow * alphabet_.height);
      rails = {};
    }
  }

  /// Symbols share their shapes: each is divided once.
  const std::vector<Line>& divided(const Stroke& stroke) {
    const bool given = stroke.shape->isStraight() || writing_.cells == 0;
    const int cells = given ? stroke.cells : writing_.cells;
    const auto [entry, isNew] = divided_.try_emplace({stroke.shape.get(), cells});
    if (isNew) {
      entry->second = linesOf(*stroke.shape, cells, writing_.division);
    }
    return entry->second;
  }

  const Alphabet& alphabet_;
  const Writing& writing_;
  std::map<std::pair<const Shape*, int>, std::vector<Line>> divided_;
};
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
      const auto before = std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i),
                                        [](char c) { return !goesOn(c); });
      const auto number = static_cast<std::size_t>(before) + 1;
      Failure failure =
          fail(diag::StencilCharacter, number, name, alphabet.file, namesOf(alphabet));
      std::string capitals(name);
      std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                     [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
      if (alphabet.find(capitals) == nullptr) {
        return failure;
      }
      return std::move(failure).withHelp("capitals are other symbols: `" + capitals + "` is there");
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
  Grid grid(alphabet, writing);
  std::map<const Symbol*, std::vector<Run>> known;  // symbols come again
  std::vector<Run> runs;
  std::size_t poses = 0;
  double x = 0.0;
  for (std::size_t position = 0; position < symbols->size(); ++position) {
    const Symbol* symbol = (*symbols)[position];
    if (symbol != nullptr) {
      if (symbol->strokes.empty()) {
        return fail(diag::StencilStroke, position + 1, symbol->name, alphabet.file);
      }
      const auto [entry, isNew] = known.try_emplace(symbol);
      if (isNew) {
        entry->second = grid.runs(*symbol);
      }
      for (Run run : entry->second) {
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
