#include "app/repl/why.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/repl/statement_lines.h"

#include "ir/define/matcher.h"
#include "runtime/define/alternatives.h"

namespace arelem::app::repl {

namespace {
using define::Alternative;
using define::Alternatives;

struct Solved {
  std::optional<Alternatives> found;
  std::vector<define::Parameter> parameters;
};

/// The place that a modifier like XLARGE compares, where an entity has one.
std::optional<std::array<double, 3>> placeOf(const Entity& entity) {
  switch (entity.type) {
    case EntityType::point:
    case EntityType::circle:
    case EntityType::sphere:
    case EntityType::cylinder:
      return std::array{entity.canon[0], entity.canon[1], entity.canon[2]};
    default:
      return std::nullopt;
  }
}

struct Side {
  int axis;
  bool large;
};
std::optional<Side> sideOf(Word word) {
  switch (word) {
    case Word::XLARGE:
      return Side{0, true};
    case Word::XSMALL:
      return Side{0, false};
    case Word::YLARGE:
      return Side{1, true};
    case Word::YSMALL:
      return Side{1, false};
    case Word::ZLARGE:
      return Side{2, true};
    case Word::ZSMALL:
      return Side{2, false};
    default:
      return std::nullopt;
  }
}

/// "x is 3.2 there, 12 here, and XLARGE takes the larger": where that is the reason.
std::string reason(const Alternative& other,
                   const Alternatives& all,
                   const std::vector<define::Parameter>& parameters) {
  const auto there = other.result.ok() ? placeOf(*other.result) : std::nullopt;
  const auto here = placeOf(all.chosen);
  for (const auto& [position, word] : other.words) {
    const Word written = std::get<Word>(parameters[position]);
    const std::optional<Side> side = sideOf(written);
    if (!side || !there || !here) {
      continue;
    }
    const auto axis = static_cast<std::size_t>(side->axis);
    const double difference = (*here)[axis] - (*there)[axis];
    if (side->large ? difference > 0.0 : difference < 0.0) {
      return fmt::format("{} is {:.9g} there and {:.9g} here; {} takes the {}",
                         std::string_view("xyz").substr(axis, 1), (*there)[axis], (*here)[axis],
                         spell(written), side->large ? "larger" : "smaller");
    }
  }
  return "";
}

/// "next to (x, y, z), 5.1 from the near point; this is 0.2 from it", or the words that differ.
std::string placeInWords(const Alternative& other, const Solved& solved, const Style& style) {
  const auto show = [&](const Vec3& p) {
    return fmt::format("({:.{}g}, {:.{}g}, {:.{}g})", p.x(), style.digits, p.y(), style.digits,
                       p.z(), style.digits);
  };
  std::string text = "it is the one next to " + show(*other.near);
  const Entity& here = solved.found->chosen;
  const EntityPtr* near = nullptr;
  for (const define::Parameter& p : solved.parameters) {
    const auto* entity = std::get_if<EntityPtr>(&p);
    near = entity != nullptr && (*entity)->type == EntityType::point ? entity : near;
  }
  if (near != nullptr && here.type == EntityType::point) {
    const Vec3 from((*near)->canon.data());
    text += fmt::format("; {:.{}g} from the near point, the chosen one {:.{}g}",
                        (Vec3(other.result->canon.data()) - from).norm(), style.digits,
                        (Vec3(here.canon.data()) - from).norm(), style.digits);
  }
  return text;
}

std::string wordsOf(const Alternative& other, const std::vector<define::Parameter>& parameters) {
  std::string text;
  for (const auto& [position, word] : other.words) {
    text += fmt::format("{}{} for {} in place {}", text.empty() ? "" : ", ", spell(word),
                        spell(std::get<Word>(parameters[position])), position + 1);
  }
  return text;
}

void printGiven(std::ostream& out,
                const std::vector<define::Parameter>& parameters,
                const Style& style) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (const auto* entity = std::get_if<EntityPtr>(&parameters[i])) {
      const Entity& e = **entity;
      out << fmt::format("   {}: {} {}  {}\n", i + 1, spell(e.type),
                         e.name.empty() ? "(nested)" : e.name, readable(e, style));
    }
  }
}

