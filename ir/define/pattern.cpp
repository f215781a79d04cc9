#include "ir/define/pattern.h"

#include <array>
#include <cctype>
#include <initializer_list>
#include <optional>

namespace arelem::define {

namespace {

constexpr std::uint64_t bits(std::initializer_list<EntityType> types) {
  std::uint64_t mask = 0;
  for (const EntityType type : types) {
    mask |= std::uint64_t{1} << static_cast<unsigned>(type);
  }
  return mask;
}

struct Kind {
  std::string_view name;
  std::uint64_t types;
};

using T = EntityType;
constexpr std::uint64_t conics = bits({T::ellipse, T::hyperbola, T::gconic, T::lconic, T::quadric});

/// The kinds a pattern may name. A LINE counts as the vertical plane that it is.
constexpr std::array kinds = {
    Kind{"point", bits({T::point})},
    Kind{"line", bits({T::line})},
    Kind{"plane", bits({T::plane, T::line})},
    Kind{"level", bits({T::plane})},  // a plane that is no line
    Kind{"circle", bits({T::circle})},
    Kind{"cylinder", bits({T::cylinder, T::circle})},
    Kind{"cone", bits({T::cone})},
    Kind{"vector", bits({T::vector})},
    Kind{"matrix", bits({T::matrix})},
    Kind{"sphere", bits({T::sphere})},
    Kind{"conic", conics},
    Kind{"tabcyl", bits({T::tabulatedCylinder})},
    Kind{"pattern", bits({T::pattern})},
    Kind{"spline", bits({T::pathSpline})},
    Kind{"surface", conics | bits({T::line, T::plane, T::circle, T::cylinder, T::cone, T::sphere,
                                   T::torus, T::tabulatedCylinder})},
    Kind{"anySurface",
         ~bits({T::point, T::vector, T::matrix, T::pattern, T::gun, T::region, T::pathSpline})},
    Kind{"gun", bits({T::gun})},
    Kind{"region", bits({T::region})},
    Kind{"any", ~std::uint64_t{0}},
};

std::string_view withoutDigits(std::string_view name) {
  while (!name.empty() && std::isdigit(static_cast<unsigned char>(name.back())) != 0) {
    name.remove_suffix(1);
  }
  return name;
}

Expectation expectation(std::string_view name) {
  Expectation wanted;
  wanted.text = name;
  if (const std::optional<Word> word = findWord(name)) {
    wanted.sort = Symbol::Sort::word;
    wanted.word = *word;
    return wanted;
  }
  if (name == "empty") {
    return wanted;
  }
  if (name.starts_with('\'')) {
    wanted.sort = Symbol::Sort::text;
    return wanted;
  }
  wanted.sort = Symbol::Sort::scalar;
  for (const Kind& kind : kinds) {
    if (kind.name == withoutDigits(name)) {
      wanted.sort = Symbol::Sort::entity;
      wanted.types = kind.types;
    }
  }
  return wanted;
}

/// Recursive descent over: list = item+; item = (name | { list | ... } | [ list ]) ['...'].
/// Each part returns its entry node; exits are all linked to one node that the caller appends.
class Compiler {
 public:
  explicit Compiler(std::string_view text) : text_(text) {}

  Pattern run(std::string* error) {
    const int start = node(Pattern::Node::Kind::split);
    int last = list(start);
    skip();
    if (at_ != text_.size()) {
      complain("surplus text");
    }
    const int end = node(Pattern::Node::Kind::end);
    pattern_.nodes[static_cast<std::size_t>(last)].next = end;
    pattern_.start = start;
    if (!error_.empty()) {
      pattern_ = Pattern{{Pattern::Node{Pattern::Node::Kind::split, {}, -1, -1}}, 0};
    }
    if (error != nullptr) {
      *error = error_;
    }
    return std::move(pattern_);
  }

