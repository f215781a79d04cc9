#include "tests/unit/backend/oracle_records.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace arelem::test {

namespace {
using nlohmann::json;

std::string textOf(const json& value) {
  return value.is_null() ? "" : value.get<std::string>();
}

Word wordOf(const json& value) {
  return findWord(value.get<std::string>()).value();
}

cl::SurfaceValue matrixOf(const json& value) {
  return {EntityType::matrix, textOf(value["name"]), value["sub"].get<int>(),
          value["m"].get<std::vector<double>>()};
}

cl::Value valueOf(const json& value) {
  if (value.is_number()) {
    return value.get<double>();
  }
  const auto text = value.get<std::string>();
  if (const auto word = findWord(text)) {
    return *word;
  }
  return text;
}

/// CLRSRF/plane: name or 0, subscript, four numbers.
cl::SurfaceValue planeOf(const json& args) {
  cl::SurfaceValue plane;
  plane.name = args[0].is_string() ? args[0].get<std::string>() : "";
  plane.subscript = args[1].get<int>();
  for (std::size_t i = 2; i < 6; ++i) {
    plane.canon.push_back(args[i].get<double>());
  }
  return plane;
}

cl::Body postOf(const json& item) {
  const Word word = wordOf(item["word"]);
  if (item.contains("text")) {
    return cl::Text{word, item["text"].get<std::string>()};
  }
  cl::Post post{word, "", {}};
  if (item.contains("matrix")) {
    post.arguments = {matrixOf(item["matrix"])};
  } else if (item.contains("copy")) {
    const json& copy = item["copy"];
    post.arguments = {copy["n"].get<double>(), wordOf(copy["mode"]), matrixOf(copy),
                      copy["count"].get<double>()};
  } else if (item.contains("args") && word == Word::CLRSRF && item["args"].size() == 6) {
    post.arguments = {planeOf(item["args"])};
  } else if (item.contains("args")) {
    for (const json& value : item["args"]) {
      post.arguments.push_back(valueOf(value));
    }
  }
  return post;
}

cl::Body motionOf(const json& item) {
  cl::Motion motion;
  motion.kind = static_cast<cl::Motion::Kind>(item["sub"].get<int>());
  motion.name = textOf(item["name"]);
  motion.subscript = item["subscript"].get<int>();
  for (const json& point : item["points"]) {
    motion.withAxis = point.size() == 6;
    for (const json& number : point) {
      motion.coordinates.push_back(number.get<double>());
    }
  }
  return motion;
}

cl::Body surfaceOf(const json& item) {
  cl::Surface surface;
  surface.role = item["sub"].get<int>();
  surface.condition = item["condition"].get<int>();
  surface.surface.type = entityType(wordOf(item["surf"])).value();
  surface.surface.name = textOf(item["name"]);
  surface.surface.subscript = item["subscript"].get<int>();
  surface.surface.canon = item["canon"].get<std::vector<double>>();
  return surface;
}

cl::Body bodyOf(const json& item) {
  switch (item["type"].get<int>()) {
    case 2000:
      return postOf(item);
    case 3000:
      return surfaceOf(item);
    case 5000:
      return motionOf(item);
    case 6000:
      return item.contains("values")
                 ? cl::Body(
                       cl::Values{wordOf(item["kind"]), item["values"].get<std::vector<double>>()})
                 : cl::Body(cl::Switch{wordOf(item["kind"])});
    case 9000:
      return cl::Multax{item["on"].get<bool>()};
    case 13000:
      return item.contains("number") ? cl::Body(cl::Diagnostic{item["number"].get<int>()})
                                     : cl::Body(cl::Listing{item["value"].get<int>() == 1});
    default:
      return cl::Fini{};
  }
}
}  // namespace

OracleCase readOracleCase(const std::filesystem::path& file) {
  OracleCase result;
  result.name = file.stem().string();
  std::ifstream in(file);
  result.cl = json::parse(in)["cl"];
  int last = 0;
  int isn = 0;
  for (const json& item : result.cl) {
    cl::Record record;
    record.isn = item["isn"].get<int>();
    const int step = item["rec"].get<int>() - last;
    const int expected = record.isn == isn ? 1 : 2;
    record.body = cl::Card{};
    for (int i = 1; i < step && step != expected; ++i) {
      result.records.push_back(record);
    }
    record.body = bodyOf(item);
    result.records.push_back(record);
    last = item["rec"].get<int>();
    isn = record.isn;
  }
  return result;
}

namespace {
std::vector<OracleCase> readFolders(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> files;
  for (const auto& folder : folders) {
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
      if (entry.path().extension() == ".json") {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<OracleCase> cases;
  for (const auto& file : files) {
    OracleCase read = readOracleCase(file);
    if (!read.records.empty()) {
      cases.push_back(std::move(read));
    }
  }
  return cases;
}
}  // namespace

std::vector<OracleCase> readOracleCases() {
  const std::filesystem::path data = std::filesystem::path(ARELEM_SOURCE_DIR) / "tests/data/oracle";
  return readFolders({data / "cases", data / "bad"});
}

std::vector<OracleCase> readOracleExamples() {
  const char* shared = std::getenv("ARELEM_SHARED");
  const std::filesystem::path folder = shared != nullptr
                                           ? std::filesystem::path(shared)
                                           : std::filesystem::path(ARELEM_SOURCE_DIR) / "../shared";
  return readFolders({folder / "oracle/examples"});
}

}  // namespace arelem::test
