#include "app/language.h"

#include <algorithm>
#include <iostream>
#include <set>

#include "app/command.h"
#include "app/manual_pages.h"
#include "app/messages.h"
#include "app/nearest.h"
#include "app/options.h"
#include <fmt/ranges.h>

#include "frontend/block_forms.h"
#include "frontend/complete/complete.h"
#include "frontend/dialect.h"
#include "ir/define/matcher.h"
#include "ir/diag/render_json.h"
#include "ir/program/feature.h"
#include "ir/words/post_forms.h"

namespace arelem::app {

namespace {
/// The page of docs/manual that tells of the words of motion.
constexpr std::string_view motionPage = "motion";

/// One JSON object of strings a row, as the manual's generator reads them.
class JsonRows {
 public:
  explicit JsonRows(std::string_view name) {
    std::cout << (opened ? ",\n" : "{\n") << jsonString(name) << ": [";
    opened = true;
  }
  ~JsonRows() { std::cout << "\n]"; }
  JsonRows(const JsonRows&) = delete;
  JsonRows& operator=(const JsonRows&) = delete;

  void row(std::initializer_list<std::pair<std::string_view, std::string>> fields) {
    std::cout << (first_ ? "\n  {" : ",\n  {");
    first_ = false;
    std::string_view separator;
    for (const auto& [key, value] : fields) {
      std::cout << separator << jsonString(key) << ": " << jsonString(value);
      separator = ", ";
    }
    std::cout << '}';
  }

 private:
  bool first_ = true;
  static inline bool opened = false;
};

std::string_view textOf(frontend::Leave leave) {
  constexpr std::array texts = {"refused", "warned", "taken"};
  return texts.at(static_cast<std::size_t>(leave));
}

std::string_view className(WordClass wordClass) {
  constexpr std::array names = {
#define ARELEM_WORD_CLASS(name) #name,
#include "ir/words/classes.def"
#undef ARELEM_WORD_CLASS
  };
  return names.at(static_cast<std::size_t>(wordClass));
}

void printForms() {
  JsonRows rows("forms");
  for (const define::FormRow& form : define::formTable()) {
    const std::string noun(form.anyNoun ? "TYPE" : spell(form.noun));
    rows.row({{"id", std::string(form.idText)},
              {"noun", noun},
              {"pattern", std::string(form.pattern)},
              {"meaning", std::string(form.meaning)}});
  }
}

void printWords() {
  {
    JsonRows rows("words");
    for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
      const WordRow& word = row(static_cast<Word>(i));
      rows.row({{"word", std::string(word.text)},
                {"class", std::string(className(word.wordClass))},
                {"type", std::to_string(word.type)},
                {"code", std::to_string(word.code)},
                {"extension", word.extension ? "yes" : ""}});
    }
  }
  {
    JsonRows rows("postWords");
    for (const PostForm& form : postForms()) {
      const WordRow& word = row(form.word);
      rows.row({{"word", std::string(word.text)},
                {"form", std::string(form.pattern.empty() ? word.text : form.pattern)},
                {"least", std::to_string(form.least)},
                {"most", std::to_string(form.most)},
                {"words", std::string(form.words)},
                {"acts", form.acts ? "yes" : ""},
                {"bare", word.wordClass == WordClass::postWithoutParameters ? "yes" : ""},
                {"code", std::to_string(word.code)},
                {"meaning", std::string(form.meaning)}});
    }
  }
}

void printTables() {
  printForms();
  {
    JsonRows rows("features");
    for (const ir::FeatureRow& feature : ir::featureTable()) {
      rows.row({{"group", std::string(feature.group)},
                {"id", std::string(feature.idText)},
                {"syntax", std::string(feature.syntax)},
                {"meaning", std::string(feature.meaning)}});
    }
  }
  printWords();
  {
    JsonRows rows("dialects");
    for (const frontend::DialectRow& d : frontend::dialectTable()) {
      rows.row({{"what", std::string(d.what)},
                {"auto", std::string(textOf(d.leave[0]))},
                {"apt360", std::string(textOf(d.leave[1]))},
                {"apt4", std::string(textOf(d.leave[2]))},
                {"cl", std::string(textOf(d.leave[3]))},
                {"native", std::string(textOf(d.leave[4]))}});
    }
  }
  {
    JsonRows rows("blocks");
    for (const frontend::BlockForm& form : frontend::blockForms()) {
      rows.row({{"syntax", std::string(form.syntax)}, {"meaning", std::string(form.meaning)}});
    }
  }
  {
    JsonRows rows("clMarks");
    for (const frontend::ClMark& mark : frontend::clMarks()) {
      rows.row({{"begin", std::string(mark.begin)}, {"writer", std::string(mark.writer)}});
    }
  }
  {
    JsonRows rows("limits");
    for (const LimitRow& limit : limitTable) {
      rows.row({{"flag", std::string(limit.flag)},
                {"default", std::to_string(Limits{}.*limit.member)},
                {"what", std::string(limit.what)}});
    }
  }
  std::cout << "\n}\n";
}

/// "PT-04" of PT_04.
std::string publicId(std::string_view id) {
  std::string text(id);
  std::replace(text.begin(), text.end(), '_', '-');
  return text;
}

/// Syntax lines of the forms of a noun.
bool printNoun(std::ostream& out, std::string_view noun) {
  bool any = false;
  for (const define::FormRow& form : define::formTable()) {
    if (!form.anyNoun && spell(form.noun) == noun) {
      out << fmt::format("{:7} {}\n        {}\n", publicId(form.idText),
                         define::syntaxLine(form.noun, form.id), form.meaning);
      any = true;
    }
  }
  return any;
}

/// Whether the syntax has the word, and not only within another one.
bool hasWord(std::string_view syntax, std::string_view word) {
  const auto joins = [&](std::size_t i) {
    return i < syntax.size() && std::isalnum(static_cast<unsigned char>(syntax[i])) != 0;
  };
  for (std::size_t i = syntax.find(word); i != std::string_view::npos;
       i = syntax.find(word, i + 1)) {
    if (!(i > 0 && joins(i - 1)) && !joins(i + word.size())) {
      return true;
    }
  }
  return false;
}

/// Statements whose syntax contains the word.
bool printFeatures(std::ostream& out, std::string_view word) {
  bool any = false;
  if (const std::optional<Word> known = findWord(word)) {
    if (const frontend::StatementForm* form = frontend::statementForm(*known)) {
      out << fmt::format("        {}/ {}\n        {}\n", word, form->pattern, form->meaning);
      any = true;
    } else if (const PostForm* post = postForm(*known)) {
      out << fmt::format("        {}\n        {}\n", word, post->meaning);
      any = true;
    }
  }
  for (const ir::FeatureRow& feature : ir::featureTable()) {
    if (hasWord(feature.syntax, word)) {
      out << fmt::format("{:7} {}\n        {}\n", publicId(feature.idText), feature.syntax,
                         feature.meaning);
      any = true;
    }
  }
  for (const frontend::BlockForm& form : frontend::blockForms()) {
    if (hasWord(form.syntax, word)) {
      out << fmt::format("        {}\n        {}\n", form.syntax, form.meaning);
      any = true;
    }
  }
  return any;
}

/// Forms and statements in which a modifier may stand.
bool printPlaces(std::ostream& out, std::string_view word) {
  bool any = false;
  for (const define::FormRow& form : define::formTable()) {
    const std::string line = form.anyNoun ? "" : define::syntaxLine(form.noun, form.id);
    if (hasWord(line, word)) {
      out << fmt::format("{:7} {}\n        {}\n", publicId(form.idText), line, form.meaning);
      any = true;
    }
  }
  for (const frontend::StatementForm& form : frontend::statementForms()) {
    if (form.word != findWord(word) && hasWord(form.pattern, word)) {
      out << fmt::format("        {}/ {}\n        {}\n", spell(form.word), form.pattern,
                         form.meaning);
      any = true;
    }
  }
  return any;
}

/// What tables and lists of the page of motion tell of the word; else which pages have it.
/// Programs of the page do not count.
bool printPages(std::ostream& out, std::string_view word) {
  bool any = false;
  std::vector<std::string_view> others;
  for (const ManualPage& page : manualTopics()) {
    bool here = false;
    for (std::string_view rest = page.text; !rest.empty();) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      here = here || hasWord(line, word);
      const bool listed = line.starts_with("| ") || line.starts_with("* ");
      if (page.code == motionPage && listed && hasWord(line, word)) {
        out << fmt::format("{}.md: {}\n", page.code, line);
        any = true;
      }
    }
    if (here) {
      others.push_back(page.code);
    }
  }
  if (!any && !others.empty()) {
    out << fmt::format("{} is a word of these pages of the manual: {}\n", word,
                       fmt::join(others, " "));
  }
  return any || !others.empty();
}

