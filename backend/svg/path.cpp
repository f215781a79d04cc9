#include "backend/svg/path.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "backend/text/clean.h"
#include "ir/cl/vendor.h"

namespace arelem::backend::svg {

namespace {
/// Runs are thinned in blocks of this many vertices: bounds the work where nothing can be left out.
constexpr std::size_t block = 512;
/// First tolerance when the collector is full, relative to the size of the path.
constexpr double firstTolerance = 1e-5;
/// A tool axis this near to z is drawn as a circle in the plan.
constexpr double uprightCosine = 0.9999;

double distanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0.0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

/// Marks what must stay between two kept vertices (Douglas and Peucker 1973), without recursion.
void markKept(const std::vector<Vertex>& path,
              std::size_t first,
              std::size_t last,
              double deviation,
              std::vector<bool>& keep) {
  std::vector<std::pair<std::size_t, std::size_t>> spans = {{first, last}};
  while (!spans.empty()) {
    const auto [from, to] = spans.back();
    spans.pop_back();
    double worst = deviation;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double distance = distanceToSegment(path[i].place, path[from].place, path[to].place);
      if (distance > worst) {
        worst = distance;
        at = i;
      }
    }
    if (at != from) {
      keep[at] = true;
      spans.emplace_back(from, at);
      spans.emplace_back(at, to);
    }
  }
}
}  // namespace

void Bounds::add(const Vec3& place) {
  low = empty ? place : Vec3(low.cwiseMin(place));
  high = empty ? place : Vec3(high.cwiseMax(place));
  empty = false;
}

