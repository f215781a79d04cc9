// The fast lanes give what the slow ones give.
#include "frontend/lex/lexer.h"
#include "frontend/parse/parse.h"
#include "frontend/read/card_reader.h"
#include "frontend/read/fast_lane.h"
#include "tests/unit/frontend/program_text.h"

namespace arelem::frontend {
namespace {

void print(const StatementTree& tree, NodeId id, std::string& out) {
  for (; id != noNode; id = tree[id].next) {
    const Node& n = tree[id];
    out += fmt::format("[{} {} {} {} {}..{}", static_cast<int>(n.kind), static_cast<int>(n.word),
                       n.number, n.text, n.span.begin, n.span.length);
    if (n.target != noNode) {
      print(tree, n.target, out += " target ");
    }
    print(tree, n.first, out);
    out += "]";
  }
}

std::string shape(const StatementTree& tree) {
  std::string out = fmt::format("{} {} {} ", static_cast<int>(tree.shape), tree.label, tree.slash);
  for (const NodeId id : {tree.head, tree.arguments, tree.target, tree.value}) {
    print(tree, id, out);
    out += ";";
  }
  return out;
}

TEST(Lanes, PlainStatementsGiveTheTreeOfTheGrammar) {
  const std::vector<std::string> texts = {"P1=POINT/1,2,3",
                                          "P1=POINT/-1,+A,INTOF",
                                          "A=1",
                                          "A=-B",
                                          "10)A=+B",
                                          "RAPID",
                                          "RAPID,GOTO/1,-2,3",
                                          "TLON,TLONPS,GOLFT/L1,TO,L2",
                                          "X)",
                                          "CUTTER/1,2",
                                          "PATERN/1,2",
                                          "GOTO/",
                                          "CUTTER,OPTION,1,2",
                                          "A=POINT/",
                                          "SPINDL/A,CIRCLE"};
  Options options;
  CollectingSink sink;
  Reporter reporter(sink, options.limits);
  const Vocabulary vocabulary(Dialect::automatic);
  Lexer lexer(vocabulary, options, reporter);
  StatementParser parser(options.limits);
  int plain = 0;
  for (const std::string& text : texts) {
    SourceMap sources;
    const BufferId buffer = sources.add("x", text);
    std::uint32_t isn = 1;
    CardReader reader(sources, buffer, options, reporter, isn);
    StatementText statement;
    reader.next(statement, false);
    std::vector<Token> tokens;
    ASSERT_TRUE(lexer.run(statement, tokens)) << text;
    StatementTree fast;
    StatementTree slow;
    ASSERT_FALSE(parser.parseWithGrammar(tokens, slow).has_value()) << text;
    if (parsePlain(tokens, fast)) {
      ++plain;
      EXPECT_EQ(shape(fast), shape(slow)) << text;
    }
  }
  EXPECT_GE(plain, 10);
}

TEST(Lanes, NumberLinesGiveTheStatementOfTheParser) {
  const std::vector<std::string> lines = {
      "GOTO/1,2,3",   "goto / 1.5 , -2.25,+3.", "FROM/0,0,0,0,0,1",   "GOTO/1.5E-3,2.E2,.5",
      "  GOTO/1,2",   "GOTO/1,2,3,4,5,6,7",     "GOTO/-0,0.1,100000", "GOTO/123456789.123456,1,1",
      "GOTO/1,2,3\t", "FROM/1,2,3,100",         "GOTO/1,2,3 $$ P1"};
  for (const std::string& line : lines) {
    FastLine fast;
    EXPECT_EQ(readFastLine(line, fast), FastLane::whole) << line;
    const auto quick = compileText(line + "\nFINI\n");
    const auto slow = compileText("X) " + line + "\nFINI\n");  // a label keeps it out of the lane
    EXPECT_EQ("X) " + quick->block()[0], slow->block()[0]);
    const auto* a = std::get_if<ir::LocateNumbers>(&quick->program.blocks[0].statements[0].body);
    const auto* b = std::get_if<ir::LocateNumbers>(&slow->program.blocks[0].statements[0].body);
    ASSERT_TRUE(a != nullptr && b != nullptr) << line;
    EXPECT_EQ(a->numbers, b->numbers);
  }
}

TEST(Lanes, UnusualLinesAreLeftToTheParser) {
  for (const std::string line : {"GOTO/1,2,A",
                                 "GOTO/1E5,2,3",
                                 "GOTO/1 2,3,4",
                                 "GOTO/1,2,3, $$",
                                 "GOTO/1,2,3 $ more",
                                 "GODLTA/1",
                                 "GODLTA/1,2,3,4",
                                 "GOTO/1,2,3,",
                                 "GOTO/1",
                                 "GOTO/1,2,3,4,5",
                                 "GOTO/nan,1,2",
                                 "GOTO/inf,1,2",
                                 "GOTO/1.e999,1,2",
                                 "GOTO/--1,2,3",
                                 "GOTO/+-1,2,3",
                                 "GOTO",
                                 "GOTO/",
                                 "GOTO/1,2,3,4,5,6,7,8",
                                 "A)GOTO/1,2,3",
                                 "GOTO=1",
                                 "GOTO/1.2.3,4,5",
                                 "GOTO/12345678901234567.,1,2",
                                 "GOTO/0x10,1,2",
                                 "FROMX/1,2,3"}) {
    FastLine fast;
    EXPECT_EQ(readFastLine(line, fast), FastLane::none) << line;
  }
}

TEST(Lanes, StepsAreReadToo) {
  FastLine fast;
  EXPECT_EQ(readFastLine("godlta/1,-2,.5", fast), FastLane::whole);
  EXPECT_EQ(fast.numbers.word, Word::GODLTA);
  EXPECT_EQ(fast.numbers.count, 3);
  EXPECT_EQ(fast.numbers.numbers[1], -2.0);
}

TEST(Lanes, NumbersGoOnInTheNextLine) {
  const auto numbersOf = [](const std::string& text) {
    const auto read = compileText(text + "\nFINI\n");
    std::vector<std::string> statements = read->block();
    const Span at = read->program.blocks[0].statements[0].span;
    return std::pair(statements, at.end());
  };
  const std::string slow = "A)GOTO/1,2,3,0,0,1\nFINI\n";
  const std::string wanted = compileText(slow)->block()[0].substr(3);
  for (const std::string text : {"GOTO/1,2,3,$\n0,0,1", "GOTO/1,2,3 $ \n ,0,0,1",
                                 "GOTO/$\r\n1,2,$\r\n3,0,0,1", "GOTO/1,2,3,0,0,1$\n"}) {
    const auto [statements, end] = numbersOf(text);
    ASSERT_EQ(statements.size(), 2U) << text;
    EXPECT_EQ(statements[0], wanted) << text;
    EXPECT_EQ(end, text.find_last_of('1') + 1) << text;
  }
  // A number in two parts, a comment behind the sign and a missing line are the parser's.
  EXPECT_EQ(numbersOf("GOTO/1,2,1$\n2").first[0], numbersOf("GOTO/1,2,12").first[0]);
  EXPECT_EQ(numbersOf("GOTO/1,2,$ half\n3").first[0], numbersOf("GOTO/1,2,3").first[0]);
}

}  // namespace
}  // namespace arelem::frontend
