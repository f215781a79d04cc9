#pragma once
#include <array>
#include <cstring>
#include <string_view>

#include "backend/text/number.h"
#include "backend/text/out_buffer.h"

namespace arelem::backend {

/// Writes one statement of CL text, `WORD / a, b, c`, in lines of at most 72 columns that continue
/// with `$`. A comment statement starts each of its lines with `$$->`, so that no reader mistakes a
/// later line for code.
class StatementWriter {
 public:
  StatementWriter(OutBuffer& out, int decimals) : out_(out), decimals_(decimals) {}

  void begin(std::string_view word, bool comment = false);
  void length(double value) {
    std::array<char, numberRoom> text{};
    item(text.data(), writeFixed(text.data(), value, decimals_));
  }
  void parameter(double value) {
    std::array<char, numberRoom> text{};
    item(text.data(), writeParameter(text.data(), value, decimals_));
  }
  void text(std::string_view item) { this->item(item.data(), item.data() + item.size()); }
  void end() { out_.append('\n'); }

  static constexpr std::size_t columns = 72;

 private:
  void item(const char* first, const char* last);
  OutBuffer& out_;
  int decimals_;
  bool comment_ = false;
  bool first_ = true;
  std::size_t column_ = 0;
};

}  // namespace arelem::backend
