// Every program that the old system accepted compiles, and its statement numbers agree with the old
// ones.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <nlohmann/json.hpp>

#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

namespace fs = std::filesystem;

std::set<std::uint32_t> isnsOf(const ir::Program& program) {
  std::set<std::uint32_t> isns;
  for (const auto& block : program.blocks) {
    for (const auto& s : block.statements) {
      isns.insert(s.isn);
    }
  }
  return isns;
}

/// Checks one program against the record numbers of its result. Words of post statements pin the
/// number to the right statement.
void compare(const fs::path& source, const fs::path& result) {
  const auto c = compileText(readFile(source));
  std::string errors;
  for (const Diagnostic& d : c->sink.all()) {
    errors += d.severity() == Severity::error ? d.message + "\n" : "";
  }
  EXPECT_EQ(errors, "") << source;
  const auto isns = isnsOf(c->program);
  const auto json = nlohmann::json::parse(readFile(result));
  for (const auto& record : json.at("cl")) {
    const int isn = record.value("isn", 0);
    EXPECT_TRUE(isns.contains(static_cast<std::uint32_t>(isn))) << source << " isn " << isn;
    const bool fini = record.at("kind") == "FINI";
    if (fini) {
      const auto& last = c->program.blocks[0].statements.back();
      EXPECT_EQ(last.isn, static_cast<std::uint32_t>(isn)) << source;
    }
    if (record.at("kind") == "POST" && record.value("text", "") != "") {
      bool found = false;
      std::string wanted = record["text"];
      wanted.erase(wanted.find_last_not_of(" \t") + 1);
      for (const auto& block : c->program.blocks) {
        for (const auto& s : block.statements) {
          const auto* text = std::get_if<ir::Text>(&s.body);
          found =
              found || (text != nullptr && static_cast<int>(s.isn) == isn && text->text == wanted);
        }
      }
      EXPECT_TRUE(found) << source << " text at isn " << isn << ": " << record["text"];
    }
  }
}

TEST(Oracle, CasesCompileWithTheOldStatementNumbers) {
  int count = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(ARELEM_SOURCE_DIR) / "tests/data/oracle/cases")) {
    if (entry.path().extension() == ".apt") {
      compare(entry.path(), fs::path(entry.path()).replace_extension(".json"));
      ++count;
    }
  }
  EXPECT_GT(count, 50);
}

fs::path sharedFolder() {
  const char* set = std::getenv("ARELEM_SHARED");
  return set != nullptr ? fs::path(set) : fs::path(ARELEM_SOURCE_DIR) / "../shared";
}

/// Examples of the old system; those that call macros of its library (which is lost) are left out.
TEST(Oracle, ExamplesCompileWithTheOldStatementNumbers) {
  const fs::path shared = sharedFolder();
  if (!fs::exists(shared / "oracle/examples")) {
    GTEST_SKIP() << "no examples at " << shared << " (set ARELEM_SHARED)";
  }
  int count = 0;
  for (const auto& entry : fs::directory_iterator(shared / "oracle/examples")) {
    const fs::path source =
        shared / "corpus/aptos-apt360" / entry.path().filename().replace_extension(".apt");
    std::string text = fs::exists(source) ? readFile(source) : "";
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char ch) { return std::tolower(ch); });
    if (!text.empty() && text.find("\nlibry/") == std::string::npos) {
      compare(source, entry.path());
      ++count;
    }
  }
  EXPECT_GE(count, 20);
}

TEST(Oracle, BadProgramsGiveTheOldErrors) {
  const fs::path folder = fs::path(ARELEM_SOURCE_DIR) / "tests/data/oracle/bad";
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"b01_undefined_symbol", "101"},
      {"b03_paren", "10"},
      {"b14_no_fini", "23"},
      {"b16_macro_args", "230 233"},
      {"b17_subscript", "104 104 108"},
      {"b21_dup_label", "6"}};
  for (const auto& [name, legacy] : expected) {
    EXPECT_EQ(compileText(readFile(folder / (name + ".apt")))->legacy(), legacy) << name;
  }
  for (const auto& [name, legacy] :
       {std::pair("b02_name_too_long", "1"), std::pair("b15_jumpto", "407")}) {
    const std::string text = readFile(folder / (std::string(name) + ".apt"));
    EXPECT_EQ(compileText(text, Dialect::apt360)->legacy(), legacy) << name;
  }
}

}  // namespace
}  // namespace arelem::frontend
