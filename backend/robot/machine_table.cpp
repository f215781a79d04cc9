#include "backend/robot/machine_table.h"

#include "ir/diag/robot.h"

namespace arelem::robot {

const toml::node* Table::find(std::string_view key) {
  asked_.insert(std::string(key));
  return table_.get(key);
}

void Table::wrong(std::string_view key, const std::string& wanted) {
  const toml::node* node = table_.get(key);
  const toml::source_region& source = node != nullptr ? node->source() : table_.source();
  if (!failure_) {
    failure_ = fail(diag::MachineValue, file_, source.begin.line, path_ + std::string(key), wanted);
  }
}

void Table::number(std::string_view key, double& value, double low, double high) {
  const toml::node* node = find(key);
  if (node == nullptr) {
    return;
  }
  const auto found = node->value<double>();
  if (!found || !(*found >= low && *found <= high)) {
    wrong(key, fmt::format("a number from {:g} to {:g}", low, high));
    return;
  }
  value = *found;
}

void Table::whole(std::string_view key, int& value, int low, int high) {
  const toml::node* node = find(key);
  if (node == nullptr) {
    return;
  }
  const auto found = node->value_exact<std::int64_t>();
  if (!found || *found < low || *found > high) {
    wrong(key, fmt::format("a whole number from {} to {}", low, high));
    return;
  }
  value = static_cast<int>(*found);
}

void Table::flag(std::string_view key, bool& value) {
  if (const toml::node* node = find(key)) {
    const auto found = node->value_exact<bool>();
    found ? void(value = *found) : wrong(key, "true or false");
  }
}

void Table::text(std::string_view key, std::string& value) {
  if (const toml::node* node = find(key)) {
    const auto found = node->value_exact<std::string>();
    found ? void(value = *found) : wrong(key, "a text in quotes");
  }
}

void Table::choice(std::string_view key,
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
  wrong(key, "one of " + known);
}

void Table::range(std::string_view key, Range& value, double low, double high) {
  std::array<double, 2> both{value.low, value.high};
  list(key, both, low, high);
  if (both[0] > both[1]) {
    wrong(key, "two numbers, the smaller first");
  }
  value = {both[0], both[1]};
}

void Table::texts(std::string_view key, std::vector<std::string>& values) {
  const toml::node* node = find(key);
  if (node == nullptr) {
    return;
  }
  values.clear();
  const toml::array* array = node->as_array();
  bool good = array != nullptr;
  for (std::size_t i = 0; good && i < array->size(); ++i) {
    const auto found = array->get(i)->value_exact<std::string>();
    good = found.has_value();
    values.push_back(found.value_or(""));
  }
  if (!good) {
    wrong(key, "a list of texts in quotes");
  }
}

void Table::wholes(
    std::string_view key, std::vector<int>& values, int low, int high, std::size_t count) {
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
    wrong(key, fmt::format("a list of {}whole numbers from {} to {}",
                           count == 0 ? "" : fmt::format("{} ", count), low, high));
  }
}

void Table::texts(std::string_view key, std::map<std::string, std::string>& values) {
  const toml::table* inner = table(key);
  if (inner == nullptr) {
    return;
  }
  for (const auto& [name, node] : *inner) {
    const auto found = node.value_exact<std::string>();
    if (!found) {
      wrong(key, "a table of texts in quotes");
      return;
    }
    values[std::string(name.str())] = *found;
  }
}

const toml::table* Table::table(std::string_view key) {
  const toml::node* node = find(key);
  if (node != nullptr && node->as_table() == nullptr) {
    wrong(key, "a table [" + std::string(key) + "]");
  }
  return node == nullptr ? nullptr : node->as_table();
}

void Table::close() {
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

}  // namespace arelem::robot
