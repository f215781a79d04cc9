#pragma once
#include <nlohmann/json.hpp>

#include "backend/report/spray.h"

namespace arelem::backend {

[[nodiscard]] nlohmann::ordered_json sprayJson(const ReportedSpray& spray);

}  // namespace arelem::backend
