// Every form with one thing wrong, made from its pattern: a parameter of another type, one too
// many, one left out, a modifier left out. What no other form takes is refused with the old number,
// and the help shows the form that was meant.
#include <random>

#include "ir/define/forms.h"
#include "ir/define/matcher.h"
#include "ir/define/pattern.h"
#include "tests/unit/runtime/define/forms.h"

namespace arelem::define::test {
namespace {

Symbol exampleOf(const Expectation& wanted) {
  if (wanted.sort != Symbol::Sort::entity) {
    return {wanted.sort, wanted.word, {}};
  }
  unsigned code = 0;
  while ((wanted.types >> code & 1U) == 0) {
    ++code;
  }
  return Symbol::of(static_cast<EntityType>(code));
}

/// A random way through a pattern.
std::vector<Symbol> draw(const Pattern& pattern, std::mt19937_64& random) {
  std::vector<Symbol> result;
  for (int at = pattern.start;;) {
    const Pattern::Node& node = pattern.nodes[static_cast<std::size_t>(at)];
    if (node.kind == Pattern::Node::Kind::end) {
      return result;
    }
    if (node.kind == Pattern::Node::Kind::take) {
      result.push_back(exampleOf(node.wanted));
      at = node.next;
    } else {
      const bool first = std::uniform_int_distribution<int>(0, 1)(random) == 1;
      at = node.other < 0 || (first && node.next >= 0) ? node.next : node.other;
    }
  }
}

/// All lists that differ from the given one in one place.
std::vector<std::vector<Symbol>> damaged(const std::vector<Symbol>& good) {
  std::vector<std::vector<Symbol>> all;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::vector<Symbol> less = good;
    less.erase(less.begin() + static_cast<std::ptrdiff_t>(i));
    all.push_back(less);
    for (const Symbol& other :
         {Symbol::scalar(), Symbol::of(W::SPINDL), Symbol::of(T::matrix), Symbol::of(T::point)}) {
      std::vector<Symbol> changed = good;
      changed[i] = other;
      all.push_back(changed);
    }
  }
  std::vector<Symbol> more = good;
  more.push_back(Symbol::of(T::matrix));
  all.push_back(more);
  return all;
}

P parametersOf(const std::vector<Symbol>& symbols) {
  P result;
  for (const Symbol& s : symbols) {
    switch (s.sort) {
      case Symbol::Sort::empty:
        result.emplace_back(Omitted{});
        break;
      case Symbol::Sort::scalar:
        result.emplace_back(1.0);
        break;
      case Symbol::Sort::word:
        result.emplace_back(s.word);
        break;
      case Symbol::Sort::text:
        result.emplace_back(std::string("a"));
        break;
      default:
        result.emplace_back(make(s.type, std::vector<double>(12, 1.0)));
    }
  }
  return result;
}

TEST(BadInput, OneWrongParameterOfEveryForm) {
  std::mt19937_64 random(20261122);
  std::size_t refusals = 0, helped = 0;
  for (const FormRow& form : formTable()) {
    if (form.anyNoun) {
      continue;
    }
    const Pattern pattern = compile(form.pattern);
    std::size_t ofForm = 0;
    for (int i = 0; i < 5; ++i) {
      const std::vector<Symbol> good = draw(pattern, random);
      for (const std::vector<Symbol>& bad : damaged(good)) {
        if (std::holds_alternative<FormId>(match(form.noun, bad))) {
          continue;  // another form
        }
        const Failure failure = refused(*entityType(form.noun), parametersOf(bad));
        ASSERT_NE(failure.row, nullptr);
        EXPECT_FALSE(failure.row->legacy.empty()) << failure.message;
        EXPECT_NE(failure.help.find(std::string(spell(form.noun)) + "/"), std::string::npos)
            << failure.help;
        EXPECT_FALSE(failure.notes.empty());
        ++refusals;
        ++ofForm;
        helped += failure.help.find(syntaxLine(form.noun, form.id)) != std::string::npos ? 1 : 0;
      }
    }
    EXPECT_GT(ofForm, 0U) << form.idText;
  }
  EXPECT_GT(refusals, 3000U);
  // Where several forms are as near, five are shown, and the one meant may be the sixth.
  EXPECT_GT(static_cast<double>(helped), 0.9 * static_cast<double>(refusals));
}

}  // namespace
}  // namespace arelem::define::test
