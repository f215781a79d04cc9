#pragma once
#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "backend/robot/machine.h"

namespace arelem::robot {

constexpr double longestLength = 1e6;  // mm
constexpr double fullTurn = 360.0;     // degrees

/// One table of a machine file. Remembers the first thing that is wrong in the whole file, and
/// which keys were asked for. Keys that are absent leave their value as it is.
class Table {
 public:
  Table(const toml::table& table,
        std::string path,
        std::string_view file,
        std::optional<Failure>& failure)
      : table_(table), path_(std::move(path)), file_(file), failure_(failure) {}

  void number(std::string_view key, double& value, double low, double high);
  void whole(std::string_view key, int& value, int low, int high);
  void flag(std::string_view key, bool& value);
  void text(std::string_view key, std::string& value);
  /// One of the given words; its place in the list.
  void choice(std::string_view key,
              std::size_t& value,
              std::initializer_list<std::string_view> words);
  template <std::size_t count>
  void list(std::string_view key, std::array<double, count>& values, double low, double high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const toml::array* array = node->as_array();
    bool good = array != nullptr && array->size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
      const auto found = array->get(i)->value<double>();
      good = found && *found >= low && *found <= high;
      values[i] = good ? *found : values[i];
    }
    if (!good) {
      wrong(key, fmt::format("a list of {} numbers from {:g} to {:g}", count, low, high));
    }
  }
  void range(std::string_view key, Range& value, double low, double high);
  /// A list of any length; of `count` numbers where that is not 0.
  void wholes(
      std::string_view key, std::vector<int>& values, int low, int high, std::size_t count = 0);
  /// A list of texts, of any length.
  void texts(std::string_view key, std::vector<std::string>& values);
  /// A table of texts by names of any kind.
  void texts(std::string_view key, std::map<std::string, std::string>& values);

  /// Reads a table in this one by `function(Table&)`, if it is there; nothing else may stand in it.
  template <class Function>
  void with(std::string_view key, Function&& function) {
    if (const toml::table* found = table(key)) {
      Table inner(*found, path_ + std::string(key) + ".", file_, failure_);
      function(inner);
      inner.close();
    }
  }
  /// Nothing else may stand in it.
  void close();
  /// The value of a key that was asked for is not what it must be.
  void wrong(std::string_view key, const std::string& wanted);
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

 private:
  const toml::node* find(std::string_view key);
  const toml::table* table(std::string_view key);

  const toml::table& table_;
  std::string path_;
  std::string_view file_;
  std::optional<Failure>& failure_;
  std::set<std::string> asked_;
};

/// The parts of a machine file that describe a control and its turning axes, and the time law.
void readControl(Table& top, Machine& machine);

}  // namespace arelem::robot
