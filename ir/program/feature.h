#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

/// What a program uses of the language, beside definition forms and motion.
namespace arelem::ir {

/// One row of features.def; enumerators are the ids of the language reference ("LX_02" for LX-02).
enum class Feature : std::uint8_t {
#define ARELEM_FEATURE_GROUP(heading)
#define ARELEM_FEATURE(id, syntax, meaning) id,
#include "ir/program/features.def"
#undef ARELEM_FEATURE_GROUP
#undef ARELEM_FEATURE
  count
};

struct FeatureRow {
  std::string_view group;   ///< heading of the manual
  std::string_view idText;  ///< "LX_02"
  std::string_view syntax;
  std::string_view meaning;
};
[[nodiscard]] std::span<const FeatureRow> featureTable();

/// How often a program uses each feature.
class FeatureCounts {
 public:
  void add(Feature feature) { ++counts_[static_cast<std::size_t>(feature)]; }
  [[nodiscard]] std::uint64_t operator[](Feature feature) const {
    return counts_[static_cast<std::size_t>(feature)];
  }

 private:
  std::array<std::uint64_t, static_cast<std::size_t>(Feature::count)> counts_{};
};

struct Program;
/// Adds to `counts` what the statements, definitions and expressions of a program show. What leaves
/// no trace in them (comments, SYN, LIBRY, ...) the frontend has counted in Program::features.
void survey(const Program& program, FeatureCounts& counts);

}  // namespace arelem::ir
