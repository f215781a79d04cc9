#include "backend/report/spray_json.h"

#include <cmath>
#include <ostream>

namespace arelem::backend {

namespace {
using Json = nlohmann::ordered_json;

/// Zero has one sign; what is not finite is null.
Json number(double value) {
  return value == 0.0 ? Json(0.0) : std::isfinite(value) ? Json(value) : Json(nullptr);
}
Json optional(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json costJson(const ReportedSpray::Cost& cost) {
  return {{"total", number(cost.total)},         {"paintingTime", number(cost.parts[0])},
          {"travelTime", number(cost.parts[1])}, {"overspray", number(cost.parts[2])},
          {"sprayBy", number(cost.parts[3])},    {"film", number(cost.parts[4])}};
}

Json trialJson(const ReportedSpray::Trial& t) {
  return {{"b", number(t.across)},        {"angle", number(t.degrees)}, {"preferred", t.preferred},
          {"passes", t.passes},           {"Xi", number(t.painted)},    {"Xo", number(t.unpainted)},
          {"Ti", number(t.paintingTime)}, {"To", number(t.travelTime)}, {"v", number(t.speed)},
          {"q", number(t.flow)},          {"cost", costJson(t.cost)}};
}

Json simulatedJson(const std::optional<ReportedSpray::Simulated>& s) {
  if (!s) {
    return nullptr;
  }
  return {{"cell", number(s->cell)},        {"mean", number(s->mean)},
          {"min", number(s->smallest)},     {"max", number(s->largest)},
          {"R1", number(s->uniformity[0])}, {"R2", number(s->uniformity[1])},
          {"R3", number(s->uniformity[2])}, {"within10percent", number(s->within10)},
          {"onWork", number(s->onWork)},    {"beside", number(s->beside)}};
}
}  // namespace

Json sprayJson(const ReportedSpray& s) {
  Json trials = Json::array();
  for (const ReportedSpray::Trial& trial : s.trials) {
    trials.push_back(trialJson(trial));
  }
  return {{"file", s.place.file},
          {"line", s.place.line},
          {"isn", s.isn},
          {"work", s.work},
          {"kind", s.planar ? "region" : "surface"},
          {"boundaries", s.boundaries},
          {"holes", s.holes},
          {"area", number(s.area)},
          {"film", number(s.film)},
          {"a", number(s.along)},
          {"b", number(s.across)},
          {"standOff", number(s.standOff)},
          {"overlap", number(s.overlap)},
          {"inset", number(s.inset)},
          {"angle", number(s.degrees)},
          {"passes", s.passes},
          {"interval", number(s.interval)},
          {"past", number(s.past)},
          {"traverses",
           {{"count", s.traverses}, {"round", s.waysRound}, {"clearance", number(s.clearance)}}},
          {"Xi", number(s.painted)},
          {"Xo", number(s.unpainted)},
          {"Ti", number(s.paintingTime)},
          {"To", number(s.travelTime)},
          {"Tmin", number(s.shortestTime)},
          {"v", number(s.speed)},
          {"q", number(s.flow)},
          {"R1", number(s.uniformity[0])},
          {"R2", number(s.uniformity[1])},
          {"R3", number(s.uniformity[2])},
          {"edge", {{"film", number(s.edgeFilm)}, {"mean", number(s.edgeMean)}}},
          {"paint",
           {{"used", number(s.used)},
            {"deposited", number(s.deposited)},
            {"overspray", number(s.overspray)},
            {"sprayBy", number(s.sprayBy)},
            {"missing", number(s.missing)}}},
          {"cost", s.cost ? costJson(*s.cost) : Json(nullptr)},
          {"simulated", simulatedJson(s.simulated)},
          {"curvature",
           {{"along", optional(s.radiusAlong)},
            {"across", optional(s.radiusAcross)},
            {"advice", s.advice}}},
          {"trials", std::move(trials)}};
}

void writeSprayJson(std::ostream& out, const std::vector<ReportedSpray>& all) {
  Json list = Json::array();
  for (const ReportedSpray& one : all) {
    list.push_back(sprayJson(one));
  }
  out << list.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace arelem::backend
