#pragma once
#include <sstream>
#include <string>
#include <vector>

#include "backend/backend.h"

namespace arelem::test {

/// What the target makes of the records.
inline std::string written(std::string_view target,
                           const std::vector<cl::Record>& records,
                           const backend::Context& context,
                           DiagnosticSink& sink) {
  std::ostringstream out;
  const auto writer = backend::findTarget(target)->make(out, context, sink);
  for (const cl::Record& record : records) {
    writer->accept(record);
  }
  writer->finish();
  return out.str();
}

inline std::string written(std::string_view target, const std::vector<cl::Record>& records) {
  CollectingSink sink;
  return written(target, records, backend::Context{}, sink);
}

inline cl::Record record(int isn, cl::Body body) {
  return {isn, "", Span{}, std::move(body)};
}

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    result.push_back(line);
  }
  return result;
}

}  // namespace arelem::test
