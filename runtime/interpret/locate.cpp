#include <algorithm>

#include "ir/diag/curves.h"
#include "ir/diag/interpret.h"
#include "runtime/interpret/motion.h"

namespace arelem::runtime::interpret {

namespace {

constexpr std::string_view placeForms =
    "x,y | x,y,z[,feed] | x,y,z,i,j,k[,u,v,w][,feed] | x,y,z,vector[,vector][,feed] | "
    "point[,feed] | point,i,j,k[,u,v,w][,feed] | point,vector[,vector][,feed]";
constexpr std::string_view stepForms = "dx,dy,dz[,feed] | vector[,feed] | d[,feed] along the axis";

std::string formsOf(Word word) {
  return fmt::format("{}/ {}", spell(word), word == Word::GODLTA ? stepForms : placeForms);
}

/// Reads the parameters of a positioning statement from left to right.
class Reader {
 public:
  Reader(State& state, Word word, const Items& items) : state_(state), word_(word), items_(items) {}

  std::optional<Locate> place() {
    Locate locate;
    locate.word = word_;
    std::size_t next = 0;
    if (const EntityPtr* point = items_[0].entity(EntityType::point)) {
      locate.point = tripleOf(**point);
      locate.name = (*point)->name;
      locate.subscript = (*point)->subscript;
      next = 1;
    } else if (const std::size_t count = leadingNumbers(0); count == 2 && items_.size() == 2) {
      const double x = number(0);
      const double y = number(1);
      locate.point = state_.systems.pointToBase({x, y, state_.context.z(x, y)});
      return locate;
    } else if (count >= 3) {
      locate.point = state_.systems.pointToBase(triple(0));
      next = 3;
    } else {
      return wrong();
    }
    return axisAndFeed(std::move(locate), next);
  }

  std::optional<Locate> step() {
    Locate locate;
    locate.word = word_;
    std::size_t next = 0;
    if (const EntityPtr* vector = items_[0].entity(EntityType::vector)) {
      locate.point = tripleOf(**vector);
      locate.name = (*vector)->name;
      locate.subscript = (*vector)->subscript;
      next = 1;
    } else if (const std::size_t count = leadingNumbers(0); count == items_.size() && count <= 2) {
      locate.axial = number(0);
      locate.name = spell(Word::TLAXIS);  // the name that the record of an axial move carries
      next = 1;
    } else if (count >= 3) {
      locate.point = state_.systems.vectorToBase(triple(0));
      next = 3;
    } else {
      return wrong();
    }
    return feed(std::move(locate), next);
  }

 private:
  std::optional<Locate> axisAndFeed(Locate locate, std::size_t next) {
    locate.axis = direction(next);
    if (locate.axis) {
      locate.side = direction(next);
    }
    for (const std::optional<Vec3>& v : {locate.axis, locate.side}) {
      if (v && isNull(*v)) {
        reportAt(state_, items_[next - 1].span,
                 fail(diag::NullVector, spell(word_), v->x(), v->y(), v->z()), items_);
        return std::nullopt;
      }
    }
    if (locate.side && isNull(locate.side->normalized().cross(locate.axis->normalized()))) {
      state_.report(diagnose(items_[next - 1].span, diag::SideAlongAxis, spell(word_)));
      return std::nullopt;
    }
    return feed(std::move(locate), next);
  }

  /// A direction as a vector or as three numbers at `next`, which moves on; none is there
  /// otherwise.
  std::optional<Vec3> direction(std::size_t& next) {
    const EntityPtr* vector =
        next < items_.size() ? items_[next].entity(EntityType::vector) : nullptr;
    if (vector != nullptr) {
      ++next;
      return tripleOf(**vector);
    }
    if (leadingNumbers(next) >= 3) {
      next += 3;
      return state_.systems.vectorToBase(triple(next - 3));
    }
    return std::nullopt;
  }

  std::optional<Locate> feed(Locate locate, std::size_t next) {
    if (next + 1 == items_.size() && items_[next].number() != nullptr) {
      locate.feed = number(next);
      ++next;
    }
    return next == items_.size() ? std::optional(std::move(locate)) : wrong();
  }

