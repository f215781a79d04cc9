#include <charconv>
#include <cmath>
#include <map>

#include "ir/diag/stencil.h"
#include "ir/space/tolerance.h"
#include "runtime/stencil/alphabet.h"

namespace arelem::stencil {

namespace {
constexpr std::size_t mostSymbols = 1000;
constexpr std::size_t mostStrokes = 200;
constexpr std::size_t mostPieces = 50;
constexpr std::size_t mostLines = 200'000;
constexpr double mostCells = 1000.0;
constexpr double largestNumber = 1000.0;  // grid units
constexpr double smallestGrid = 1e-3;
constexpr std::size_t longestShown = 24;  // of a wrong word

/// The words of one line with their columns.
struct Words {
  struct Word {
    std::string_view text;
    std::size_t column = 1;
  };
  explicit Words(std::string_view line) {
    std::size_t i = 0;
    while (i < line.size()) {
      if (line[i] == ' ' || line[i] == '\t' || line[i] == '\r') {
        ++i;
        continue;
      }
      if (line[i] == '#') {
        break;
      }
      const std::size_t end = std::min(line.find_first_of(" \t\r", i), line.size());
      list.push_back({line.substr(i, end - i), i + 1});
      i = end;
    }
    endColumn = i + 1;
  }
  std::vector<Word> list;
  std::size_t endColumn = 1;
};

class Reader {
 public:
  Reader(std::string_view text, std::string_view file) : text_(text) { alphabet_.file = file; }

  Result<Alphabet> read() {
    std::size_t begin = 0;
    while (begin < text_.size() && !failure_) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      ++lineNumber_;
      if (lineNumber_ > mostLines) {
        tooMany(mostLines, "lines");
        break;
      }
      readLine(Words(text_.substr(begin, end - begin)));
      begin = end + 1;
    }
    if (!failure_ && !seenGrid_) {
      wrongAt(1, "the file ends without GRID: an alphabet begins with GRID width height");
    }
    finishShape();
    if (!failure_ && alphabet_.symbols.empty()) {
      wrongAt(1, "the file ends without a SYMBOL");
    }
    if (failure_) {
      return *std::move(failure_);
    }
    return std::move(alphabet_);
  }

 private:
  // ---- failures: the first one ends the reading
  void wrongAt(std::size_t column, std::string_view what) {
    if (!failure_) {
      failure_ = fail(diag::AlphabetSyntax, alphabet_.file, lineNumber_, column, what);
    }
  }
  void wrong(std::string_view wanted) {
    const std::size_t column = more() ? words_->list[next_].column : words_->endColumn;
    const std::string found =
        more() ? "`" + shown(words_->list[next_].text) + "`" : std::string("the end of the line");
    wrongAt(column, found + " stands where " + std::string(wanted) + " is expected");
  }
  void tooMany(std::size_t limit, std::string_view what) {
    if (!failure_) {
      failure_ = fail(diag::AlphabetSize, alphabet_.file, lineNumber_, limit, what);
    }
  }
  /// A word of the file as a message may show it: printable and short.
  static std::string shown(std::string_view word) {
    std::string clean;
    for (const char c : word.substr(0, longestShown)) {
      clean += c > ' ' && c < '\x7f' ? c : '?';
    }
    return word.size() > longestShown ? clean + "..." : clean;
  }

  // ---- words of the line
  [[nodiscard]] bool more() const { return next_ < words_->list.size(); }
  bool take(std::string_view word) {
    if (more() && words_->list[next_].text == word) {
      ++next_;
      return true;
    }
    return false;
  }
  void end() {
    if (!failure_ && more()) {
      wrong("the end of the line");
    }
  }
  /// A number or several with commas between them.
  template <std::size_t count>
  std::array<double, count> numbers(std::string_view wanted) {
    std::array<double, count> values{};
    if (!more()) {
      wrong(wanted);
      return values;
    }
    const std::string_view text = words_->list[next_].text;
    const char* p = text.data();
    const char* const last = p + text.size();
    for (std::size_t i = 0; i < count; ++i) {
      const auto [after, error] = std::from_chars(p, last, values[i]);
      const bool good = error == std::errc{} && std::isfinite(values[i]) &&
                        std::abs(values[i]) <= largestNumber &&
                        (i + 1 == count ? after == last : after != last && *after == ',');
      if (!good) {
        wrong(wanted);
        return {};
      }
      p = after + 1;
    }
    ++next_;
    return values;
  }
  Vec2 point(std::string_view wanted = "a point such as 4,18") {
    const auto p = numbers<2>(wanted);
    return {p[0], p[1]};
  }
  double positive(std::string_view wanted) {
    const std::size_t at = next_;
    const double value = numbers<1>(wanted)[0];
    if (!failure_ && value < smallestGrid) {
      next_ = at;
      wrong(wanted);
    }
    return value;
  }
  int wholeNumber(std::string_view wanted, double most) {
    const std::size_t at = next_;
    const double value = numbers<1>(wanted)[0];
    if (!failure_ && (value < 1.0 || value > most || value != std::floor(value))) {
      next_ = at;
      wrong(wanted);
    }
    return failure_ ? 1 : static_cast<int>(value);
  }

