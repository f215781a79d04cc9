#include <algorithm>
#include <limits>
#include <optional>
#include <ostream>

#include "app/stencil_report.h"

namespace arelem::app {

namespace {
using stencil::PaintedCell;

void addPath(backend::CellPicture& picture, const stencil::Painted& painted) {
  for (const stencil::Track& track : painted.tracks) {
    auto& way = picture.path.emplace_back();
    for (const stencil::Pose& pose : track.poses) {
      way.emplace_back(pose.place.x(), pose.place.y());
    }
  }
}

std::string titleOf(const stencil::Painted& painted) {
  const stencil::Evenness even = stencil::evennessOf(painted.tracks, painted.statement.job.gun);
  return fmt::format("{}: film {:.3f} to {:.3f} of its mean, halves of cells {:.1f} to {:.1f} %",
                     painted.statement.text, even.film.least, even.film.most, even.leastShare,
                     even.mostShare);
}
}  // namespace

backend::CellPicture filmPictureOf(const stencil::Painted& painted) {
  backend::CellPicture picture;
  picture.title = titleOf(painted);
  picture.legend = "film over the mean film";
  picture.levels = {0.75, 0.8, 0.85, 0.9, 0.95, 0.98, 1.02, 1.05, 1.1, 1.15, 1.2, 1.25};
  const auto bandOf = [&](double film) {
    return std::upper_bound(picture.levels.begin(), picture.levels.end(), film) -
           picture.levels.begin();
  };
  std::size_t cell = std::numeric_limits<std::size_t>::max();
  std::optional<std::ptrdiff_t> band;  // that all corners of the quad before lie in
  for (const stencil::FilmPatch& patch :
       stencil::filmPatches(painted.tracks, painted.statement.job.gun)) {
    const auto [least, most] = std::minmax_element(patch.film.begin(), patch.film.end());
    const auto own = bandOf(*least) == bandOf(*most) ? std::optional(bandOf(*least)) : std::nullopt;
    const bool goesOn = patch.cell == cell && own && own == band;
    cell = patch.cell;
    band = own;
    if (goesOn) {  // strips of one cell in one band are one quad
      for (const std::size_t i : {1U, 2U}) {
        picture.quads.back().corner[i] = {patch.corner[i].x(), patch.corner[i].y()};
        picture.quads.back().value[i] = patch.film[i];
      }
      continue;
    }
    backend::ShadedQuad& quad = picture.quads.emplace_back();
    for (std::size_t i = 0; i < patch.corner.size(); ++i) {
      quad.corner[i] = {patch.corner[i].x(), patch.corner[i].y()};
      quad.value[i] = patch.film[i];
    }
  }
  addPath(picture, painted);
  return picture;
}

backend::CellPicture sharePictureOf(const stencil::Painted& painted) {
  backend::CellPicture picture;
  picture.title = titleOf(painted);
  picture.legend = "share of the cell, %";
  picture.levels = {42.0, 44.0, 46.0, 48.0, 49.0, 49.5, 50.5, 51.0, 52.0, 54.0, 56.0, 58.0};
  picture.middle = 50.0;
  picture.decimals = 1;
  const double fan = painted.statement.job.gun.fan;
  for (const PaintedCell& cell : stencil::cellsOf(painted.tracks, painted.statement.job.gun)) {
    const auto [a, b] = cell.lines();
    const double s = stencil::shareOf(cell.tilt, fan);
    const auto at = [](const stencil::Line& line, double share) {
      const stencil::Vec2 p = line.first + share * (line.second - line.first);
      return std::pair{p.x(), p.y()};
    };
    for (const bool first : {true, false}) {
      backend::ShadedQuad& quad = picture.quads.emplace_back();
      const double low = first ? 0.0 : s;
      const double high = first ? s : 1.0;
      quad.corner = {at(a, low), at(a, high), at(b, high), at(b, low)};
      quad.value.fill(first ? cell.share : 100.0 - cell.share);
    }
  }
  addPath(picture, painted);
  return picture;
}

void writeCellsCsv(std::ostream& out, const stencil::Painted& painted) {
  const stencil::FanGun& gun = painted.statement.job.gun;
  const std::vector<PaintedCell> cells = stencil::cellsOf(painted.tracks, gun);
  const double rate = stencil::meanRate(cells);
  out << "symbol,position,stroke,x_mm,y_mm,z_mm,width_mm,yaw_deg,tilt_deg,speed_mm_s,area_mm2,"
         "share_first,share_second,film_mean,film_least,film_most\n";
  for (const PaintedCell& cell : cells) {
    const stencil::Pose& pose = cell.track->poses[cell.pose];
    const auto [a, b] = cell.lines();
    const double film = cell.area > 0.0 && rate > 0.0 ? cell.seconds / cell.area / rate : 1.0;
    const stencil::Spread spread = stencil::spreadOf(a, b, gun.fan, cell.tilt);
    out << fmt::format(
        "{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},"
        "{:.4f},{:.5f},{:.5f},{:.5f}\n",
        cell.track->symbol, cell.track->position, cell.track->stroke, pose.place.x(),
        pose.place.y(), pose.height, stencil::widthOf(pose.line), pose.yaw, pose.tilt, pose.speed,
        cell.area, cell.share, 100.0 - cell.share, film, film * spread.least, film * spread.most);
  }
}

}  // namespace arelem::app
