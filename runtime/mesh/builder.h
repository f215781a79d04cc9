#pragma once
#include <charconv>
#include <map>
#include <optional>
#include <tuple>

#include "ir/diag/spray.h"
#include "runtime/mesh/mesh.h"

namespace arelem::mesh {

/// Gathers what a file says. Remembers the first thing that is wrong with it.
class Builder {
 public:
  explicit Builder(std::string_view name) : name_(name) {}

  void corner(double x, double y, double z, std::size_t line);
  /// A corner that a triangle soup repeats.
  std::size_t sharedCorner(double x, double y, double z, std::size_t line);
  /// A polygon by its corners, counted from 0.
  void polygon(std::span<const long long> corners, std::size_t line);
  void wrong(std::size_t line, std::string what);

  [[nodiscard]] bool good() const { return !failure_; }
  [[nodiscard]] std::size_t corners() const { return mesh_.corners.size(); }
  [[nodiscard]] Result<Mesh> finish();

 private:
  std::string_view name_;
  Mesh mesh_;
  std::map<std::tuple<double, double, double>, std::size_t> places_;
  std::optional<Failure> failure_;
};

/// The lines of a text and the blank-separated words of a line.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}
  /// The next line with a word in it, without its comment; false at the end.
  bool next();
  [[nodiscard]] std::size_t number() const { return number_; }
  [[nodiscard]] std::optional<std::string_view> word();
  [[nodiscard]] std::optional<double> real();
  [[nodiscard]] std::optional<long long> whole();
  /// Bytes up to the end of the line read last.
  [[nodiscard]] std::size_t offset() const { return at_; }

 private:
  std::string_view text_;
  std::string_view rest_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

template <class Number>
std::optional<Number> parsed(std::string_view word) {
  if (!word.empty() && word.front() == '+') {
    word.remove_prefix(1);
  }
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(value)
                                                                  : std::nullopt;
}

void readPly(std::string_view bytes, Builder& builder);

}  // namespace arelem::mesh
