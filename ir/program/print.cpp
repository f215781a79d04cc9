// The stable text of a program: symbols, then every block, one statement a line:
//   index  isn  label)  statement
// Numbers are in shortest round-trip form, expressions fully parenthesized, jump targets shown as
// @index.
#include <array>
#include <ostream>
#include <string>

#include <fmt/format.h>

#include "ir/program/program.h"

namespace arelem::ir {

namespace {

std::string_view spellOperator(Expr::Kind kind) {
  switch (kind) {
    case Expr::Kind::add:
      return " + ";
    case Expr::Kind::subtract:
      return " - ";
    case Expr::Kind::multiply:
      return " * ";
    case Expr::Kind::divide:
      return " / ";
    case Expr::Kind::power:
      return " ** ";
    default:
      return " ? ";
  }
}

std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char c : text) {
    result += c == '\'' ? std::string("''") : std::string(1, c);
  }
  return result + "'";
}

class Printer {
 public:
  Printer(std::ostream& out, const Program& program) : out_(out), program_(program) {}

  void run() {
    for (const Symbol& s : program_.symbols) {
      const std::string_view kind = s.kind == Symbol::Kind::scalar ? "scalar" : spell(s.type);
      out_ << "symbol " << s.name << " " << kind;
      if (s.arraySize != 0) {
        out_ << " array " << s.arraySize;
      }
      out_ << "\n";
    }
    for (std::size_t b = 0; b < program_.blocks.size(); ++b) {
      const Block& block = program_.blocks[b];
      out_ << "block " << b << (block.name.empty() ? "" : " ") << block.name << "\n";
      for (std::size_t i = 0; i < block.statements.size(); ++i) {
        statement(i, block.statements[i]);
      }
    }
  }

 private:
  void statement(std::size_t index, const Statement& s) {
    out_ << fmt::format("{:6} {:6}  ", index, s.isn);
    if (!s.label.empty()) {
      out_ << s.label << ") ";
    }
    out_ << std::visit([this](const auto& body) { return text(body); }, s.body);
    if (!s.cardId.empty()) {
      out_ << "  $$ " << s.cardId;
    }
    out_ << "\n";
  }

  std::string text(const Target& t) const {
    const std::string name = program_[t.symbol].name;
    return t.subscript.valid() ? fmt::format("{}({})", name, text(t.subscript)) : name;
  }

  std::string text(ExprId id) const {
    const Expr& e = program_[id];
    switch (e.kind) {
      case Expr::Kind::number:
        return fmt::format("{}", e.number);
      case Expr::Kind::symbol:
        return text(e.target);
      case Expr::Kind::assign:
        return fmt::format("({} = {})", text(e.target), text(e.left));
      case Expr::Kind::negate:
        return fmt::format("(-{})", text(e.left));
      case Expr::Kind::call:
        return fmt::format("{}({})", spell(e.function), list(e.arguments));
      default:
        return fmt::format("({}{}{})", text(e.left), spellOperator(e.kind), text(e.right));
    }
  }

  std::string text(const ElementRange& r) const {
    std::string s =
        fmt::format("{}({},THRU,{}", program_[r.symbol].name, r.low.valid() ? text(r.low) : "1",
                    r.high.valid() ? text(r.high) : "ALL");
    if (r.step.valid() || r.descending) {
      s += fmt::format(",{},{}", r.descending ? "DECR" : "INCR",
                       r.step.valid() ? text(r.step) : "1");
    }
    return s + ")";
  }

  std::string text(DefinitionId id) const {
    const Definition& d = program_[id];
    const std::string name = d.target.symbol.valid() ? text(d.target) + " = " : "";
    return fmt::format("({}{}/ {})", name, spell(d.type), list(d.arguments));
  }

