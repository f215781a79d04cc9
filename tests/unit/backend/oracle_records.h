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

/// All cases that have records, of tests/data/oracle/{cases,bad}.
[[nodiscard]] std::vector<OracleCase> readOracleCases();

/// The old system's own examples, which are not part of the project: of oracle/examples in the
/// folder that the environment variable ARELEM_SHARED names, or in `../shared`. Empty where they
/// are absent.
[[nodiscard]] std::vector<OracleCase> readOracleExamples();

}  // namespace arelem::test
