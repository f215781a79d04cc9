#include "backend/report/report.h"

#include <cmath>
#include <ostream>

#include <nlohmann/json.hpp>

#include "backend/report/spray_json.h"

namespace arelem::backend {

namespace {
using Json = nlohmann::ordered_json;

/// Zero has one sign; what is not finite is null, and the schema refuses it.
Json number(double value) {
  return value == 0.0 ? 0.0 : value;
}

Json deviation(const std::optional<ReportedMotion::Deviation>& value) {
  return value ? Json{{"inner", number(value->inner)}, {"outer", number(value->outer)}}
               : Json(nullptr);
}

Json motion(const ReportedMotion& m) {
  return {{"file", m.place.file},
          {"line", m.place.line},
          {"isn", m.isn},
          {"statement", m.statement},
          {"executions", m.executions},
          {"cutVectors", m.cutVectors},
          {"pathLength", number(m.pathLength)},
          {"drive", deviation(m.drive)},
          {"part", deviation(m.part)}};
}

Json totals(const Report& report) {
  std::uint64_t cutVectors = 0;
  double length = 0.0;
  for (const ReportedMotion& m : report.motions) {
    cutVectors += m.cutVectors;
    length += m.pathLength;
  }
  return {{"cutVectors", cutVectors}, {"pathLength", number(length)}};
}

Json timing(const Report& report) {
  Json motions = Json::array();
  for (const ReportedMotion& m : report.motions) {
    motions.push_back(number(m.seconds));
  }
  const Timing& t = *report.timing;
  return {{"parse", t.parse},
          {"evaluate", t.evaluate},
          {"execute", t.execute},
          {"write", t.write},
          {"motions", motions}};
}
}  // namespace

void writeReport(std::ostream& out, const Report& report) {
  Json document = {{"format", reportFormat},
                   {"tool", {{"name", "arelem"}, {"version", report.toolVersion}}},
                   {"sources", report.sources},
                   {"complete", report.complete},
                   {"diagnostics", {{"errors", report.errors}, {"warnings", report.warnings}}},
                   {"totals", totals(report)},
                   {"dialect", report.dialect},
                   {"statements", Json::object()},
                   {"features", Json::object()},
                   {"motions", Json::array()},
                   {"sprays", Json::array()},
                   {"wordsWithoutEffect", Json::array()}};
  for (const auto& [kind, count] : report.statements) {
    document["statements"][kind] = count;
  }
  for (const auto& [id, count] : report.features) {
    document["features"][id] = count;
  }
  for (const ReportedMotion& m : report.motions) {
    document["motions"].push_back(motion(m));
  }
  for (const ReportedSpray& s : report.sprays) {
    document["sprays"].push_back(sprayJson(s));
  }
  for (const WordWithoutEffect& w : report.wordsWithoutEffect) {
    document["wordsWithoutEffect"].push_back({{"file", w.place.file},
                                              {"line", w.place.line},
                                              {"word", w.word},
                                              {"reason", w.reason},
                                              {"times", w.times}});
  }
  if (report.timing) {
    document["timing"] = timing(report);
  }
  out << document.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace arelem::backend
