#include "app/limit_options.h"

#include <array>
#include <charconv>
#include <string>

namespace arelem::app {

namespace {
struct LimitOption {
  const char* flag;
  std::uint64_t Limits::*member;
  const char* bounds;
};

constexpr std::array limitOptions = {
    LimitOption{"--max-steps", &Limits::steps, "statements executed"},
    LimitOption{"--max-depth", &Limits::depth, "active macro calls"},
    LimitOption{"--max-records", &Limits::records, "CL records"},
    LimitOption{"--max-phase-errors", &Limits::errors, "errors that a phase keeps"},
    LimitOption{"--max-nesting", &Limits::nesting, "nested parentheses"},
    LimitOption{"--max-elements", &Limits::elements, "tokens of one statement"},
    LimitOption{"--max-line", &Limits::line, "bytes of one line"},
    LimitOption{"--max-bytes", &Limits::bytes, "bytes of one source file"},
    LimitOption{"--max-points", &Limits::points, "cut vectors of one motion"},
    LimitOption{"--max-array", &Limits::array, "elements of one RESERV array"},
    LimitOption{"--max-definitions", &Limits::definitions, "rows of arelem geometry"}};

// A bound left out would have no flag: each member is a 64-bit number.
static_assert(limitOptions.size() * sizeof(std::uint64_t) == sizeof(Limits));

std::uint64_t wholeNumber(const std::string& flag, const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw CLI::ValidationError(flag, "`" + text + "` is not a whole number");
  }
  return value;
}
}  // namespace

void addLimitOptions(CLI::App& app, Limits& limits) {
  for (const LimitOption& option : limitOptions) {
    const std::string flag = option.flag;
    std::uint64_t& limit = limits.*option.member;
    app.add_option_function<std::string>(
           flag, [flag, &limit](const std::string& text) { limit = wholeNumber(flag, text); },
           std::string(option.bounds) + " (" + std::to_string(limit) + ")")
        ->type_name("N")
        ->group("Limits on work and size");
  }
}

}  // namespace arelem::app