void printOthers(std::ostream& out, const Solved& solved, const Style& style) {
  const Alternatives& all = *solved.found;
  if (all.tried == 0) {
    out << "   the form has no choice: there is one solution\n";
    return;
  }
  std::size_t solutions = 1;
  for (const Alternative& other : all.others) {
    solutions += other.result.ok() ? 1 : 0;
  }
  const bool byPlace = std::any_of(all.others.begin(), all.others.end(),
                                   [](const Alternative& a) { return a.near.has_value(); });
  if (all.form == define::FormId::PT_14) {
    out << fmt::format("   candidates: {}, the places where the distance is least\n", solutions);
  } else {
    out << fmt::format("   candidates: {}, of {} other {}\n", solutions, all.tried,
                       byPlace ? "modifiers and near points" : "combinations of modifiers");
  }
  out << "   " << inked(style, Ink::good, "+ " + readable(all.chosen, style)) << "  chosen\n";
  for (const Alternative& other : all.others) {
    const std::string words = wordsOf(other, solved.parameters);
    if (!other.result.ok()) {
      out << "   " << inked(style, Ink::faint, "  nothing") << "  with " << words << ": "
          << other.result.failure().message << '\n';
      continue;
    }
    if (other.near) {
      out << "   - " << readable(*other.result, style)
          << "  lost: " << placeInWords(other, solved, style) << '\n';
      continue;
    }
    const std::string why = reason(other, all, solved.parameters);
    out << "   - " << readable(*other.result, style) << "  lost: it is the one with " << words
        << (why.empty() ? "" : "; " + why) << '\n';
  }
  if (!all.all) {
    out << fmt::format("   only {} combinations were tried\n", define::mostAlternatives);
  }
}

/// Evaluates the session once more and looks at the definition while its operands are there.
Solved solve(const Session& session,
             const Settings& settings,
             const std::string& name,
             int subscript,
             const InterruptFlag& interrupted) {
  Solved solved;
  Compilation job(settings);
  job.defined = [&](const Entity& result, std::span<const define::Parameter> parameters,
                    const define::Context& context) {
    if (result.name == name && result.subscript == subscript) {
      auto found = define::alternatives(result.type, parameters, context);
      if (found) {
        solved.found = *std::move(found);
        solved.parameters.assign(parameters.begin(), parameters.end());
      }
    }
  };
  if (load(job, std::string(session.run()->job.sources.name(session.run()->job.main)),
           session.text(), interrupted)) {
    static_cast<void>(evaluate(job, interrupted));
  }
  return solved;
}
}  // namespace

bool printWhy(std::ostream& out,
              const Session& session,
              const Settings& settings,
              const std::string& name,
              int subscript,
              const Style& style,
              const InterruptFlag& interrupted) {
  const Compilation& job = session.run()->job;
  const runtime::Defined* defined = nullptr;
  for (const runtime::Defined& d : job.evaluation.history) {
    if (d.name == name && d.subscript == subscript) {
      defined = &d;
    }
  }
  if (defined == nullptr) {
    return false;
  }
  printDefined(out, *defined, style);
  for (const StatementLines& s : statementsThatDefine(job.sources, *defined, settings)) {
    const std::string place =
        fmt::format("   {}:{}  ", job.sources.name(defined->definition.buffer), s.line);
    for (std::size_t card = 0; card < s.cards.size(); ++card) {
      out << (card == 0 ? place : std::string(place.size(), ' ')) << s.cards[card] << '\n';
    }
  }
  if (!defined->entity) {
    return true;
  }
  if (!defined->entity->referenceSystem.empty()) {
    out << "   in the reference system " << defined->entity->referenceSystem << '\n';
  }
  const Solved solved = solve(session, settings, name, subscript, interrupted);
  if (!solved.found) {
    return !interrupted;
  }
  if (solved.found->form != define::FormId::count) {
    const std::optional<Word> noun = findWord(spell(solved.found->chosen.type));
    out << fmt::format("   form {}: {}\n", define::row(solved.found->form).idText,
                       define::row(solved.found->form).meaning);
    if (noun) {
      out << "   " << define::syntaxLine(*noun, solved.found->form) << '\n';
    }
  }
  printGiven(out, solved.parameters, style);
  printOthers(out, solved, style);
  return true;
}

}  // namespace arelem::app::repl
