#pragma once
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "backend/robot/machine.h"
#include "tests/unit/backend/writing.h"

/// V+ programs of a few records.
namespace arelem::test {

inline cl::Motion pose(std::vector<double> numbers) {
  cl::Motion m;
  m.withAxis = numbers.size() >= 6;
  m.withSide = numbers.size() == 9;
  m.coordinates = std::move(numbers);
  return m;
}
inline cl::Post post(Word word, std::vector<cl::Value> values = {}) {
  return {word, "", std::move(values)};
}

inline std::string program(const std::vector<cl::Record>& records,
                           const robot::Machine* machine = nullptr,
                           std::vector<std::string>* codes = nullptr) {
  backend::Context context;
  context.machine = machine;
  CollectingSink sink;
  std::string text = written("vplus", records, context, sink);
  for (const Diagnostic& d : sink.all()) {
    if (codes != nullptr) {
      codes->emplace_back(d.kind().code);
    } else {
      ADD_FAILURE() << d.message;
    }
  }
  return text;
}

}  // namespace arelem::test
