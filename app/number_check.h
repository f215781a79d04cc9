#pragma once
#include <cmath>
#include <limits>
#include <string>

#include <CLI/CLI.hpp>

namespace arelem::app {

/// A number of an option between two values, `low` itself allowed or not. No "nan" and no "inf":
/// every comparison with the one is false, and a tolerance of the other is none.
inline CLI::Validator numberCheck(
    double low, bool lowToo, double high, const char* what, const char* type) {
  return CLI::Validator(
      [=](const std::string& word) {
        double value = 0.0;
        const bool isNumber = CLI::detail::lexical_cast(word, value) && std::isfinite(value);
        return isNumber && (value > low || (lowToo && value == low)) && value <= high
                   ? std::string()
                   : "`" + word + "` is no " + what;
      },
      type);
}

inline CLI::Validator positiveNumber() {
  return numberCheck(0.0, false, std::numeric_limits<double>::max(), "positive number", "POSITIVE");
}
inline CLI::Validator numberFromZero() {
  return numberCheck(0.0, true, std::numeric_limits<double>::max(), "number of 0 or more",
                     "NONNEGATIVE");
}
inline CLI::Validator shareOfOne() {
  return numberCheck(0.0, true, 1.0, "share from 0 to 1", "FLOAT in [0 - 1]");
}

}  // namespace arelem::app
