#pragma once
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "runtime/stencil/alphabet.h"

namespace arelem::stencil {

inline Alphabet alphabetOf(const std::string& text) {
  auto read = readAlphabet(text, "test.alphabet");
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.failure().message);
  return *std::move(read);
}
/// The alphabet that arelem brings.
inline std::string roadwayText() {
  std::ifstream in(ARELEM_SOURCE_DIR "/stdlib/roadway.alphabet");
  std::stringstream text;
  text << in.rdbuf();
  return text.str();
}
inline Alphabet roadway() {
  return alphabetOf(roadwayText());
}

}  // namespace arelem::stencil
