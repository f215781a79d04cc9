#include "app/statement_word.h"

#include <array>

namespace arelem::app {

namespace {
struct KindName {
  std::string operator()(const ir::Assign&) const { return "assignment"; }
  std::string operator()(const ir::Define&) const { return "definition"; }
  std::string operator()(const ir::Branch&) const { return "IF"; }
  std::string operator()(const ir::Jump&) const { return "JUMPTO"; }
  std::string operator()(const ir::Call&) const { return "CALL"; }
  std::string operator()(const ir::Obtain&) const { return "OBTAIN"; }
  std::string operator()(const ir::Text& text) const { return std::string(spell(text.word)); }
  std::string operator()(const ir::Locate& locate) const { return std::string(spell(locate.word)); }
  std::string operator()(const ir::LocateNumbers& locate) const {
    return std::string(spell(locate.word));
  }
  std::string operator()(const ir::Startup& startup) const {
    return startup.offset ? "OFFSET" : "GO";
  }
  std::string operator()(const ir::Follow& follow) const {
    constexpr std::array words = {"GOLFT", "GORGT", "GOFWD", "GOBACK", "GOUP", "GODOWN"};
    return words.at(static_cast<std::size_t>(follow.heading));
  }
  std::string operator()(const ir::Transfer&) const { return "TRANTO"; }
  std::string operator()(const ir::Fini&) const { return "FINI"; }
  std::string operator()(const ir::Command& command) const {
    return std::string(spell(command.word));
  }
  std::string operator()(const ir::ForeignCommand& command) const { return command.word; }
};

}  // namespace

std::string statementWord(const ir::Body& body) {
  return std::visit(KindName{}, body);
}

}  // namespace arelem::app
