#pragma once

namespace arelem::certify {

/// A probe that looks for bounds by searches, and so long only as that leads somewhere.
class Patient {
 public:
  virtual ~Patient() = default;
  /// True where so much was looked for in vain that nothing will be proven any more.
  [[nodiscard]] virtual bool givesUp() const = 0;
};

}  // namespace arelem::certify
