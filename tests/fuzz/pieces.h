#pragma once
#include <string>

namespace arelem::fuzz {

/// CL text that is read in pieces of some lines gives the records and messages that it gives when
/// it is read at once. Ends the process where it does not.
void inPieces(const std::string& text);

}  // namespace arelem::fuzz
