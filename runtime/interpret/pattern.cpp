#include <algorithm>
#include <cmath>
#include <map>

#include "ir/diag/interpret.h"
#include "runtime/interpret/motion.h"

namespace arelem::runtime::interpret {

namespace {

/// GOTO/pattern, modifiers (spec 4.3). Point numbers count from 1 in the order of the output, or in
/// the order of the definition under CONST; inside this class both count from 0.
class PatternMotion {
 public:
  PatternMotion(State& state, const Items& items)
      : state_(state), items_(items), pattern_(**items[0].entity()) {
    count_ = pattern_.canon.size() / 3;
  }

  void run() {
    if (readOrder() && readNumbers()) {
      emit();
    }
  }

 private:
  /// INVERS, ZIGZAG and CONST fix what the numbers mean, so they are read first.
  bool readOrder() {
    bool late = false;
    for (std::size_t i = 1; i < items_.size(); ++i) {
      const Word* word = std::get_if<Word>(&items_[i].value);
      if (word == nullptr) {
        continue;
      }
      late = late || *word == Word::OMIT || *word == Word::RETAIN || *word == Word::AVOID;
      if ((*word == Word::INVERS || *word == Word::ZIGZAG) && late) {
        return error(diagnose(items_[i].span, diag::PatternLate, spell(*word)));
      }
      bool* flag = *word == Word::INVERS   ? &inverse_
                   : *word == Word::ZIGZAG ? &zigzag_
                   : *word == Word::CONST  ? &definitionNumbers_
                                           : nullptr;
      if (flag != nullptr && *flag) {
        return error(diagnose(items_[i].span, diag::PatternRepeated, spell(*word)));
      }
      if (flag != nullptr) {
        *flag = true;
      }
      if (*word == Word::ZIGZAG && pattern_.pattern.kind != PatternShape::Kind::parallel) {
        return error(diagnose(items_[i].span, diag::PatternNotParlel));
      }
    }
    order();
    return true;
  }

  /// visit_[n]: the defined point that the output reaches as its n-th.
  void order() {
    visit_.resize(count_);
    const auto columns = static_cast<std::size_t>(std::max(pattern_.pattern.columns, 1));
    const std::size_t rows = std::max<std::size_t>(count_ / columns, 1);
    for (std::size_t n = 0; n < count_; ++n) {
      visit_[n] = n;
      if (zigzag_) {
        // A PARLEL grid is defined column after column, every second one backwards; here row after
        // row.
        const std::size_t row = n / columns;
        const std::size_t column = row % 2 == 0 ? n % columns : columns - 1 - n % columns;
        visit_[n] = column * rows + (column % 2 == 0 ? row : rows - 1 - row);
      }
    }
    if (inverse_) {
      std::reverse(visit_.begin(), visit_.end());
    }
    position_.resize(count_);
    for (std::size_t n = 0; n < count_; ++n) {
      position_[visit_[n]] = n;
    }
  }

  bool readNumbers() {
    chosen_.assign(count_, false);
    for (std::size_t i = 1; i < items_.size();) {
      const Word* word = std::get_if<Word>(&items_[i].value);
      if (const double* number = items_[i].number()) {
        return error(diagnose(items_[i].span, diag::PatternStray, *number));
      }
      if (word == nullptr) {
        return error(diagnose(items_[i].span, diag::PatternItem, describe(items_[i])));
      }
      switch (*word) {
        case Word::INVERS:
        case Word::ZIGZAG:
        case Word::CONST:
          ++i;
          break;
        case Word::OMIT:
        case Word::RETAIN:
        case Word::AVOID:
          if (!readList(*word, i)) {
            return false;
          }
          break;
        default:
          return error(diagnose(items_[i].span, diag::PatternWord, spell(*word)));
      }
    }
    return checkAvoided();
  }

  /// One of OMIT, RETAIN, AVOID at items_[i] with its numbers; i moves behind them.
  bool readList(Word word, std::size_t& i) {
    const std::size_t head = i++;
    if ((word == Word::OMIT && retain_) || (word == Word::RETAIN && omit_)) {
      return error(diagnose(items_[head].span, diag::PatternMixed));
    }
    if ((word == Word::OMIT && omit_) || (word == Word::RETAIN && retain_)) {
      return error(diagnose(items_[head].span, diag::PatternRepeated, spell(word)));
    }
    omit_ = omit_ || word == Word::OMIT;
    retain_ = retain_ || word == Word::RETAIN;
    double lift = 0.0;
    if (word == Word::AVOID) {
      const double* z = i < items_.size() ? items_[i].number() : nullptr;
      if (z == nullptr) {
        return error(diagnose(items_[head].span, diag::PatternMissing, "AVOID"));
      }
      lift = *z;
      ++i;
    }
    const std::size_t first = i;
    std::optional<std::size_t> last;
    while (i < items_.size() && items_[i].number() != nullptr) {
      if (!readRange(word, lift, i, last)) {
        return false;
      }
    }
    if (i == first) {
      return error(diagnose(items_[head].span, diag::PatternMissing, spell(word)));
    }
    return true;
  }

