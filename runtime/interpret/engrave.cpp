// ENGRAV: words to lines of letters, and the moves that cut them.
#include "runtime/stencil/engrave.h"

#include <algorithm>
#include <cmath>

#include "ir/diag/stencil.h"
#include "ir/space/stencil_tolerance.h"
#include "runtime/interpret/command.h"
#include "runtime/interpret/worded.h"

namespace arelem::runtime::interpret {

namespace {
using stencil::Vec2;

constexpr std::string_view form =
    "ENGRAV/ 'TEXT', HEIGHT, h [, w], DEEP, d [, step], CLEARP, c [, FEDRAT, f [, down]] "
    "[, ORIGIN, point] [, ATANGL, deg] [, SPACE, w] [, CHORD, tol] [, ALPHAB, 'file']";

/// What is cut and how; lengths in the unit of the part program.
struct Cut {
  stencil::Engraving engraving;
  double top = 0.0;  ///< z of the face
  double depth = 0.0;
  double step = 0.0;       ///< largest depth of one pass; 0: all at once
  double clearance = 0.0;  ///< over the face, where the tool goes from line to line
  double feed = 0.0;       ///< 0: that in force
  double down = 0.0;       ///< into the face; 0: as `feed`

  [[nodiscard]] double passes() const {
    return step > 0.0 ? std::max(1.0, std::ceil(depth / step - tolerance::wholePasses)) : 1.0;
  }
};

/// Reads the parameters of ENGRAV from left to right.
class Reader : private WordedReader {
 public:
  Reader(const Items& items, double millimeters) : WordedReader(items) {
    constexpr double finest = 0.01;  // mm: less than the play of an engraving machine
    cut_.engraving.chord = finest / millimeters;
  }

  Result<Cut> run() {
    if (auto failure = readText(cut_.engraving.text)) {
      return *std::move(failure);
    }
    for (const Word needed : {Word::HEIGHT, Word::DEEP, Word::CLEARP}) {
      if (!has(needed)) {
        return wrong(fmt::format("no {}", spell(needed)),
                     fmt::format("{} is needed", spell(needed)));
      }
    }
    return std::move(cut_);
  }

 private:
  [[nodiscard]] Failure wrong(std::string what, std::string rule) const override {
    return fail(diag::EngravForm, std::move(what), std::move(rule))
        .withHelp("the form is " + std::string(form));
  }
  [[nodiscard]] Failure refused(std::string_view name,
                                double value,
                                std::string_view rule) const override {
    return fail(diag::EngravNumber, name, value, rule);
  }

  std::optional<Failure> value(Word word) override {
    stencil::Placement& placement = cut_.engraving.placement;
    switch (word) {
      case Word::HEIGHT:
        return one(word, placement.height, cut_.engraving.width);
      case Word::DEEP:
        return one(word, cut_.depth, cut_.step);
      case Word::CLEARP:
        return positive(word, cut_.clearance);
      case Word::FEDRAT:
        return one(word, cut_.feed, cut_.down);
      case Word::ORIGIN:
        return origin();
      case Word::ATANGL:
        return number(word, placement.angle);
      case Word::SPACE:
        return number(word, placement.space.emplace());
      case Word::CHORD:
        return positive(word, cut_.engraving.chord);
      case Word::ALPHAB:
        return fileName(word, cut_.engraving.alphabet);
      default:
        return meaningless(word);
    }
  }

  /// One positive number, and perhaps another.
  std::optional<Failure> one(Word word, double& first, double& second) {
    if (auto failure = positive(word, first)) {
      return failure;
    }
    return more() ? positive(word, second) : std::nullopt;
  }

  std::optional<Failure> origin() {
    const EntityPtr point = take(EntityType::point);
    if (!point) {
      return wrong("ORIGIN without a point", "a POINT belongs there");
    }
    cut_.engraving.placement.origin = Vec2(point->canon[0], point->canon[1]);
    cut_.top = point->canon[2];
    return std::nullopt;
  }

  Cut cut_;
};

/// Puts the lines into the stream: over each line with rapid speed, down with the feed for going
/// down, along it, and up again. A line that ends elsewhere than it begins is cut back and forth
/// where it takes several passes.
class LineWriter {
 public:
  LineWriter(State& state, const Cut& cut)
      : state_(state), cut_(cut), over_(cut.top + cut.clearance) {
    const Vec3 up = state_.systems.vectorToBase(Vec3::UnitZ()).normalized();
    if ((up - Vec3::UnitZ()).cwiseAbs().maxCoeff() > tolerance::turnedAxis) {
      axis_ = up;
    }
  }

  void write(const std::vector<stencil::PenLine>& lines) {
    for (const stencil::PenLine& line : lines) {
      write(line);
    }
  }

 private:
  void write(const stencil::PenLine& line) {
    std::vector<Vec2> points = line.points;
    rapid(points.front());
    const double passes = cut_.passes();
    for (double pass = 1.0; pass <= passes; ++pass) {
      const double z = cut_.top - cut_.depth * pass / passes;
      feed(cut_.down > 0.0 ? cut_.down : cut_.feed);
      go(points.front(), z);
      feed(cut_.feed);
      for (std::size_t i = 1; i < points.size(); ++i) {
        go(points[i], z);
      }
      if (!line.isClosed()) {
        std::reverse(points.begin(), points.end());
      }
    }
    rapid(points.front());
  }
  void feed(double value) {
    if (value > 0.0 && value != feed_) {
      state_.emit(Pass{cl::Post{Word::FEDRAT, "", {value}}});
      feed_ = value;
    }
  }
  void rapid(const Vec2& p) {
    state_.emit(Pass{cl::Post{Word::RAPID, "", {}}});
    go(p, over_);
  }
  void go(const Vec2& p, double z) {
    Locate locate;
    locate.word = Word::GOTO;
    locate.point = state_.systems.pointToBase({p.x(), p.y(), z});
    locate.axis = axis_;
    state_.emit(std::move(locate));
  }

  State& state_;
  const Cut& cut_;
  double over_;
  double feed_ = 0.0;
  std::optional<Vec3> axis_;  ///< where the face leans: square to it
};

/// Passes and lifts count too.
std::optional<Failure> tooLong(const std::vector<stencil::PenLine>& lines,
                               const Cut& cut,
                               std::uint64_t limit) {
  double places = 0.0;
  for (const stencil::PenLine& line : lines) {
    places += static_cast<double>(line.points.size()) * cut.passes() + 2.0;
  }
  constexpr double most = 1e15;
  return places > static_cast<double>(limit)
             ? std::optional(
                   fail(diag::StencilSize, static_cast<std::size_t>(std::min(places, most)), limit))
             : std::nullopt;
}
}  // namespace

void engrave(State& state, const ir::Command& command) {
  state.meetImplied("ENGRAV", false, true);
  const auto items = evaluate(state, command.arguments, Use::definition);
  if (!items) {
    return;
  }
  Result<Cut> cut = Reader(*items, state.context.millimeters).run();
  if (!cut) {
    reportAt(state, state.statement->span, cut.takeFailure(), *items);
    return;
  }
  Result<std::vector<stencil::PenLine>> lines = stencil::penLines(
      cut->engraving, state.options.files, state.options.limits, cut->engraving.placement.origin);
  if (!lines) {
    reportAt(state, state.statement->span, lines.takeFailure(), *items);
    return;
  }
  if (auto failure = tooLong(*lines, *cut, state.options.limits.points)) {
    reportAt(state, state.statement->span, *std::move(failure), *items);
    return;
  }
  LineWriter(state, *cut).write(*lines);
}

}  // namespace arelem::runtime::interpret
