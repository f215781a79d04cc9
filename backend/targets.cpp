#include <algorithm>
#include <array>
#include <cctype>

#include "backend/backend.h"
#include "backend/cltape/writer.h"
#include "backend/cltext/writer.h"
#include "backend/deck/writer.h"
#include "backend/g97/writer.h"
#include "backend/ir/writer.h"
#include "backend/joints/writer.h"
#include "backend/json/writer.h"
#include "backend/listing/writer.h"
#include "backend/ngc/writer.h"
#include "backend/svg/writer.h"
#include "backend/vplus/writer.h"

namespace arelem::backend {

namespace {
const std::array table = {
    Target{.name = "cl",
           .summary = "ASCII CL statements, as postprocessors read them",
           .suffixes = {".cls", ".cl", ".aptcl"},
           .readsBack = true,
           .takesCurves = true,
           .make = makeTextWriter},
    Target{.name = "cltape",
           .summary = "binary CL tape, record classes 1000 to 14000",
           .suffixes = {".cltape", ".clt"},
           .binary = true,
           .readsBack = true,
           .takesCurves = true,
           .make = makeTapeWriter},
    Target{.name = "json",
           .summary = "CL records as JSON, one a line",
           .suffixes = {".jsonl", ".json"},
           .takesCurves = true,
           .make = makeJsonWriter},
    Target{.name = "listing",
           .summary = "program, printed values and CL records to read",
           .suffixes = {".lst"},
           .needsProgram = true,
           .takesCurves = true,
           .make = makeListingWriter},
    Target{.name = "ir",
           .summary = "the checked program, before evaluation",
           .suffixes = {".ir"},
           .needsMotion = false,
           .needsProgram = true,
           .make = makeProgramWriter},
    Target{.name = "deck",
           .summary = "what PUNCH and PRINT/4 write, for READ/1",
           .suffixes = {".deck"},
           .needsMotion = false,
           .needsProgram = true,
           .make = makeDeckWriter},
    Target{.name = "ngc",
           .summary = "RS-274 for machine controls",
           .suffixes = {".ngc", ".nc", ".tap"},
           .make = makeNgcWriter},
    Target{.name = "joints",
           .summary = "joints of a painting arm over time, CSV; needs --machine",
           .suffixes = {".joints.csv", ".joints"},
           .make = makeJointTableWriter},
    Target{.name = "joint-plots",
           .summary = "the same as curves, SVG; needs --machine",
           .suffixes = {".joints.svg"},
           .make = makeJointPlotWriter},
    Target{.name = "g97",
           .summary = "programs of Fanuc R-G2 painting robots",
           .suffixes = {".lng"},
           .readsBack = true,
           .make = makeG97Writer},
    Target{.name = "svg",
           .summary = "picture of the tool path and its geometry",
           .suffixes = {".svg"},
           .make = makePictureWriter},
    Target{.name = "vplus",
           .summary = "V+ program for Adept and Staubli controllers",
           .suffixes = {".v2", ".pg"},
           .readsBack = true,
           .make = makeVplusWriter},
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
