// Commands that look at what the session has: :show, :list, :why, :distance.
#include <algorithm>
#include <charconv>
#include <sstream>

#include "app/nearest.h"
#include "app/repl/console.h"
#include "app/repl/statement_lines.h"
#include "app/repl/why.h"

#include "ir/diag/display_text.h"
#include "runtime/geometry/apart.h"

namespace arelem::app::repl {

namespace {
std::vector<std::string> items(const std::string& text, const char* separators) {
  std::vector<std::string> found;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(separators, at)) != std::string::npos) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    found.push_back(text.substr(at, end - at));
    at = end;
  }
  return found;
}

std::string unknown(const Console& console, const NamePart& name) {
  std::vector<std::string> known;
  for (const auto& n : console.session.names()) {
    known.push_back(n.name);
  }
  const std::string guess = nearest(name.name, known);
  return "there is no value of `" + displayText(name.name) + "`" +
         (guess.empty() ? "" : "; did you mean `" + guess + "`?");
}

bool matches(const runtime::Defined& defined, const std::string& wanted) {
  if (wanted.empty()) {
    return true;
  }
  const std::string_view type = defined.entity ? spell(defined.entity->type) : "SCALAR";
  if (wanted.back() == '*') {
    return defined.name.starts_with(wanted.substr(0, wanted.size() - 1));
  }
  return type == wanted || defined.name == wanted;
}

void printStatements(const Console& console, const std::vector<StatementLines>& statements) {
  constexpr std::size_t most = 10;
  for (std::size_t i = 0; i < statements.size() && i < most; ++i) {
    std::string text = fmt::format("   line {}: ", statements[i].line);
    const std::string indent(text.size(), ' ');
    for (std::size_t card = 0; card < statements[i].cards.size(); ++card) {
      text += (card == 0 ? "" : "\n" + indent) + statements[i].cards[card];
    }
    console.out << inked(console.style, Ink::faint, text) << '\n';
  }
  if (statements.size() > most) {
    console.out << fmt::format("   ... and {} more\n", statements.size() - most);
  }
}
}  // namespace

NamePart nameOf(const Console& console, std::string text) {
  std::erase_if(text, [](unsigned char c) { return c == ' ' || c == '\t'; });
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  NamePart part;
  const std::size_t open = text.find('(');
  part.name = text.substr(0, open);
  if (open != std::string::npos) {
    static_cast<void>(
        std::from_chars(text.data() + open + 1, text.data() + text.size(), part.subscript));
  }
  if (part.name == "ANS" && !console.session.answerName().empty() &&
      findDefined(console, part) == nullptr) {
    part.name = console.session.answerName();
  }
  return part;
}

const runtime::Defined* findDefined(const Console& console, const NamePart& name) {
  const auto& all = console.session.run()->job.evaluation.defined;
  const auto found = std::find_if(all.rbegin(), all.rend(), [&](const runtime::Defined& d) {
    return d.name == name.name && d.subscript == name.subscript;
  });
  return found == all.rend() ? nullptr : &*found;
}

std::string showEntity(Console& console, const std::string& rest) {
  const std::vector<std::string> names = items(rest, " ,\t");
  if (names.empty()) {
    return "a name is missing";
  }
  for (const std::string& text : names) {
    const NamePart name = nameOf(console, text);
    const runtime::Defined* defined = findDefined(console, name);
    if (defined == nullptr) {
      return unknown(console, name);
    }
    printDefined(console.out, *defined, console.style);
    const SourceMap& sources = console.session.run()->job.sources;
    if (defined->definition.length > 0) {
      printStatements(console, statementsThatDefine(sources, *defined, console.settings));
    }
  }
  return "";
}

std::string listNames(Console& console, const std::string& rest) {
  const std::string wanted = nameOf(console, rest).name;
  Style brief = console.style;
  brief.exact = false;
  std::size_t shown = 0;
  std::size_t all = 0;
  constexpr std::size_t most = 500;
  for (const runtime::Defined& defined : console.session.run()->job.evaluation.defined) {
    if (defined.name.empty() || !matches(defined, wanted)) {
      continue;
    }
    ++all;
    if (shown < most) {
      printDefined(console.out, defined, brief);
      ++shown;
    }
  }
  if (all > shown) {
    console.out << fmt::format("... and {} more\n", all - shown);
  }
  return all > 0 || wanted.empty() ? "" : "nothing is called `" + displayText(wanted) + "`";
}

std::string explainEntity(Console& console, const std::string& rest) {
  if (rest.empty()) {
    return "a name is missing";
  }
  const NamePart name = nameOf(console, rest);
  const bool done = printWhy(console.out, console.session, console.settings, name.name,
                             name.subscript, console.style, console.interrupt.flag());
  return done || console.interrupt.flag() ? "" : unknown(console, name);
}

std::string measure(Console& console, const std::string& rest) {
  const std::vector<std::string> names = items(rest, ",");
  if (names.size() != 2) {
    return "two names with a comma between them are needed: :distance A,B";
  }
  EntityPtr entities[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const NamePart name = nameOf(console, names[i]);
    const runtime::Defined* defined = findDefined(console, name);
    if (defined == nullptr) {
      return unknown(console, name);
    }
    if (!defined->entity) {
      return "`" + name.name + "` is a scalar";
    }
    entities[i] = defined->entity;
  }
  Result<geometry::Apart> apart = geometry::apart(*entities[0], *entities[1]);
  if (!apart) {
    console.report(apart.takeFailure());
    return "";
  }
  console.out << fmt::format("{}", apart->distance);
  if (!apart->remark.empty()) {
    console.out << "  (" << apart->remark << ')';
  }
  console.out << '\n';
  if (apart->places && apart->distance > 0.0) {
    const auto place = [&](const Vec3& p) {
      return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", p.x(), console.style.digits, p.y(),
                         console.style.digits, p.z(), console.style.digits);
    };
    console.out << "   from " << place(apart->from) << " to " << place(apart->to) << '\n';
  }
  return "";
}

}  // namespace arelem::app::repl
