#pragma once
#include <map>
#include <set>
#include <string>

#include <toml++/toml.h>

#include "backend/robot/machine.h"
#include "ir/diag/robot.h"

namespace arelem::robot {

/// One table of the file. Remembers the first thing that is wrong, and which keys were asked for.
class Table {
 public:
  Table(const toml::table& table,
        std::string path,
        std::string_view file,
        std::optional<Failure>& failure)
      : table_(table), path_(std::move(path)), file_(file), failure_(failure) {}

  void number(std::string_view key, double& value, double low, double high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const auto found = node->value<double>();
    if (!found || !(*found >= low && *found <= high)) {
      wrong(*node, key, fmt::format("a number from {:g} to {:g}", low, high));
      return;
    }
    value = *found;
  }
  void whole(std::string_view key, int& value, int low, int high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const auto found = node->value_exact<std::int64_t>();
    if (!found || *found < low || *found > high) {
      wrong(*node, key, fmt::format("a whole number from {} to {}", low, high));
      return;
    }
    value = static_cast<int>(*found);
  }
  void flag(std::string_view key, bool& value) {
    if (const toml::node* node = find(key)) {
      const auto found = node->value_exact<bool>();
      found ? void(value = *found) : wrong(*node, key, "true or false");
    }
  }
  void text(std::string_view key, std::string& value) {
    if (const toml::node* node = find(key)) {
      const auto found = node->value_exact<std::string>();
      found ? void(value = *found) : wrong(*node, key, "a text in quotes");
    }
  }
  /// One of the given words; its place in the list.
  void choice(std::string_view key,
              std::size_t& value,
              std::initializer_list<std::string_view> words) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const auto found = node->value_exact<std::string>();
    std::size_t at = 0;
    std::string known;
    for (const std::string_view word : words) {
      if (found && *found == word) {
        value = at;
        return;
      }
      known += (known.empty() ? "\"" : ", \"") + std::string(word) + "\"";
      ++at;
    }
    wrong(*node, key, "one of " + known);
  }
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
      wrong(*node, key, fmt::format("a list of {} numbers from {:g} to {:g}", count, low, high));
    }
  }
  /// A list of any length; of `count` numbers where that is not 0.
  void wholes(
      std::string_view key, std::vector<int>& values, int low, int high, std::size_t count = 0) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const toml::array* array = node->as_array();
    bool good = array != nullptr && (count == 0 || array->size() == count);
    values.clear();
    for (std::size_t i = 0; good && i < array->size(); ++i) {
      const auto found = array->get(i)->value_exact<std::int64_t>();
      good = found && *found >= low && *found <= high;
      values.push_back(good ? static_cast<int>(*found) : 0);
    }
    if (!good) {
      wrong(*node, key,
            fmt::format("a list of {}whole numbers from {} to {}",
                        count == 0 ? "" : fmt::format("{} ", count), low, high));
    }
  }
  /// A table of texts by names of any kind.
  void texts(std::string_view key, std::map<std::string, std::string>& values) {
    const toml::table* inner = table(key);
    if (inner == nullptr) {
      return;
    }
    for (const auto& [name, node] : *inner) {
      const auto found = node.value_exact<std::string>();
      if (!found) {
        wrong(node, key, "a table of texts in quotes");
        return;
      }
      values[std::string(name.str())] = *found;
    }
  }
  void range(std::string_view key, Range& value, double low, double high) {
    std::array<double, 2> both{value.low, value.high};
    list(key, both, low, high);
    if (both[0] > both[1]) {
      wrong(*find(key), key, "two numbers, the smaller first");
    }
    value = {both[0], both[1]};
  }
  /// A table in this one; null when absent.
  const toml::table* table(std::string_view key) {
    const toml::node* node = find(key);
    if (node != nullptr && node->as_table() == nullptr) {
      wrong(*node, key, "a table [" + std::string(key) + "]");
    }
    return node == nullptr ? nullptr : node->as_table();
  }
  /// Nothing else may stand in it.
  void close() {
    for (const auto& [key, node] : table_) {
      if (asked_.count(std::string(key.str())) == 0 && !failure_) {
        std::string known;
        for (const std::string& one : asked_) {
          known += (known.empty() ? "" : ", ") + one;
        }
        failure_ = fail(diag::MachineKey, file_, key.source().begin.line,
                        path_ + std::string(key.str()), known);
      }
    }
  }

 private:
  const toml::node* find(std::string_view key) {
    asked_.insert(std::string(key));
    return table_.get(key);
  }
  void wrong(const toml::node& node, std::string_view key, const std::string& wanted) {
    if (!failure_) {
      failure_ = fail(diag::MachineValue, file_, node.source().begin.line, path_ + std::string(key),
                      wanted);
    }
  }

  const toml::table& table_;
  std::string path_;
  std::string_view file_;
  std::optional<Failure>& failure_;
  std::set<std::string> asked_;
};

}  // namespace arelem::robot
