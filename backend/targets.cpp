#include <algorithm>
#include <array>
#include <cctype>

#include "backend/backend.h"
#include "backend/cltape/writer.h"
#include "backend/cltext/writer.h"
#include "backend/json/writer.h"

namespace arelem::backend {

namespace {
const std::array table = {
    Target{"cl",
           "ASCII CL statements, as postprocessors read them",
           {".cls", ".cl", ".aptcl"},
           false,
           true,
           makeTextWriter},
    Target{"cltape",
           "binary CL tape (class 1000 to 14000 records)",
           {".cltape", ".clt"},
           true,
           true,
           makeTapeWriter},
    Target{
        "json", "CL records as JSON, one a line", {".jsonl", ".json"}, false, true, makeJsonWriter},
};

bool endsWithIgnoringCase(std::string_view path, std::string_view suffix) {
  if (path.size() <= suffix.size()) {
    return false;
  }
  const std::string_view tail = path.substr(path.size() - suffix.size());
  return std::equal(tail.begin(), tail.end(), suffix.begin(), [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  });
}
}  // namespace

std::span<const Target> targets() {
  return table;
}

const Target* findTarget(std::string_view name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Target& t) { return t.name == name; });
  return found == table.end() ? nullptr : &*found;
}

const Target* targetForFile(std::string_view path) {
  for (const Target& target : table) {
    for (const std::string_view suffix : target.suffixes) {
      if (endsWithIgnoringCase(path, suffix)) {
        return &target;
      }
    }
  }
  return nullptr;
}

}  // namespace arelem::backend
