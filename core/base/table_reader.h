// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/toml_text.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::base {

/// Returns the value of a TOML number, or nothing if the node is not a number. Integers are rounded
/// to the nearest double, whereas node::value<double>() returns nothing for integers above 2^53.
inline std::optional<double> tomlNumber(const toml::node& node) {
  if (const auto* whole = node.as_integer()) {
    return static_cast<double>(whole->get());
  }
  const auto* real = node.as_floating_point();
  return real != nullptr ? std::optional(real->get()) : std::nullopt;
}

/// Reads values from a TOML table and keeps the first error, with the line number. If a requested
/// key is absent, the value stays unchanged; use require() for mandatory keys. finish() reports
/// keys that are in the table but were never requested, because they are probably typing mistakes.
/// Errors name the file and, as the field, `prefix` followed by the key.
class TableReader {
public:
  TableReader(const toml::table& table, std::string file, std::string prefix)
      : table_(table), file_(std::move(file)), prefix_(std::move(prefix)) {}

  bool has(const char* key) const { return table_.contains(key); }

  /// Reads a finite number between `low` and `high`, inclusive, into `value`. Records an error if
  /// the key has any other value. Leaves `value` unchanged if the key is absent.
  void readNumber(const char* key, double& value, double low, double high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    const auto read = tomlNumber(*node);
    if (!read) {
      fail(ErrorCode::WrongType, key, "a number is expected");
    } else if (isWithin(key, *read, low, high)) {
      value = *read;
    }
  }

  /// Reads an integer between `low` and `high`, inclusive, into `value`. Records an error if the
  /// key has any other value. Leaves `value` unchanged if the key is absent.
  template <class Integer>
  void readInteger(const char* key, Integer& value, std::int64_t low, std::int64_t high) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return;
    }
    if (!node->is_integer()) {
      fail(ErrorCode::WrongType, key, "a whole number is expected");
      return;
    }
    const std::int64_t read = node->as_integer()->get();
    if (read < low || read > high) {
      fail(ErrorCode::BadValue, key, fmt::format("{} is not within {} to {}", read, low, high));
      return;
    }
    value = static_cast<Integer>(read);
  }

  void readBoolean(const char* key, bool& value) {
    if (const toml::node* node = find(key)) {
      if (node->is_boolean()) {
        value = node->as_boolean()->get();
      } else {
        fail(ErrorCode::WrongType, key, "true or false is expected");
      }
    }
  }

  void readText(const char* key, std::string& value) {
    if (const toml::node* node = find(key)) {
      if (node->is_string()) {
        value = node->as_string()->get();
      } else {
        fail(ErrorCode::WrongType, key, "a text is expected");
      }
    }
  }

  /// Returns the table under a key, or null if the key is absent. If the value is not a table,
  /// records an error and returns null.
  const toml::table* findTable(const char* key) {
    const toml::node* node = find(key);
    if (node != nullptr && !node->is_table()) {
      fail(ErrorCode::WrongType, key, "a table is expected");
    }
    return node != nullptr ? node->as_table() : nullptr;
  }

  /// Returns the node under a key, or null if the key is absent, and counts the key as requested.
  /// Use this function for values that no other function can read.
  const toml::node* findNode(const char* key) { return find(key); }

  bool failed() const { return error_.has_value(); }

  /// Records an error that the caller found in a part of the table. Does nothing if an error is
  /// already recorded.
  void recordError(std::optional<Error> error) {
    if (!error_) {
      error_ = std::move(error);
    }
  }

  /// Reads an array of exactly `count` finite numbers between `low` and `high`, inclusive, into
  /// `values`. Returns true on success. Returns false, without an error, if the key is absent. If
  /// the key has any other value, records an error and returns false.
  bool readNumbers(const char* key, double* values, std::size_t count, double low = -1e6,
                   double high = 1e6) {
    const toml::node* node = find(key);
    if (node == nullptr) {
      return false;
    }
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() != count ||
        !std::ranges::all_of(*array, [](const toml::node& item) { return item.is_number(); })) {
      fail(ErrorCode::WrongType, key, fmt::format("an array of {} numbers is expected", count));
      return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
      values[i] = tomlNumber((*array)[i]).value_or(0.0);
      if (!isWithin(key, values[i], low, high)) {
        return false;
      }
    }
    return true;
  }

  /// Returns the tables in an array of tables, or an empty list if the key is absent. If the value
  /// is not such an array, or has more than `most` tables, records an error and returns an empty
  /// list.
  std::vector<const toml::table*> findTables(const char* key,
                                             std::size_t most = std::size_t{1} << 20U) {
    std::vector<const toml::table*> result;
    const toml::node* node = find(key);
    if (node == nullptr) {
      return result;
    }
    const toml::array* array = node->as_array();
    if (array == nullptr ||
        !std::ranges::all_of(*array, [](const toml::node& item) { return item.is_table(); })) {
      fail(ErrorCode::WrongType, key, fmt::format("tables [[{}]] are expected", key));
      return result;
    }
    if (array->size() > most) {
      fail(ErrorCode::BadValue, key,
           fmt::format("{}; at most {} are possible", array->size(), most));
      return result;
    }
    for (const toml::node& item : *array) {
      result.push_back(item.as_table());
    }
    return result;
  }

  /// Records an error if the key is absent.
  void require(const char* key) {
    if (!has(key)) {
      fail(ErrorCode::MissingKey, key, "");
    }
  }

  /// Records an error for a key, with the line of the key. Does nothing if an error is already
  /// recorded.
  void fail(ErrorCode code, const std::string& key, std::string detail) {
    if (error_) {
      return;
    }
    const toml::node* node = table_.get(key);
    const auto line = (node != nullptr ? node->source() : table_.source()).begin.line;
    if (line > 0) {
      detail += fmt::format("{}line {}", detail.empty() ? "" : ", ", line);
    }
    error_ = Error{code, file_, prefix_ + key, std::move(detail)};
  }

  /// Returns the error to report, or nothing. Call this function after all keys were read. If the
  /// table contains a key that was never requested, and no error other than MissingKey is recorded,
  /// the result is UnknownKey for that key. Otherwise the result is the first recorded error.
  std::optional<Error> finish() {
    for (const auto& [key, node] : table_) {
      if (std::ranges::find(known_, key.str()) == known_.end()) {
        // A misspelled key also makes the correct key missing: report the misspelling instead.
        if (error_ && error_->code == ErrorCode::MissingKey) {
          error_.reset();
        }
        fail(ErrorCode::UnknownKey, std::string{key.str()}, "");
      }
    }
    return error_;
  }

private:
  bool isWithin(const char* key, double value, double low, double high) {
    if (!std::isfinite(value)) {
      fail(ErrorCode::BadValue, key, fmt::format("{} is not a finite number", value));
      return false;
    }
    if (value < low || value > high) {
      fail(ErrorCode::BadValue, key, fmt::format("{} is not within {} to {}", value, low, high));
      return false;
    }
    return true;
  }

  const toml::node* find(const char* key) {
    known_.emplace_back(key);
    return table_.get(key);
  }

  const toml::table& table_;
  std::string file_;
  std::string prefix_;
  std::vector<std::string> known_;
  std::optional<Error> error_;
};

} // namespace dewpoint::base
