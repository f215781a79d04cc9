#include "runtime/stencil/stencil.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "ir/space/stencil_tolerance.h"

namespace arelem::stencil {

namespace {
/// The same stroke in the same direction: planned alike wherever it stands.
using Kind = std::tuple<std::string, std::size_t, bool>;
Kind kindOf(const Run& run) {
  return {run.symbol, run.stroke, run.backwards};
}

Track shifted(Track track, const Vec2& by) {
  for (Pose& pose : track.poses) {
    pose.place += by;
    pose.line.first += by;
    pose.line.second += by;
  }
  return track;
}

Result<std::vector<Track>> planAll(const std::vector<Run>& runs, const Job& job) {
  std::vector<Track> tracks;
  std::map<Kind, std::size_t> known;  // index of run and track
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    if (const auto [entry, isNew] = known.try_emplace(kindOf(run), i); !isNew) {
      const Run& first = runs[entry->second];
      tracks.push_back(
          shifted(tracks[entry->second], run.lines.front().first - first.lines.front().first));
      tracks.back().position = run.position;
      continue;
    }
    Result<Track> track = planRun(run, job);
    if (!track) {
      return track.takeFailure();
    }
    tracks.push_back(*std::move(track));
  }
  return tracks;
}

double fastestOf(const std::vector<Track>& tracks) {
  double fastest = 0.0;
  for (const Track& track : tracks) {
    for (const Pose& pose : track.poses) {
      fastest = std::max(fastest, pose.speed);
    }
  }
  return fastest;
}

/// The paint constant for which the fastest move has the largest speed of the gun. Tilts turn
/// slower when the gun does, which changes its ways a little: so it is looked for again.
Result<double> fastestJob(const std::vector<Run>& runs, Job job) {
  const double most = job.gun.speed;
  job.gun.speed = 0.0;
  job.speedTimesWidth = 1.0;
  std::vector<Run> kinds;
  std::set<Kind> known;
  std::copy_if(runs.begin(), runs.end(), std::back_inserter(kinds),
               [&](const Run& run) { return known.insert(kindOf(run)).second; });
  constexpr int rounds = 6;
  for (int i = 0; i < rounds; ++i) {
    const Result<std::vector<Track>> tracks = planAll(kinds, job);
    if (!tracks) {
      return tracks.failure();
    }
    const double fastest = fastestOf(*tracks);
    const double factor = fastest > 0.0 ? most / fastest : 1.0;
    job.speedTimesWidth *= factor;
    if (std::abs(factor - 1.0) < tolerance::fastestJob) {
      break;
    }
  }
  constexpr double spare = 0.999;
  return spare * job.speedTimesWidth;
}
}  // namespace

double Painted::meanFilm() const {
  const FanGun& gun = statement.job.gun;
  return gun.flow > 0.0 ? gun.flow * gun.efficiency / statement.job.speedTimesWidth : 0.0;
}

Result<Painted> paint(const Statement& s,
                      const files::Files& files,
                      const Limits& limits,
                      const Vec2& start) {
  Result<std::string> text = files::read(files, s.alphabet);
  if (!text) {
    return text.takeFailure();
  }
  Result<Alphabet> alphabet = readAlphabet(*text, s.alphabet);
  if (!alphabet) {
    return alphabet.takeFailure();
  }
  return paint(s, *alphabet, limits, start);
}

Result<Painted> paint(const Statement& s,
                      const Alphabet& alphabet,
                      const Limits& limits,
                      const Vec2& start) {
  Writing writing;
  writing.division = s.job.asSource ? Division::asSource : Division::equal;
  writing.cells = s.cells;
  writing.leaning = s.job.tilt == TiltRule::best && !s.job.asSource;
  Result<std::vector<Run>> runs = runsOf(s.text, alphabet, s.placement, writing, limits);
  if (!runs) {
    return runs.takeFailure();
  }
  Painted painted;
  painted.given = travelOf(*runs, start);
  if (!s.job.asSource) {
    shorten(*runs, start);
  }
  painted.traveled = travelOf(*runs, start);
  const double unit = s.placement.height / alphabet.height;
  painted.statement = s;
  Job& job = painted.statement.job;
  Result<double> constant = s.speed > 0.0 ? Result<double>(s.speed * unit)
                            : s.film > 0.0
                                ? Result<double>(job.gun.flow * job.gun.efficiency / s.film)
                                : fastestJob(*runs, job);
  if (!constant) {
    return constant.takeFailure();
  }
  job.speedTimesWidth = *constant;
  painted.statement.speed = job.speedTimesWidth / unit;
  Result<std::vector<Track>> tracks = planAll(*runs, job);
  if (!tracks) {
    return tracks.takeFailure();
  }
  const auto mostFactor = [&] {
    if (job.tilt == TiltRule::off) {
      return 1.0;
    }
    const Result<double> fastest = fastestJob(*runs, job);
    return fastest ? *fastest / job.speedTimesWidth : 1.0;
  };
  if (auto objection = objectionToSpeeds(*tracks, job, mostFactor)) {
    return *std::move(objection);
  }
  painted.tracks = *std::move(tracks);
  return painted;
}

}  // namespace arelem::stencil
