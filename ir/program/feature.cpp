#include "ir/program/feature.h"

#include <vector>

namespace arelem::ir {

namespace {
std::vector<FeatureRow> rows() {
  std::vector<FeatureRow> table;
  std::string_view group;
#define ARELEM_FEATURE_GROUP(heading) group = heading;
#define ARELEM_FEATURE(id, syntax, meaning) table.push_back({group, #id, syntax, meaning});
#include "ir/program/features.def"
#undef ARELEM_FEATURE_GROUP
#undef ARELEM_FEATURE
  return table;
}
}  // namespace

std::span<const FeatureRow> featureTable() {
  static const std::vector<FeatureRow> table = rows();
  return table;
}

}  // namespace arelem::ir
