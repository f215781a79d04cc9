// Which features of the language the statements of a program show.
#include <algorithm>
#include <optional>

#include "ir/program/feature.h"
#include "ir/program/program.h"

namespace arelem::ir {

namespace {
using enum Feature;

std::optional<Feature> ofFunction(Word function) {
  switch (function) {
    case Word::SQRTF:
      return FN_01;
    case Word::SINF:
      return FN_02;
    case Word::COSF:
      return FN_03;
    case Word::TANF:
      return FN_04;
    case Word::ATANF:
      return FN_05;
    case Word::ATAN2F:
      return FN_06;
    case Word::EXPF:
      return FN_07;
    case Word::LOGF:
      return FN_08;
    case Word::LOG10F:
      return FN_09;
    case Word::ABSF:
      return FN_10;
    case Word::DOTF:
      return FN_11;
    case Word::LNTHF:
      return FN_12;
    case Word::ANGLF:
      return FN_13;
    case Word::NUMF:
      return FN_14;
    case Word::DISTF:
      return FN_15;
    default:
      return std::nullopt;
  }
}

std::optional<Feature> ofCommand(Word word, bool slash) {
  switch (word) {
    case Word::LOOPST:
      return CT_03;
    case Word::TERMAC:
      return CT_05;
    case Word::ZSURF:
      return ZS_01;
    case Word::PUNCH:
      return IO_07;
    case Word::CANON:
      return CN_04;
    case Word::MACHIN:
      return CR_01;
    case Word::NOPOST:
      return CR_02;
    case Word::CLPRNT:
      return slash ? CR_04 : CR_03;
    case Word::NOPLOT:
      return CR_05;
    case Word::CLTV:
      return CR_06;
    case Word::PTONLY:
      return CR_07;
    case Word::DEBUG:
      return CR_08;
    case Word::DYNDMP:
      return CR_09;
    case Word::TUNEUP:
      return CR_10;
    default:
      return std::nullopt;
  }
}

std::optional<Feature> ofText(Word word) {
  switch (word) {
    case Word::PARTNO:
      return LX_09;
    case Word::PPRINT:
      return LX_10;
    case Word::INSERT:
      return LX_11;
    case Word::TITLES:
      return LX_12;
    default:
      return std::nullopt;
  }
}

bool isArithmetic(Expr::Kind kind) {
  switch (kind) {
    case Expr::Kind::add:
    case Expr::Kind::subtract:
    case Expr::Kind::multiply:
    case Expr::Kind::divide:
    case Expr::Kind::power:
      return true;
    default:
      return false;
  }
}

class Survey {
 public:
  Survey(const Program& program, FeatureCounts& counts) : program_(program), counts_(counts) {}

  void run() {
    for (const Symbol& symbol : program_.symbols) {
      counts_.add(LX_06);
      count(symbol.arraySize > 0, SU_01);
    }
    std::for_each(program_.exprs.begin(), program_.exprs.end(), [this](const Expr& e) { expr(e); });
    std::for_each(program_.definitions.begin(), program_.definitions.end(),
                  [this](const Definition& d) { definition(d); });
    for (const Block& block : program_.blocks) {
      for (const Statement& s : block.statements) {
        count(!s.cardId.empty(), LX_01);
        count(!s.label.empty(), LX_07);
        std::visit([this](const auto& body) { statement(body); }, s.body);
      }
    }
  }

 private:
  void count(bool used, Feature feature) {
    if (used) {
      counts_.add(feature);
    }
  }
  void count(std::optional<Feature> feature) {
    if (feature) {
      counts_.add(*feature);
    }
  }

  void expr(const Expr& e) {
    count(e.kind == Expr::Kind::number, LX_05);
    count(isArithmetic(e.kind), EX_02);
    count(e.target.subscript.valid(), SU_02);
    if (e.kind == Expr::Kind::call) {
      count(ofFunction(e.function));
      arguments(e.arguments);
    }
  }

