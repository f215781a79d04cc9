#pragma once
#include <random>
#include <vector>

#include "ir/cl/record.h"

namespace arelem::test {

/// A stream of records of every kind, as a program could produce it, that ends with FINI.
[[nodiscard]] std::vector<cl::Record> randomRecords(std::mt19937_64& random, int count);

}  // namespace arelem::test
