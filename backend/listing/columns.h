#pragma once
#include <string>

namespace arelem::backend {

/// Appends a number right-justified in `width` columns with fixed decimals, as FORTRAN's Fw.d, but
/// never stars: what does not fit takes more columns after a blank, and beyond 1e15 the exponential
/// form. No "-0".
void appendColumn(std::string& line, double value, int width, int decimals);

}  // namespace arelem::backend