void PathCollector::accept(const cl::Record& record) {
  if (const auto* motion = std::get_if<cl::Motion>(&record.body)) {
    move(*motion, record.isn);
  } else if (const auto* post = std::get_if<cl::Post>(&record.body)) {
    command(*post);
  } else if (const auto* along = std::get_if<cl::Surface>(&record.body)) {
    surface(along->surface);
  } else if (const auto* values = std::get_if<cl::Values>(&record.body)) {
    constexpr std::size_t ringValues = 3;  // CUTTER / OPTION: no diameter
    if (values->word == Word::CUTTER && !values->values.empty() &&
        values->values.size() != ringValues && std::isfinite(values->values[0])) {
      diameter_ = std::abs(values->values[0]);
    }
  } else if (const auto* units = std::get_if<cl::Units>(&record.body)) {
    unit_ = spell(units->unit);
    std::transform(unit_.begin(), unit_.end(), unit_.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  } else if (const auto* text = std::get_if<cl::Text>(&record.body)) {
    if (text->word == Word::PARTNO && partName_.empty()) {
      partName_ = std::string(trimmed(text->text));
    }
  }
}

void PathCollector::surface(const cl::SurfaceValue& along) {
  constexpr double straight = 1.0 - 1e-12;  // cosine: along a coordinate axis
  arc_ = true;
  about_ = -1;
  if (along.canon.size() != 7) {
    splines_ = true;
    return;
  }
  circles_ = true;
  const Vec3 axis(&along.canon[3]);
  center_ = Vec3(along.canon.data());
  for (int k = 0; k < 3; ++k) {
    about_ = std::abs(axis[k]) >= straight * axis.norm() ? k : about_;
  }
}

void PathCollector::command(const cl::Post& post) {
  if (!post.foreign.empty()) {
    if (const auto cutter = cl::cutterOf(post)) {
      diameter_ = std::abs(cutter->front());
    }
    return;
  }
  rapid_ = rapid_ || post.word == Word::RAPID;
  changed_ = changed_ || post.word == Word::RAPID || post.word == Word::FEDRAT;
  const auto* word = post.arguments.empty() ? nullptr : std::get_if<Word>(&post.arguments[0]);
  if (post.word == Word::SPRAY) {
    gun_ = word != nullptr && *word == Word::ON;
  }
  if (post.word == Word::CYCLE) {
    cycle_ = word == nullptr || (*word != Word::OFF && *word != Word::NOMORE);
  }
}

void PathCollector::move(const cl::Motion& motion, int isn) {
  const bool continues = motion.kind == cl::Motion::Kind::continuation && isn == isn_;
  isn_ = isn;
  if (!continues) {
    addStop();
  }
  if (!continues || changed_) {  // in a hole a statement has several kinds
    changed_ = false;
    kind_ = rapid_ || cycle_ ? MoveKind::rapid
            : gun_           ? MoveKind::gun
            : arc_           ? MoveKind::arc
                             : MoveKind::feed;
    along_ = arc_ ? about_ : -1;
    rapid_ = false;
    arc_ = false;
  }
  const bool from = motion.kind == cl::Motion::Kind::from;
  const std::size_t stride = motion.stride();
  for (std::size_t i = 0; i + stride <= motion.coordinates.size(); i += stride) {
    const Vec3 place(motion.coordinates[i], motion.coordinates[i + 1], motion.coordinates[i + 2]);
    if (place.allFinite()) {
      add(place, from || vertices_.empty() ? MoveKind::start : kind_);
      pending_ = true;
      upright_ = !motion.withAxis || motion.coordinates[i + 5] > uprightCosine;
    }
  }
}

void PathCollector::add(const Vec3& place, MoveKind kind) {
  ++locations_;
  bounds_.add(place);
  if (kind != MoveKind::start) {
    lengths_[static_cast<std::size_t>(kind)] += (place - vertices_.back().place).norm();
  }
  vertices_.push_back({place, kind, kind == MoveKind::start ? -1 : along_, center_});
  if (vertices_.size() >= 2 * most_) {
    compress();
  }
}

void PathCollector::addStop() {
  if (!pending_) {
    return;
  }
  pending_ = false;
  if (!upright_ || stopCount_++ % stopStride_ != 0) {
    return;
  }
  stops_.push_back(vertices_.back().place);
  if (stops_.size() >= mostStops) {
    for (std::size_t i = 0; 2 * i < stops_.size(); ++i) {
      stops_[i] = stops_[2 * i];
    }
    stops_.resize((stops_.size() + 1) / 2);
    stopStride_ *= 2;
  }
}

/// Makes room: thins what came since the last time, and all of it more coarsely where that is not
/// enough.
void PathCollector::compress() {
  if (tolerance_ == 0.0) {
    raise(firstTolerance * bounds_.size().norm());
  }
  simplify(thinned_ > 0 ? thinned_ - 1 : 0);
  shrinkTo(most_ + most_ / 2);
  thinned_ = vertices_.size();
}

void PathCollector::thin(double tolerance) {
  if (tolerance > tolerance_) {
    raise(tolerance);
    simplify(0);
  }
  shrinkTo(most_);
}

void PathCollector::raise(double tolerance) {
  tolerance_ = tolerance;
  deviation_ += tolerance;
}

void PathCollector::shrinkTo(std::size_t most) {
  const double size = bounds_.size().norm();
  while (vertices_.size() > most && tolerance_ < size) {
    raise(std::max(2.0 * tolerance_, firstTolerance * size));
    simplify(0);
  }
  while (vertices_.size() > most) {
    halve();
    deviation_ = size;
  }
}

void PathCollector::simplify(std::size_t first) {
  const std::size_t count = vertices_.size();
  std::vector<bool> keep(count, false);
  std::fill_n(keep.begin(), std::min(first + 1, count), true);
  std::size_t from = first;
  for (std::size_t i = first + 1; i < count; ++i) {
    const bool runEnds = i + 1 == count || vertices_[i + 1].kind != vertices_[i].kind;
    if (runEnds || i - from == block) {
      keep[i] = true;
      markKept(vertices_, from, i, tolerance_, keep);
      from = i;
    }
  }
  keepOnly(keep);
}

/// Where moves of different kinds take turns no distance helps: every second pair goes.
void PathCollector::halve() {
  std::vector<bool> keep(vertices_.size(), false);
  for (std::size_t i = 0; i < keep.size(); ++i) {
    keep[i] = i % 4 < 2 || i + 1 == keep.size();
  }
  keepOnly(keep);
}

void PathCollector::keepOnly(const std::vector<bool>& keep) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (keep[i]) {
      vertices_[kept++] = vertices_[i];
    }
  }
  vertices_.resize(kept);
}

}  // namespace arelem::backend::svg
