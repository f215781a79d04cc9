#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/result.h"

namespace arelem::region {

/// One group of a DXF file: a code and its value, on two lines.
struct Group {
  int code = 0;
  std::string_view value;
  std::size_t line = 0;  ///< of the code, from 1
};

/// An entity or other object: its name and its groups up to the next group 0.
struct DrawingObject {
  std::string_view name;
  std::size_t line = 0;
  std::vector<Group> groups;

  [[nodiscard]] std::string_view text(int code, std::string_view otherwise = "") const;
};

/// Splits a text into groups. Errors: E0367 (a code that is no number, an odd number of lines, a
/// binary file).
[[nodiscard]] Result<std::vector<Group>> groupsOf(std::string_view text, std::string_view name);
/// The number of a group. Errors: E0367.
[[nodiscard]] Result<double> numberOf(const Group& group, std::string_view name);
/// A flag or a count without its fraction; where it has no room, the nearest that has.
[[nodiscard]] long wholeOf(double value);

}  // namespace arelem::region