  // ---- statements
  void readLine(const Words& words) {
    if (words.list.empty()) {
      return;
    }
    words_ = &words;
    next_ = 0;
    if (!seenGrid_) {
      take("GRID") ? grid() : wrong("GRID");
    } else if (take("SPACING")) {
      alphabet_.spacing = positive("a positive number");
    } else if (take("PRIMITIVE")) {
      primitive();
    } else if (take("FIRST")) {
      edge(&Shape::first, &Shape::firstBack);
    } else if (take("SECOND")) {
      edge(&Shape::second, &Shape::secondBack);
    } else if (take("SYMBOL")) {
      symbol();
    } else if (take("STROKE")) {
      stroke();
    } else {
      wrong("SPACING, PRIMITIVE, FIRST, SECOND, SYMBOL or STROKE");
    }
    end();
    words_ = nullptr;
  }

  void grid() {
    alphabet_.width = positive("a positive width");
    alphabet_.height = positive("a positive height");
    seenGrid_ = true;
  }

  void primitive() {
    finishShape();
    const int number = wholeNumber("the number of a primitive, 1 to 999", 999.0);
    if (!failure_ && shapes_.count(number) != 0) {
      wrongAt(words_->list[1].column, "primitive " + std::to_string(number) + " is there already");
      return;
    }
    Curved& made = shapes_[number];
    made.shape = std::make_shared<Shape>();
    if (take("CELLS")) {
      made.cells = wholeNumber("a number of cells, 1 to 1000", mostCells);
    }
    open_ = made.shape;
  }

  void edge(Edge Shape::*which, bool Shape::*back) {
    if (!open_) {
      wrongAt(1, "an edge stands outside a PRIMITIVE");
      return;
    }
    Edge& edge = (*open_).*which;
    if (!edge.pieces.empty()) {
      wrongAt(1, "the primitive has this edge already");
      return;
    }
    (*open_).*back = take("BACK");
    while (more() && !failure_) {
      if (edge.pieces.size() >= mostPieces) {
        tooMany(mostPieces, "pieces of an edge");
        return;
      }
      piece(edge);
    }
    if (edge.pieces.empty()) {
      wrong("SPLINE, ARC or FROM");
    }
  }

  void piece(Edge& edge) {
    const std::size_t column = words_->list[next_].column;
    Piece made;
    if (take("SPLINE")) {
      SplinePiece spline;
      for (Vec2& p : spline.control) {
        p = point("one of the four points of a spline, such as 4,18,");
      }
      made = spline;
    } else if (take("ARC")) {
      ArcPiece arc;
      arc.center = point("the center of an arc, such as 1,19,");
      arc.radii = point("its two radii, such as 2,2,");
      const auto angles = numbers<2>("its two angles in degrees, such as 90,0,");
      arc.start = angles[0];
      arc.end = angles[1];
      if (!failure_ && (arc.radii.minCoeff() < smallestGrid || arc.start == arc.end)) {
        wrongAt(column, "an arc needs positive radii and two different angles");
      }
      made = arc;
    } else if (edge.pieces.empty() ? take("FROM") : take("LINE")) {
      LinePiece line;
      line.from = edge.pieces.empty() ? point() : lastPoint(edge);
      if (edge.pieces.empty() && !take("LINE")) {
        wrong("LINE");
        return;
      }
      line.to = point();
      if (!failure_ && line.from == line.to) {
        wrongAt(column, "a line of length 0");
      }
      made = line;
    } else {
      wrong(edge.pieces.empty() ? "SPLINE, ARC or FROM" : "SPLINE, ARC or LINE");
    }
    if (!failure_ && !edge.pieces.empty() &&
        (pointOf(made, 0.0) - lastPoint(edge)).norm() > tolerance::coincidence) {
      wrongAt(column, gap(lastPoint(edge), pointOf(made, 0.0)));
    }
    edge.pieces.push_back(made);
  }
  static std::string gap(const Vec2& end, const Vec2& begin) {
    return fmt::format(
        "this piece begins at {:.6g},{:.6g} but the one before it ends at {:.6g},{:.6g}", begin.x(),
        begin.y(), end.x(), end.y());
  }

  void finishShape() {
    if (open_ && !failure_ && (open_->first.pieces.empty() || open_->second.pieces.empty())) {
      wrongAt(1, "the primitive before this line needs a FIRST and a SECOND edge");
    }
    open_.reset();
  }

