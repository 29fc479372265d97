// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <nlohmann/json.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace dewpoint::trajectory {

/// Maximum number of targets or files in the record of a job.
inline constexpr std::size_t kMaxRecordEntries = 10'000;

/// Reads a file that contains one JSON object. Errors: those of readTextFile(); FileUnreadable if
/// the file is larger than limits::kMaxRecordBytes; NotParsed if it does not contain a JSON object.
Result<nlohmann::ordered_json> readJsonObject(const std::string& file);

/// Reads required keys of a JSON object and stores the first error. The error names the file and
/// the field, which is `prefix` followed by the key. Keys that are not read are ignored, because
/// later versions may add some. A number that does not fit its type is an error.
class JsonFieldReader {
public:
  JsonFieldReader(const nlohmann::ordered_json& object, std::string file, std::string prefix);

  /// Reads a text into `value`. Leaves `value` unchanged after an error.
  void readText(const char* key, std::string& value);
  /// Reads a number into `value`. The number is always finite, because JSON has no other numbers.
  /// Leaves `value` unchanged after an error.
  void readNumber(const char* key, double& value);
  /// Reads a whole number from `low` to `high`, both included, into `value`. Leaves `value`
  /// unchanged after an error.
  template <std::integral Integer>
  void readInteger(const char* key, Integer& value, Integer low, Integer high) {
    const nlohmann::ordered_json* found = find(key);
    if (found == nullptr) {
      return;
    }
    if (!found->is_number_integer()) {
      fail(ErrorCode::WrongType, key, "a whole number is expected");
      return;
    }
    const auto isWithin = [&](auto read) {
      return std::cmp_greater_equal(read, low) && std::cmp_less_equal(read, high);
    };
    if (found->is_number_unsigned() ? !isWithin(found->get<std::uint64_t>())
                                    : !isWithin(found->get<std::int64_t>())) {
      fail(ErrorCode::BadValue, key,
           found->dump() + " is not within " + std::to_string(low) + " to " + std::to_string(high));
      return;
    }
    value = found->get<Integer>();
  }
  /// Reads a whole number from `low` to `high`, both included, or null. For null, `value` is not
  /// changed.
  template <std::integral Integer>
  void readInteger(const char* key, std::optional<Integer>& value, Integer low, Integer high) {
    if (const nlohmann::ordered_json* found = find(key); found != nullptr && !found->is_null()) {
      Integer parsed = low;
      readInteger(key, parsed, low, high);
      value = parsed;
    }
  }
  /// Returns the array of objects under a key, or null after an error. It is an error if an entry
  /// is not an object, or if there are more than kMaxRecordEntries entries.
  const nlohmann::ordered_json* findObjectArray(const char* key);

  /// Stores an error for a key, unless an error is already stored.
  void fail(ErrorCode code, const char* key, std::string detail);
  /// Stores the error of `part`, if it has one, unless an error is already stored. Use it for an
  /// object inside this object.
  void recordErrorOf(const JsonFieldReader& part);
  const std::optional<Error>& error() const { return error_; }

private:
  const nlohmann::ordered_json* find(const char* key);

  const nlohmann::ordered_json& object_;
  std::string file_;
  std::string prefix_;
  std::optional<Error> error_;
};

} // namespace dewpoint::trajectory
