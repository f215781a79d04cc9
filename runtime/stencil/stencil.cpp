#include "runtime/stencil/stencil.h"

namespace arelem::stencil {

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
  Writing writing;
  writing.division = s.job.asSource ? Division::asSource : Division::equal;
  writing.cells = s.cells;
  if (s.job.tilt == TiltRule::best) {
    writing.best = {s.job.gun.fan, s.job.limits.most};
  }
  Result<std::vector<Run>> runs = runsOf(s.text, *alphabet, s.placement, writing, limits);
  if (!runs) {
    return runs.takeFailure();
  }
  Painted painted;
  painted.given = travelOf(*runs, start);
  if (!s.job.asSource) {
    shorten(*runs, start);
  }
  painted.traveled = travelOf(*runs, start);
  Job job = s.job;
  job.speedTimesWidth = s.speed * s.placement.height / alphabet->height;
  for (const Run& run : *runs) {
    Result<Track> track = planRun(run, job);
    if (!track) {
      return track.takeFailure();
    }
    painted.tracks.push_back(*std::move(track));
  }
  return painted;
}

}  // namespace arelem::stencil
