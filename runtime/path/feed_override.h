#pragma once
#include <memory>

#include "ir/cl/record.h"
#include "runtime/interpret/action.h"

namespace arelem::path {

/// Section 2: feeds near check surfaces (manual of APT360, FEDRAT). FEDRAT/fb,dm,fm: a sequence of
/// GOLFT to GODOWN goes with fm over the last dm of its path, and with fb again behind it;
/// FEDRAT/d1,f1: so does the next sequence only; FEDRAT/fb ends both. The last cut vectors are
/// split where the feed changes; a sequence that is shorter changes at its start. Distances and
/// feeds that are not positive, and those with words, stay as they are written.
class FeedOverride : public cl::RecordSink {
 public:
  /// After the last record.
  virtual void finish() = 0;
};
/// `actions` tell which records belong to sequences; they must outlive the stage.
[[nodiscard]] std::unique_ptr<FeedOverride> makeFeedOverride(
    cl::RecordSink& next, const std::vector<runtime::Action>& actions);

/// Whether any FEDRAT needs the stage.
[[nodiscard]] bool overridesFeeds(const std::vector<runtime::Action>& actions);

}  // namespace arelem::path
