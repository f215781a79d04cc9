#pragma once
#include <iosfwd>

#include "ir/text/source_map.h"
#include "runtime/certify/certificate.h"

namespace arelem::app {

/// A line for each execution of a motion statement: worst inner and outer deviation that is proven
/// for its drive and part surface, what is allowed, and the stop.
void printCertificate(std::ostream& out, const certify::Certificate& c, const SourceMap& sources);
/// The same as one JSON object a line.
void printCertificateJson(std::ostream& out,
                          const certify::Certificate& c,
                          const SourceMap& sources);

}  // namespace arelem::app
