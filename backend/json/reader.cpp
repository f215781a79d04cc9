#include "backend/json/reader.h"

#include <sstream>

#include <nlohmann/json.hpp>

#include "ir/diag/output.h"
#include "ir/words/words.h"

namespace arelem::backend {

namespace {
using nlohmann::json;

/// By the name that the writer gives it; what is none of them runs like a cylinder: nowhere.
EntityType surfaceType(std::string_view name) {
  for (const EntityType type : {EntityType::circle, EntityType::cylinder, EntityType::pathSpline}) {
    if (spell(type) == name) {
      return type;
    }
  }
  return EntityType::cylinder;
}

/// False unless all points have three numbers, all six or all nine.
bool readPoints(const json& points, cl::Motion& motion) {
  motion.coordinates.clear();
  const std::size_t numbers = points.empty() ? 3 : points.front().size();
  motion.withAxis = numbers == 6 || numbers == 9;
  motion.withSide = numbers == 9;
  for (const json& point : points) {
    if (point.size() != motion.stride()) {
      return false;
    }
    for (const json& number : point) {
      motion.coordinates.push_back(number.get<double>());
    }
  }
  return true;
}

cl::Value argument(const json& value) {
  if (value.is_number()) {
    return value.get<double>();
  }
  const std::string text = value.get<std::string>();
  const std::optional<Word> word = findWord(text);
  return word ? cl::Value(*word) : cl::Value(text);
}

cl::Body post(const json& row) {
  const std::string name = row.at("word").get<std::string>();
  const std::optional<Word> word = findWord(name);
  if (row.contains("text")) {
    return cl::Text{word.value_or(Word::PPRINT), row["text"].get<std::string>()};
  }
  cl::Post made{word.value_or(Word::END), word ? "" : name, {}};
  for (const json& value : row.value("args", json::array())) {
    if (value.is_number() || value.is_string()) {  // a matrix has done its work before
      made.arguments.push_back(argument(value));
    }
  }
  return made;
}

/// Records that are no motion. Rows of other kinds say nothing of the path.
cl::Body command(const std::string& kind, const json& row) {
  const std::optional<Word> word = findWord(kind);
  if (kind == "POST") {
    return post(row);
  }
  if (kind == "FINI") {
    return cl::Fini{};
  }
  if (kind == "MULTAX") {
    return cl::Multax{row.value("on", true)};
  }
  if (kind == "UNITS") {
    return cl::Units{findWord(row.at("unit").get<std::string>()).value_or(Word::MM)};
  }
  if (word && row.contains("values")) {
    return cl::Values{*word, row["values"].get<std::vector<double>>()};
  }
  const bool isSwitch =
      word && (*word == Word::CUT || *word == Word::DNTCUT || *word == Word::W_2DCALC ||
               *word == Word::W_3DCALC || *word == Word::NDTEST);
  return isSwitch ? cl::Body(cl::Switch{*word}) : cl::Body(cl::Card{});
}

bool hand(const json& row, cl::RecordSink& records) {
  cl::Record record;
  record.isn = row.at("isn").get<int>();
  record.body = cl::Card{};
  const std::string kind = row.at("kind").get<std::string>();
  if (kind == "FROM" || kind == "GOTO" || kind == "CONT") {
    cl::Motion motion;
    motion.kind = kind == "FROM"   ? cl::Motion::Kind::from
                  : kind == "GOTO" ? cl::Motion::Kind::go
                                   : cl::Motion::Kind::continuation;
    if (row.contains("name") && row["name"].is_string()) {
      motion.name = row["name"].get<std::string>();
      motion.subscript = row.value("subscript", 0);
    }
    if (!readPoints(row.at("points"), motion)) {
      return false;
    }
    if (row.contains("way")) {
      const std::string way = row["way"].get<std::string>();
      motion.way = way == "SPLINE" ? cl::Motion::Way::spline
                   : way == "CLW"  ? cl::Motion::Way::clockwise
                                   : cl::Motion::Way::counterclockwise;
    }
    record.body = std::move(motion);
  } else if (kind == "SURFACE") {
    cl::Surface surface;
    surface.surface.type = surfaceType(row.at("surf").get<std::string>());
    surface.surface.canon = row.at("canon").get<std::vector<double>>();
    record.body = std::move(surface);
  } else {
    record.body = command(kind, row);
  }
  records.accept(record);
  return true;
}
}  // namespace

bool readJsonRecords(std::istream& in,
                     std::string_view file,
                     cl::RecordSink& records,
                     DiagnosticSink& sink) {
  const auto object = [&](const std::string& part, std::uint64_t line) {
    std::string reason = "the points have not all three, all six or all nine numbers";
    try {
      const json row = json::parse(part);
      bool good = true;
      if (row.contains("cl")) {
        for (const json& record : row["cl"]) {
          good = good && hand(record, records);
        }
      } else {
        good = hand(row, records);
      }
      if (good) {
        return true;
      }
    } catch (const json::exception& e) {
      reason = e.what();
    }
    sink.accept(diagnose(Span{}, diag::JsonUnreadable, file, line, reason));
    return false;
  };
  std::string line;
  for (std::uint64_t number = 1; std::getline(in, line); ++number) {
    if (number == 1 && !in.eof() && !line.ends_with('}')) {
      std::ostringstream rest;  // one object over many lines
      rest << line << '\n' << in.rdbuf();
      return object(std::move(rest).str(), 1);
    }
    if (line.find_first_not_of(" \t\r") != std::string::npos && !object(line, number)) {
      return false;
    }
  }
  return true;
}

}  // namespace arelem::backend