  std::string text(Omitted /*none*/) const { return {}; }
  std::string text(Word word) const { return std::string(spell(word)); }
  std::string text(const std::string& s) const { return quoted(s); }
  std::string text(const Argument& a) const {
    return std::visit([this](const auto& v) { return text(v); }, a.value);
  }
  std::string list(const std::vector<Argument>& arguments) const {
    std::string s;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      s += (i == 0 ? "" : ", ") + text(arguments[i]);
    }
    return s;
  }
  std::string text(const LabelRef& l) const {
    return l.name.empty() ? fmt::format("@{}", l.statement)
                          : fmt::format("{}@{}", l.name, l.statement);
  }

  std::string text(const Assign& a) const {
    return fmt::format("{} = {}", text(a.target), text(a.value));
  }
  std::string text(const Define& d) const {
    const std::string s = text(d.definition);
    return s.substr(1, s.size() - 2);
  }
  std::string text(const Branch& b) const {
    return fmt::format("IF ({}) {}, {}, {}", text(b.value), text(b.negative), text(b.zero),
                       text(b.positive));
  }
  std::string text(const Jump& j) const { return "JUMPTO/ " + text(j.label); }
  std::string text(const Call& c) const {
    return fmt::format("CALL/ {} block {}", c.macro, c.block.index);
  }
  std::string text(const Obtain& o) const {
    std::string s = fmt::format("OBTAIN, {}/ {}", spell(o.type), text(o.source));
    for (const auto& t : o.targets) {
      s += ", " + (t ? text(*t) : std::string());
    }
    return s;
  }
  std::string text(const Text& t) const {
    return fmt::format("{} {}", spell(t.word), quoted(t.text));
  }
  std::string text(const Locate& l) const {
    return fmt::format("{}/ {}", spell(l.word), list(l.arguments));
  }
  std::string text(const LocateNumbers& l) const {
    return fmt::format("{}/ {}", spell(l.word),
                       fmt::join(l.numbers.begin(), l.numbers.begin() + l.count, ", "));
  }
  std::string text(const SurfaceUse& u) const {
    static constexpr std::array<std::string_view, 6> words = {"",       "TO, ",    "ON, ",
                                                              "PAST, ", "TANTO, ", "PSTAN, "};
    return std::string(words[static_cast<std::size_t>(u.condition)]) + text(u.surface);
  }
  std::string feed(ExprId id) const { return id.valid() ? ", " + text(id) : std::string(); }
  std::string text(const Startup& s) const {
    std::string result = s.offset ? "OFFSET/ " : "GO/ ";
    for (std::size_t i = 0; i < s.surfaces.size(); ++i) {
      result += (i == 0 ? "" : ", ") + text(s.surfaces[i]);
    }
    return result + feed(s.feed);
  }
  std::string text(const Follow& f) const {
    static constexpr std::array<std::string_view, 6> words = {"GOLFT",  "GORGT", "GOFWD",
                                                              "GOBACK", "GOUP",  "GODOWN"};
    std::string s =
        fmt::format("{}/ {}", words[static_cast<std::size_t>(f.heading)], text(f.drive));
    for (const CheckUse& c : f.checks) {
      s += ", " + (c.nth.valid() ? text(c.nth) + ", INTOF, " : std::string()) + text(c.use);
      s += c.label ? ", " + text(*c.label) : std::string();
    }
    return s + feed(f.feed);
  }
  std::string text(const Transfer& t) const { return "TRANTO/ " + text(t.label); }
  std::string text(const Fini& /*none*/) const { return "FINI"; }
  std::string text(const Command& c) const {
    return fmt::format("{}{}{}", spell(c.word), c.slash ? "/ " : "", list(c.arguments));
  }
  std::string text(const ForeignCommand& c) const {
    return fmt::format("{}{}{}  $$ foreign", c.word, c.slash ? "/ " : "", list(c.arguments));
  }

  std::ostream& out_;
  const Program& program_;
};

}  // namespace

void print(std::ostream& out, const Program& program) {
  Printer(out, program).run();
}

}  // namespace arelem::ir