 private:
  int node(Pattern::Node::Kind kind) {
    pattern_.nodes.push_back({kind, {}, -1, -1});
    return static_cast<int>(pattern_.nodes.size()) - 1;
  }
  Pattern::Node& at(int index) { return pattern_.nodes[static_cast<std::size_t>(index)]; }

  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == ',')) {
      ++at_;
    }
  }
  bool accept(std::string_view token) {
    skip();
    if (text_.substr(at_).starts_with(token)) {
      at_ += token.size();
      return true;
    }
    return false;
  }
  void complain(std::string what) {
    if (error_.empty()) {
      error_ = std::move(what) + " at " + std::to_string(at_) + " of `" + std::string(text_) + "`";
    }
  }

  /// Appends items after node `from`; returns the split node that ends the list.
  int list(int from) {
    skip();
    while (error_.empty() && at_ < text_.size() && text_[at_] != '|' && text_[at_] != '}' &&
           text_[at_] != ']') {
      const int to = item(from);
      if (accept("...")) {
        at(to).other = from;
      }
      const int fresh = node(Pattern::Node::Kind::split);
      at(to).next = fresh;
      from = fresh;
      skip();
    }
    return from;
  }

  /// One item from split node `from` (its `next` is free) to a new split node, which is returned.
  int item(int from) {
    if (accept("{")) {
      return alternatives(from);
    }
    if (accept("[")) {
      const int inner = node(Pattern::Node::Kind::split);
      at(from).next = inner;
      const int last = list(inner);
      if (!accept("]")) {
        complain("`]` is missing");
      }
      const int to = node(Pattern::Node::Kind::split);
      at(last).next = to;
      skipOver(from, to);
      return to;
    }
    const std::string_view name = readName();
    const int take = node(Pattern::Node::Kind::take);
    const int to = node(Pattern::Node::Kind::split);
    at(take).wanted = expectation(name);
    at(take).next = to;
    at(from).next = take;
    return to;
  }

  int alternatives(int from) {
    const int to = node(Pattern::Node::Kind::split);
    int fork = from;
    do {
      const int inner = node(Pattern::Node::Kind::split);
      const int later = node(Pattern::Node::Kind::split);
      at(fork).next = later;
      skipOver(later, inner);
      at(list(inner)).next = to;
      fork = later;
    } while (accept("|"));
    if (!accept("}")) {
      complain("`}` is missing");
    }
    return to;
  }

  /// Lets the automaton pass from `from` to `to` without taking anything.
  void skipOver(int from, int to) { at(from).other = to; }

  std::string_view readName() {
    skip();
    const std::size_t begin = at_;
    const bool quoted = at_ < text_.size() && text_[at_] == '\'';
    at_ += quoted ? 1 : 0;
    while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_])) != 0) {
      ++at_;
    }
    if (quoted && !accept("'")) {
      complain("a quote is missing");
    }
    if (at_ == begin) {
      complain("a name is missing");
      at_ = text_.size();
    }
    return text_.substr(begin, at_ - begin);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  Pattern pattern_;
  std::string error_;
};

}  // namespace

std::string describe(const Symbol& symbol) {
  switch (symbol.sort) {
    case Symbol::Sort::empty:
      return "nothing";
    case Symbol::Sort::scalar:
      return "scalar";
    case Symbol::Sort::text:
      return "text";
    case Symbol::Sort::word:
      return std::string(spell(symbol.word));
    case Symbol::Sort::entity:
      break;
  }
  std::string name(spell(symbol.type));
  for (char& c : name) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

bool Expectation::accepts(const Symbol& symbol) const {
  if (symbol.sort != sort) {
    return false;
  }
  switch (sort) {
    case Symbol::Sort::word:
      return symbol.word == word;
    case Symbol::Sort::entity:
      return (types >> static_cast<unsigned>(symbol.type) & 1U) != 0;
    case Symbol::Sort::empty:
    case Symbol::Sort::scalar:
    case Symbol::Sort::text:
      break;
  }
  return true;
}

Pattern compile(std::string_view pattern, std::string* error) {
  return Compiler(pattern).run(error);
}

}  // namespace arelem::define