  /// n or n,THRU,m at items_[i]; `last` is the position in the output that the list has reached.
  bool readRange(Word word, double lift, std::size_t& i, std::optional<std::size_t>& last) {
    const std::size_t at = i;
    std::optional<std::size_t> low = number(i);
    std::optional<std::size_t> high = low;
    ++i;
    if (low && i < items_.size() && items_[i].is(Word::THRU)) {
      if (i + 1 >= items_.size() || items_[i + 1].number() == nullptr) {
        return error(diagnose(items_[i].span, diag::PatternMissing, "THRU"));
      }
      high = number(i + 1);
      i += 2;
    }
    if (!low || !high) {
      return false;
    }
    if (*low > *high) {
      std::swap(low, high);
    }
    if (definitionNumbers_ && zigzag_ && columnOf(*low) != columnOf(*high)) {
      return error(diagnose(items_[at].span, diag::PatternColumns, *low + 1.0, *high + 1.0));
    }
    std::vector<std::size_t> positions;
    for (std::size_t n = *low; n <= *high; ++n) {
      positions.push_back(definitionNumbers_ ? position_[n] : n);
    }
    std::sort(positions.begin(), positions.end());
    if (last && positions.front() <= *last) {
      return error(diagnose(items_[at].span, diag::PatternOrder, *items_[at].number(),
                            "listed after one that the output reaches later"));
    }
    last = positions.back();
    for (const std::size_t p : positions) {
      if (word == Word::AVOID) {
        avoided_[p] = {lift, at};
      } else {
        chosen_[p] = true;
      }
    }
    return true;
  }

  /// The point number at items_[i], from 0.
  std::optional<std::size_t> number(std::size_t i) {
    const double value = *items_[i].number();
    if (value < 1.0 || value > static_cast<double>(count_) || value != std::floor(value)) {
      error(diagnose(items_[i].span, diag::PatternNumber, value, count_));
      return std::nullopt;
    }
    return static_cast<std::size_t>(value) - 1;
  }

  [[nodiscard]] std::size_t columnOf(std::size_t defined) const {
    const auto columns = static_cast<std::size_t>(std::max(pattern_.pattern.columns, 1));
    return defined / std::max<std::size_t>(count_ / columns, 1);
  }

  [[nodiscard]] bool visits(std::size_t position) const {
    return omit_ ? !chosen_[position] : !retain_ || chosen_[position];
  }

  bool checkAvoided() {
    for (const auto& [position, avoid] : avoided_) {
      if (!visits(position)) {
        return error(diagnose(items_[avoid.item].span, diag::PatternOrder,
                              *items_[avoid.item].number(), "avoided but not visited"));
      }
    }
    return true;
  }

  void emit() {
    std::vector<std::size_t> route;
    for (std::size_t p = 0; p < count_; ++p) {
      if (visits(p)) {
        route.push_back(p);
      }
    }
    for (std::size_t i = 0; i < route.size(); ++i) {
      go(route[i], 0.0);
      const auto avoid = avoided_.find(route[i]);
      if (avoid == avoided_.end()) {
        continue;
      }
      cycle(Word::NOMORE);
      go(route[i], avoid->second.lift);
      if (i + 1 == route.size()) {
        const Item& item = items_[avoid->second.item];
        state_.report(diagnose(item.span, diag::PatternNoNext, *item.number()));
        continue;
      }
      go(route[i + 1], avoid->second.lift);
      cycle(Word::ON);
    }
  }

  void go(std::size_t position, double lift) {
    const double* c = &pattern_.canon[3 * visit_[position]];
    Locate locate;
    locate.word = Word::GOTO;
    locate.point = {c[0], c[1], c[2] + lift};
    locate.name = pattern_.name;
    locate.subscript = pattern_.subscript;
    state_.emit(std::move(locate));
  }

  void cycle(Word mode) { state_.emit(Pass{cl::Post{Word::CYCLE, "", {mode}}}); }

  bool error(Diagnostic diagnostic) {
    labelOperands(diagnostic, {items_[0]});
    state_.report(std::move(diagnostic));
    return false;
  }

  struct Avoid {
    double lift = 0.0;
    std::size_t item = 0;
  };

  State& state_;
  const Items& items_;
  const Entity& pattern_;
  std::size_t count_ = 0;
  bool inverse_ = false, zigzag_ = false, definitionNumbers_ = false;
  bool omit_ = false, retain_ = false;
  std::vector<std::size_t> visit_;     // output position -> defined point
  std::vector<std::size_t> position_;  // defined point -> output position
  std::vector<bool> chosen_;           // by OMIT or RETAIN, by output position
  std::map<std::size_t, Avoid> avoided_;
};

}  // namespace

void gotoPattern(State& state, const Items& items) {
  PatternMotion(state, items).run();
}

}  // namespace arelem::runtime::interpret
