#pragma once
#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "backend/report/place.h"

namespace arelem::backend {

/// What one SPRAY statement amounts to, for people and programs. mm, mm2, s, l/min, liters, $.
struct ReportedSpray {
  SourcePlace place;
  int isn = 0;
  std::string work;  ///< name of the region or surface
  bool planar = true;
  std::size_t boundaries = 0, holes = 0;
  double area = 0.0;
  double film = 0.0;
  double along = 0.0, across = 0.0;  ///< half axes a and b of the footprint
  double standOff = 0.0;
  double overlap = 0.0, inset = 0.0;
  double degrees = 0.0;
  std::size_t passes = 0;
  double interval = 0.0;
  double painted = 0.0, unpainted = 0.0;                               ///< X_i, X_o
  double paintingTime = 0.0, travelTime = 0.0;                         ///< T_i, T_o
  double shortestTime = 0.0;                                           ///< T_min
  double speed = 0.0, flow = 0.0;                                      ///< v, q
  double used = 0.0, deposited = 0.0, overspray = 0.0, sprayBy = 0.0;  ///< liters
  double missing = 0.0;  ///< liters that the film on all the work takes more than is sprayed
  std::array<double, 3> uniformity{};     ///< R1, R2, R3
  double edgeFilm = 0.0, edgeMean = 0.0;  ///< relative to the wanted film
  struct Cost {
    double total = 0.0;
    std::array<double, 5> parts{};
  };
  std::optional<Cost> cost;
  struct Simulated {
    double cell = 0.0;
    double mean = 0.0, smallest = 0.0, largest = 0.0;
    std::array<double, 3> uniformity{};
    double within10 = 0.0;
    double onWork = 0.0, beside = 0.0;  ///< liters
  };
  std::optional<Simulated> simulated;
  struct Trial {
    double across = 0.0, degrees = 0.0;
    bool preferred = false;
    std::size_t passes = 0;
    double painted = 0.0, unpainted = 0.0, paintingTime = 0.0, travelTime = 0.0;
    double speed = 0.0, flow = 0.0;
    Cost cost;
  };
  std::vector<Trial> trials;
  /// Of a surface.
  std::optional<double> radiusAlong, radiusAcross;
  double past = 0.0;                         ///< how far lines go on beyond the edges
  std::size_t traverses = 0, waysRound = 0;  ///< from line to line; those that do not go straight
  double clearance = 0.0;                    ///< how far they stay off the work, 0: not looked at
  std::string advice;
};

/// A paragraph for people.
void writeSprayText(std::ostream& out, const ReportedSpray& spray);
/// The trials as a table, the cheapest marked; one row where nothing is searched.
void writeSprayTable(std::ostream& out, const ReportedSpray& spray);
/// A JSON array of all statements.
void writeSprayJson(std::ostream& out, const std::vector<ReportedSpray>& all);

}  // namespace arelem::backend