void printNouns() {
  std::set<std::string_view> nouns;
  for (const define::FormRow& form : define::formTable()) {
    if (!form.anyNoun) {
      nouns.insert(spell(form.noun));
    }
  }
  std::cout << fmt::format("nouns: {}\n", fmt::join(nouns, " "));
}
}  // namespace

bool printLanguage(std::ostream& out, std::string_view word) {
  return printNoun(out, word) || printFeatures(out, word);
}

int runLanguage(const Invocation& invocation) {
  CLI::App app(
      "The language: definition forms of a noun (POINT, CIRCLE, ...) or statements with a word.",
      "language");
  std::string word;
  bool json = false;
  app.add_option("WORD", word, "a noun or a word of the language; none lists the nouns");
  app.add_flag("--json", json, "all tables that the compiler is made of");
  if (const auto code = parse(app, invocation.words)) {
    return *code;
  }
  for (char& c : word) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  if (json) {
    printTables();
  } else if (word.empty()) {
    printNouns();
  } else if (!printLanguage(std::cout, word)) {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < static_cast<std::size_t>(Word::count); ++i) {
      known.emplace_back(spell(static_cast<Word>(i)));
    }
    if (const std::optional<Word> found = findWord(word)) {
      const bool placed = printPlaces(std::cout, word);
      if (printPages(std::cout, word) || placed) {
        return static_cast<int>(ExitCode::ok);
      }
      std::cout << fmt::format("{} is a word ({}) of other statements and has no form of its own\n",
                               word, className(row(*found).wordClass));
      return static_cast<int>(ExitCode::ok);
    }
    const std::string guess = nearest(word, known);
    printUsageError("language", "there is no form or statement of `" + word + "`" +
                                    (guess.empty() ? "" : "; did you mean `" + guess + "`?"));
    return static_cast<int>(ExitCode::wrongUse);
  }
  return static_cast<int>(ExitCode::ok);
}

}  // namespace arelem::app