  std::optional<Locate> wrong() {
    for (const Item& item : items_) {
      const bool fits = item.number() != nullptr || item.entity(EntityType::point) != nullptr ||
                        item.entity(EntityType::vector) != nullptr;
      if (!fits) {
        const Word* w = std::get_if<Word>(&item.value);
        Diagnostic d = w != nullptr ? diagnose(item.span, diag::MotionWord, spell(word_), spell(*w),
                                               formsOf(word_))
                                    : diagnose(item.span, diag::MotionOperand, spell(word_),
                                               describe(item), formsOf(word_));
        labelOperands(d, {item});
        state_.report(std::move(d));
        return std::nullopt;
      }
    }
    reportAt(state_, state_.statement->span,
             fail(diag::MotionArguments, spell(word_), describe(items_), formsOf(word_)), items_);
    return std::nullopt;
  }

  [[nodiscard]] std::size_t leadingNumbers(std::size_t from) const {
    std::size_t count = 0;
    while (from + count < items_.size() && items_[from + count].number() != nullptr) {
      ++count;
    }
    return count;
  }
  [[nodiscard]] double number(std::size_t i) const { return *items_[i].number(); }
  [[nodiscard]] Vec3 triple(std::size_t i) const {
    return {number(i), number(i + 1), number(i + 2)};
  }

  State& state_;
  Word word_;
  const Items& items_;
};

/// GOTO/spline[,feed].
void gotoSpline(State& state, const Items& items) {
  FollowSpline follow{*items[0].entity(EntityType::pathSpline), {}};
  if (items.size() == 2 && items[1].number() != nullptr) {
    follow.feed = *items[1].number();
  } else if (items.size() != 1) {
    reportAt(state, state.statement->span,
             fail(diag::MotionArguments, spell(Word::GOTO), describe(items), "GOTO/ spline[,feed]"),
             items);
    return;
  }
  state.emit(std::move(follow));
}

void locateItems(State& state, Word word, const Items& items) {
  state.meetImplied(spell(word), false, true);
  state.warnOfSystem();
  if (items.empty()) {
    state.report(diagnose(state.statement->span, diag::MotionArguments, spell(word),
                          "no parameters", formsOf(word)));
    return;
  }
  if (word == Word::GOTO && items[0].entity(EntityType::pattern) != nullptr) {
    gotoPattern(state, items);
    return;
  }
  if (word == Word::GOTO && items[0].entity(EntityType::pathSpline) != nullptr) {
    gotoSpline(state, items);
    return;
  }
  Reader reader(state, word, items);
  if (std::optional<Locate> locate = word == Word::GODLTA ? reader.step() : reader.place()) {
    state.emit(*std::move(locate));
  }
}

}  // namespace

void execute(State& state, const ir::LocateNumbers& numbers) {
  const auto& n = numbers.numbers;
  const bool plain = numbers.count == 3 || (numbers.count == 6 && numbers.word != Word::GODLTA);
  if (plain && state.systems.atBase()) {
    state.meetImplied(spell(numbers.word), false, true);
    Locate locate;
    locate.word = numbers.word;
    locate.point = {n[0], n[1], n[2]};
    if (numbers.count == 6) {
      locate.axis = Vec3(n[3], n[4], n[5]);
      if (isNull(*locate.axis) && state.program.dialect == "cl") {
        state.ignore("a tool axis 0, 0, 0", "it is no direction: the axis before is kept");
        locate.axis.reset();
      } else if (isNull(*locate.axis)) {
        state.report(diagnose(state.statement->span, diag::NullVector, spell(numbers.word), n[3],
                              n[4], n[5]));
        return;
      }
    }
    state.emit(std::move(locate));
    return;
  }
  if (numbers.count == 2 && state.program.dialect == "cl") {
    state.report(diagnose(state.statement->span, diag::PlaceWithoutZ, spell(numbers.word)));
  }
  Items items(std::min<std::size_t>(numbers.count, n.size()));
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i].value = n[i];
    items[i].span = state.statement->span;
  }
  locateItems(state, numbers.word, items);
}

void execute(State& state, const ir::Locate& locate) {
  if (const auto items = evaluate(state, locate.arguments, Use::motion)) {
    locateItems(state, locate.word, *items);
  }
}

}  // namespace arelem::runtime::interpret
