#include "app/verify_g97_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ir/diag/render_text.h"
#include "ir/diag/verify.h"

namespace arelem::app {

namespace {
/// A word of a block that is not what compile writes.
struct Difference {
  std::string found, wanted;
};

std::array<double, 6> numbersOf(const g97::BlockPose& pose) {
  const g97::Angles& angles = pose.angles;
  return {pose.point.x(), pose.point.y(), pose.point.z(), angles.p, angles.q, angles.r};
}

std::string codeShown(const std::string& code) {
  return code.empty() ? "no code" : fmt::format("`{}`", code);
}

std::optional<Difference> difference(const g97::Block& found,
                                     const g97::Block& wanted,
                                     double millimeters) {
  const std::array<double, 6> a = numbersOf(found.pose);
  const std::array<double, 6> b = numbersOf(wanted.pose);
  for (std::size_t i = 0; i < a.size(); ++i) {
    constexpr double sameDigits = 1e-3;
    if (std::abs(a[i] - b[i]) > std::max(i < 3 ? millimeters : 0.0, sameDigits)) {
      const char name = "XYZPQR"[i];
      return Difference{fmt::format("{} {:.2f}", name, a[i]), fmt::format("{} {:.2f}", name, b[i])};
    }
  }
  if (found.straight != wanted.straight) {
    return Difference{found.straight ? "L" : "P", wanted.straight ? "L" : "P"};
  }
  if (found.speed != wanted.speed) {
    return Difference{fmt::format("F{:04}M", found.speed), fmt::format("F{:04}M", wanted.speed)};
  }
  if (found.code != wanted.code) {
    return Difference{codeShown(found.code), codeShown(wanted.code)};
  }
  return std::nullopt;
}

std::string numberShown(int number) {
  return number == 0 ? "no O line" : fmt::format("O{:04}", number);
}

/// A program against the one that compile writes; the blocks that both have, then how many.
std::optional<Diagnostic> difference(const g97::Program& found,
                                     const g97::Program& wanted,
                                     const std::string& name,
                                     double millimeters) {
  const auto differs = [&](std::size_t line, std::string a, std::string b) {
    return diagnose(nowhere, diag::EventDiffers, name, line, std::move(a), std::move(b));
  };
  if (found.number != wanted.number) {
    const std::size_t first = found.blocks.front().line;
    return differs(found.number == 0 ? first : first - 1, numberShown(found.number),
                   numberShown(wanted.number));
  }
  const std::size_t count = std::min(found.blocks.size(), wanted.blocks.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (auto other = difference(found.blocks[i], wanted.blocks[i], millimeters)) {
      return differs(found.blocks[i].line, std::move(other->found), std::move(other->wanted));
    }
  }
  if (found.blocks.size() != wanted.blocks.size()) {
    return differs(found.blocks[count - 1].line, fmt::format("{} blocks", found.blocks.size()),
                   fmt::format("{} blocks", wanted.blocks.size()));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> firstDifference(const std::vector<g97::Program>& found,
                                          const std::vector<g97::Program>& wanted,
                                          const std::string& name,
                                          double millimeters) {
  for (std::size_t i = 0; i < std::min(found.size(), wanted.size()); ++i) {
    if (auto differs = difference(found[i], wanted[i], name, millimeters)) {
      return differs;
    }
  }
  if (found.size() != wanted.size()) {
    return diagnose(nowhere, diag::EventDiffers, name, found.back().blocks.back().line,
                    fmt::format("{} programs", found.size()),
                    fmt::format("{} programs", wanted.size()));
  }
  return std::nullopt;
}

}  // namespace arelem::app
