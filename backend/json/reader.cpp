#include "backend/json/reader.h"

#include <nlohmann/json.hpp>

#include "ir/diag/output.h"

namespace arelem::backend {

namespace {
using nlohmann::json;

/// Null unless all points have three or six numbers.
bool readPoints(const json& points, cl::Motion& motion) {
  motion.coordinates.clear();
  motion.withAxis = !points.empty() && points.front().size() == 6;
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
    surface.surface.type = row.at("surf") == "CIRCLE" ? EntityType::circle : EntityType::cylinder;
    surface.surface.canon = row.at("canon").get<std::vector<double>>();
    record.body = std::move(surface);
  }
  records.accept(record);
  return true;
}
}  // namespace

bool readJsonRecords(std::string_view text,
                     std::string_view file,
                     cl::RecordSink& records,
                     DiagnosticSink& sink) {
  const auto object = [&](std::string_view part, std::uint64_t line) {
    std::string reason = "a point has neither three nor six numbers";
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
  const std::size_t second = text.find('\n');
  const bool lines = second == std::string_view::npos || text.substr(0, second).ends_with('}');
  if (!lines) {
    return object(text, 1);
  }
  std::uint64_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++number;
    const std::string_view line = text.substr(begin, end - begin);
    if (line.find_first_not_of(" \t\r") != std::string_view::npos && !object(line, number)) {
      return false;
    }
    begin = end + 1;
  }
  return true;
}

}  // namespace arelem::backend
