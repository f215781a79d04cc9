#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ir/cl/record.h"

/// Rebuilds CL records from the JSON results of the old system (tests/data/oracle), for tests only.
namespace arelem::test {

struct OracleCase {
  std::string name;
  nlohmann::json cl;  ///< the array of records
  std::vector<cl::Record>
      records;  ///< rebuilt, with a Card where the old tape has a 1000 record of its own
};

/// One file; the records are empty when it has none.
[[nodiscard]] OracleCase readOracleCase(const std::filesystem::path& file);

/// All cases that have records: tests/data/oracle/{cases,bad} and, where present, the examples of
/// the folder that ARELEM_SHARED names.
[[nodiscard]] std::vector<OracleCase> readOracleCases();

}  // namespace arelem::test