  void symbol() {
    finishShape();
    if (!more()) {
      wrong("a character or a name such as <RIGHT>");
      return;
    }
    const Words::Word name = words_->list[next_++];
    if (!isName(name.text)) {
      --next_;
      wrong("one printable character or a name of capitals and digits such as <RIGHT>");
      return;
    }
    if (alphabet_.find(name.text) != nullptr) {
      wrongAt(name.column, "`" + shown(name.text) + "` is there already");
      return;
    }
    if (alphabet_.symbols.size() >= mostSymbols) {
      tooMany(mostSymbols, "symbols");
      return;
    }
    Symbol symbol{std::string(name.text), alphabet_.width, {}};
    if (take("WIDTH")) {
      symbol.width = positive("a positive width");
    }
    alphabet_.symbols.push_back(std::move(symbol));
  }
  static bool isName(std::string_view text) {
    constexpr std::size_t longestName = 24;
    if (text.size() == 1) {
      return text[0] > ' ' && text[0] < '\x7f' && text[0] != '<' && text[0] != '>';
    }
    bool good =
        text.size() >= 3 && text.size() <= longestName && text.front() == '<' && text.back() == '>';
    for (std::size_t i = 1; good && i + 1 < text.size(); ++i) {
      good = (text[i] >= 'A' && text[i] <= 'Z') || (text[i] >= '0' && text[i] <= '9');
    }
    return good;
  }

  void stroke() {
    finishShape();
    if (alphabet_.symbols.empty()) {
      wrongAt(1, "a stroke stands before the first SYMBOL");
      return;
    }
    Symbol& symbol = alphabet_.symbols.back();
    if (symbol.strokes.size() >= mostStrokes) {
      tooMany(mostStrokes, "strokes of a symbol");
      return;
    }
    const std::size_t column = more() ? words_->list[next_].column : words_->endColumn;
    Stroke made;
    made.primitive = wholeNumber("the number of a primitive, 1 to 999", 999.0);
    if (more() && words_->list[next_].text.find(',') != std::string_view::npos) {
      made.shape = straightShape();
    } else if (const auto found = shapes_.find(made.primitive); found != shapes_.end()) {
      made.shape = found->second.shape;
      made.cells = found->second.cells;
    } else {
      wrongAt(column, "there is no primitive " + std::to_string(made.primitive) +
                          " above: write its lines, 0,0 1,0 TO 0,25 1,25");
    }
    while (more() && !failure_) {
      modifier(made);
    }
    if (!failure_ && made.join && symbol.strokes.empty()) {
      wrongAt(1, "the first stroke of a symbol has nothing to JOIN");
    }
    symbol.strokes.push_back(std::move(made));
  }

  std::shared_ptr<const Shape> straightShape() {
    auto shape = std::make_shared<Shape>();
    do {
      const std::size_t at = next_;
      Line line;
      line.first = point("the first end of a fan line, such as 0,25,");
      line.second = point("the second end of a fan line, such as 1,25,");
      if (!failure_ && widthOf(line) < smallestGrid) {
        wrongAt(words_->list[at].column, "a fan line of length 0");
      }
      if (shape->lines.size() >= mostPieces) {
        tooMany(mostPieces, "lines of a stroke");
      }
      shape->lines.push_back(line);
    } while (!failure_ && take("TO"));
    if (!failure_ && shape->lines.size() < 2) {
      wrong("TO");
    }
    return shape;
  }

  void modifier(Stroke& stroke) {
    if (take("FLIPX")) {
      stroke.placing.flipX = true;
    } else if (take("FLIPY")) {
      stroke.placing.flipY = true;
    } else if (take("MOVE")) {
      stroke.placing.move = point("a shift such as 0,-10");
    } else if (take("REVERSE")) {
      stroke.reverse = true;
    } else if (take("SWAP")) {
      stroke.swap = true;
    } else if (take("JOIN")) {
      stroke.join = true;
    } else if (take("CELLS")) {
      stroke.cells = wholeNumber("a number of cells, 1 to 1000", mostCells);
    } else {
      wrong("FLIPX, FLIPY, MOVE, REVERSE, SWAP, JOIN or CELLS");
    }
  }

  struct Curved {
    std::shared_ptr<Shape> shape;
    int cells = 20;
  };
  std::string_view text_;
  Alphabet alphabet_;
  std::map<int, Curved> shapes_;
  std::shared_ptr<Shape> open_;
  const Words* words_ = nullptr;
  std::size_t next_ = 0;
  std::size_t lineNumber_ = 0;
  bool seenGrid_ = false;
  std::optional<Failure> failure_;
};
}  // namespace

Result<Alphabet> readAlphabet(std::string_view text, std::string_view file) {
  return Reader(text, file).read();
}

}  // namespace arelem::stencil
