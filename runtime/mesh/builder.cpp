#include "runtime/mesh/builder.h"

#include <cmath>

namespace arelem::mesh {

void Builder::corner(double x, double y, double z, std::size_t line) {
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
    wrong(line, "a coordinate is no finite number");
    return;
  }
  mesh_.corners.emplace_back(x + 0.0, y + 0.0, z + 0.0);
}

std::size_t Builder::sharedCorner(double x, double y, double z, std::size_t line) {
  const auto [place, isNew] = places_.emplace(std::tuple(x, y, z), mesh_.corners.size());
  if (isNew) {
    corner(x, y, z, line);
  }
  return place->second;
}

void Builder::polygon(std::span<const long long> corners, std::size_t line) {
  if (corners.size() < 3) {
    wrong(line, fmt::format("a face has {} corners", corners.size()));
    return;
  }
  for (const long long index : corners) {
    if (index < 0 || index >= static_cast<long long>(mesh_.corners.size())) {
      wrong(line, fmt::format("a face names corner {}, there are {}", index, mesh_.corners.size()));
      return;
    }
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh_.triangles.push_back({static_cast<std::size_t>(corners[0]),
                               static_cast<std::size_t>(corners[i - 1]),
                               static_cast<std::size_t>(corners[i])});
    if (mesh_.spanned(mesh_.triangles.size() - 1).isZero(0.0)) {
      mesh_.triangles.pop_back();
    }
  }
}

void Builder::wrong(std::size_t line, std::string what) {
  if (!failure_) {
    failure_ = fail(diag::MeshSyntax, name_, line, std::move(what));
  }
}

Result<Mesh> Builder::finish() {
  if (failure_) {
    return *std::move(failure_);
  }
  if (mesh_.triangles.empty()) {
    return fail(diag::MeshEmpty, name_);
  }
  return std::move(mesh_);
}

bool Lines::next() {
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    rest_ = text_.substr(at_, end - at_);
    rest_ = rest_.substr(0, rest_.find('#'));
    at_ = std::min(end + 1, text_.size());
    ++number_;
    if (rest_.find_first_not_of(" \t\r") != std::string_view::npos) {
      return true;
    }
  }
  rest_ = {};
  return false;
}

std::optional<std::string_view> Lines::word() {
  const std::size_t from = rest_.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t to = std::min(rest_.find_first_of(" \t\r", from), rest_.size());
  const std::string_view found = rest_.substr(from, to - from);
  rest_.remove_prefix(to);
  return found;
}

std::optional<double> Lines::real() {
  const auto found = word();
  return found ? parsed<double>(*found) : std::nullopt;
}

std::optional<long long> Lines::whole() {
  const auto found = word();
  return found ? parsed<long long>(*found) : std::nullopt;
}

}  // namespace arelem::mesh
