#pragma once
#include <memory>
#include <ostream>

#include "app/pipeline.h"

namespace arelem::app {

/// How often each word begins a statement of a program, and what became of it (`check --words`):
///   understood   its meaning is known to the computation of the path or to the outputs
///   passed on    it stands in the CL data as it was written
///   reported     a diagnostic tells of it (an error, or that it has no effect)
/// Comments are counted in a line of their own.
class WordCounts {
 public:
  WordCounts();
  ~WordCounts();
  /// Adds a program or a piece of one, with its text and the places of all diagnostics in it.
  void add(const ir::Program& program,
           const SourceMap& sources,
           std::string_view text,
           const std::vector<Span>& told);
  void print(std::ostream& out) const;

 private:
  struct Counts;
  std::unique_ptr<Counts> counts_;
};

}  // namespace arelem::app
