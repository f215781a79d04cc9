#include "backend/html/deflate.h"

#include <random>

#include <gtest/gtest.h>
#include <zlib.h>

namespace arelem::backend {
namespace {

std::vector<unsigned char> inflated(const std::vector<unsigned char>& packed, std::size_t room) {
  std::vector<unsigned char> bytes(room + 1);
  uLongf length = bytes.size();
  EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), packed.size()), Z_OK);
  bytes.resize(length);
  return bytes;
}

TEST(Deflate, WhatZlibUnpacksIsWhatWentIn) {
  std::mt19937 random(1);
  for (const std::size_t size : {0U, 1U, 65'536U, 300'000U}) {  // the last does not fit its buffer
    std::vector<unsigned char> bytes(size);
    for (unsigned char& byte : bytes) {
      byte = static_cast<unsigned char>(random());
    }
    EXPECT_EQ(inflated(deflated(bytes), size), bytes) << size;
  }
}

TEST(Deflate, WhatRepeatsGetsSmall) {
  EXPECT_LT(deflated(std::vector<unsigned char>(100'000, 7)).size(), 500U);
}

}  // namespace
}  // namespace arelem::backend
