#pragma once
#include <string>

#include "backend/backend.h"

namespace arelem::backend {

/// Appends what one PRINT item or title prints: PRINT/3 gives `name (sub) TYPE n values` with six
/// decimals, seven values a line; PRINT/2 the values alone; PRINT/1 the values as hexadecimal
/// words; PRINT/0 an empty line.
void appendPrinted(std::string& text, const ListingItem& item);

}  // namespace arelem::backend
