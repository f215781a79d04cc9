#include "app/limit_options.h"

#include <charconv>
#include <string>

namespace arelem::app {

namespace {
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
  for (const LimitRow& row : limitTable) {
    const std::string flag(row.flag);
    std::uint64_t& limit = limits.*row.member;
    app.add_option_function<std::string>(
           flag, [flag, &limit](const std::string& text) { limit = wholeNumber(flag, text); },
           std::string(row.what) + " (" + std::to_string(limit) + ")")
        ->type_name("N")
        ->group("Limits on work and size");
  }
}

}  // namespace arelem::app
