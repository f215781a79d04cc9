#include <cmath>
#include <map>

#include "ir/diag/stencil.h"
#include "ir/space/tolerance.h"
#include "runtime/stencil/alphabet.h"
#include "runtime/stencil/alphabet_line.h"
#include "runtime/stencil/divide.h"
#include "runtime/stencil/stroke_check.h"

namespace arelem::stencil {

namespace {
constexpr std::size_t mostSymbols = 1000;
constexpr std::size_t mostStrokes = 200;
constexpr std::size_t mostPieces = 50;
constexpr std::size_t mostLines = 200'000;
constexpr double mostCells = 1000.0;

class Reader : private AlphabetLine {
 public:
  Reader(std::string_view text, std::string_view file) : AlphabetLine(file), text_(text) {
    alphabet_.file = file;
  }

  Result<Alphabet> read() {
    std::size_t at = 0;
    while (at < text_.size() && !failure_) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      ++lineNumber_;
      if (lineNumber_ > mostLines) {
        tooMany(mostLines, "lines");
        break;
      }
      readLine(text_.substr(at, end - at));
      at = end + 1;
    }
    if (!failure_ && !seenGrid_) {
      wrongAt(1, "the file ends without GRID: an alphabet begins with GRID width height");
    }
    finishShape();
    finishSymbol();
    if (!failure_ && alphabet_.symbols.empty()) {
      wrongAt(1, "the file ends without a SYMBOL");
    }
    if (failure_) {
      return *std::move(failure_);
    }
    return std::move(alphabet_);
  }

 private:
  // ---- statements
  void readLine(std::string_view line) {
    if (!begin(line)) {
      return;
    }
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
    } else if (take("PENGRID")) {
      penGrid();
    } else if (take("PEN")) {
      pen();
    } else {
      wrong("SPACING, PRIMITIVE, FIRST, SECOND, SYMBOL, STROKE, PENGRID or PEN");
    }
    end();
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
      wrongAt(words_.list[1].column, "primitive " + std::to_string(number) + " is there already");
      return;
    }
    Curved& made = shapes_[number];
    made.shape = std::make_shared<Shape>();
    if (take("CELLS")) {
      made.cells = wholeNumber("a number of cells, 1 to 1000", mostCells);
    }
    open_ = made.shape;
    openCells_ = made.cells;
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
    pieces(edge);
  }

  void pieces(Edge& edge) {
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

  void penGrid() {
    alphabet_.penWidth = positive("a positive width");
    alphabet_.penHeight = positive("a positive height");
    alphabet_.penSpacing = positive("a positive space between two symbols");
  }

  /// A line that ENGRAV cuts.
  void pen() {
    finishShape();
    if (alphabet_.symbols.empty()) {
      wrongAt(1, "a pen line stands before the first SYMBOL");
      return;
    }
    Symbol& symbol = alphabet_.symbols.back();
    if (symbol.pens.size() >= mostStrokes) {
      tooMany(mostStrokes, "pen lines of a symbol");
      return;
    }
    pieces(symbol.pens.emplace_back());
  }

  void piece(Edge& edge) {
    const std::size_t column = words_.list[next_].column;
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
      constexpr double round = 360.0;
      if (!failure_ && (arc.radii.minCoeff() < smallestGrid || arc.start == arc.end ||
                        std::abs(arc.end - arc.start) > round)) {
        wrongAt(column,
                "an arc needs positive radii and two different angles, at most 360 degrees apart");
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
    } else if (open_ && !failure_) {
      check("the primitive before this line", linesOf(*open_, openCells_, Division::equal));
    }
    open_.reset();
  }

  void check(const std::string& what, const std::vector<Line>& lines) {
    if (const std::string objection = objectionToLines(lines); !objection.empty()) {
      wrongAt(1, what + ": " + objection);
    }
  }

  /// A symbol that nothing paints or cuts would vanish from a text.
  void finishSymbol() {
    if (failure_ || alphabet_.symbols.empty()) {
      return;
    }
    const Symbol& last = alphabet_.symbols.back();
    if (last.strokes.empty() && last.pens.empty()) {
      wrongAt(1, "the symbol `" + shown(last.name) +
                     "` before this line needs a STROKE or a PEN; a blank is written as such");
    }
  }

  void symbol() {
    finishShape();
    if (!more()) {
      wrong("a character or a name such as <RIGHT>");
      return;
    }
    const LineWords::Word name = words_.list[next_++];
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
    finishSymbol();
    Symbol symbol{std::string(name.text), alphabet_.width, {}, {}};
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
    const std::size_t column = more() ? words_.list[next_].column : words_.endColumn;
    Stroke made;
    made.primitive = wholeNumber("the number of a primitive, 1 to 999", 999.0);
    if (more() && words_.list[next_].text.find(',') != std::string_view::npos) {
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
    } else if (!failure_ && made.join) {
      const std::string gap =
          objectionToJoin(symbol.strokes.back(), made, symbol.width, alphabet_.height);
      gap.empty() ? void() : wrongAt(1, gap);
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
        wrongAt(words_.list[at].column, "a fan line of length 0");
      }
      if (shape->lines.size() >= mostPieces) {
        tooMany(mostPieces, "lines of a stroke");
      }
      shape->lines.push_back(line);
    } while (!failure_ && take("TO"));
    if (!failure_ && shape->lines.size() < 2) {
      wrong("TO");
    } else if (!failure_) {
      check("a stroke", shape->lines);
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
  int openCells_ = 0;
  bool seenGrid_ = false;
};
}  // namespace

Result<Alphabet> readAlphabet(std::string_view text, std::string_view file) {
  return Reader(text, file).read();
}

}  // namespace arelem::stencil