  void argument(const Argument& a) {
    if (const auto* range = std::get_if<ElementRange>(&a.value)) {
      const bool all = !range->low.valid() && !range->high.valid();
      counts_.add(all ? SU_05 : range->low.valid() && range->high.valid() ? SU_03 : SU_04);
    } else if (const auto* value = std::get_if<ExprId>(&a.value)) {
      count(value->valid() && isArithmetic(program_[*value].kind), EX_03);
    } else if (const auto* target = std::get_if<Target>(&a.value)) {
      count(target->subscript.valid(), SU_02);
    } else if (const auto* nested = std::get_if<DefinitionId>(&a.value)) {
      const Definition& d = program_[*nested];
      const bool shortPoint = d.typeSpan == d.span;
      counts_.add(shortPoint ? NS_03 : d.target.symbol.valid() ? NS_02 : NS_01);
    }
  }
  void arguments(const std::vector<Argument>& list) {
    std::for_each(list.begin(), list.end(), [this](const Argument& a) { argument(a); });
  }

  void definition(const Definition& d) {
    arguments(d.arguments);
    count(d.target.subscript.valid(), SU_02);
    const auto isWord = [&d](std::size_t i, Word wanted) {
      const Word* word =
          i < d.arguments.size() ? std::get_if<Word>(&d.arguments[i].value) : nullptr;
      return word != nullptr && *word == wanted;
    };
    count(isWord(1, Word::CANON) && std::holds_alternative<DefinitionId>(d.arguments[0].value),
          CN_03);
    if (d.type == EntityType::tabulatedCylinder) {
      bool tangents = false;
      for (std::size_t i = 2; i < d.arguments.size(); ++i) {
        tangents = tangents || isWord(i, Word::SLOPE) || isWord(i, Word::NORMAL);
      }
      count(tangents, TC_09);
      count(!isWord(0, Word::CANON), TC_08);
    }
  }

  void statement(const Assign& s) {
    counts_.add(EX_01);
    count(s.target.subscript.valid(), SU_02);
  }
  void statement(const Branch& s) { count(!s.zero.name.empty(), CT_01); }
  void statement(const Jump& s) { count(!s.label.name.empty(), CT_02); }
  void statement(const Call& /*s*/) { counts_.add(CT_06); }
  void statement(const Transfer& /*s*/) { counts_.add(CT_12); }
  void statement(const Fini& /*s*/) { counts_.add(CT_11); }
  void statement(const Text& s) { count(ofText(s.word)); }
  void statement(const Obtain& s) {
    counts_.add(std::holds_alternative<DefinitionId>(s.source.value) ? OB_02 : OB_01);
  }
  void statement(const Locate& s) { arguments(s.arguments); }
  void statement(const Command& s) {
    arguments(s.arguments);
    count(ofCommand(s.word, s.slash));
    if (s.word == Word::REFSYS && !s.arguments.empty()) {
      const Argument::Value& value = s.arguments[0].value;
      counts_.add(std::holds_alternative<Word>(value)           ? RF_02
                  : std::holds_alternative<DefinitionId>(value) ? RF_03
                                                                : RF_01);
    }
    if (s.word == Word::PRINT && !s.arguments.empty()) {
      print(s.arguments[0]);
    }
  }
  void print(const Argument& mode) {
    constexpr std::array modes = {IO_01, IO_02, IO_03, IO_04, IO_05};
    if (const auto* value = std::get_if<ExprId>(&mode.value)) {
      const auto number = static_cast<std::size_t>(program_[*value].number);
      counts_.add(modes.at(std::min(number, modes.size() - 1)));
    } else {
      counts_.add(IO_06);
    }
  }
  template <class Other>
  void statement(const Other& /*s*/) {}

  const Program& program_;
  FeatureCounts& counts_;
};
}  // namespace

void survey(const Program& program, FeatureCounts& counts) {
  Survey(program, counts).run();
}

}  // namespace arelem::ir
