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

/// Reads the file of one JSON object. Errors: those of readTextFile(); FileUnreadable if the file
/// is larger than limits::kMaxRecordBytes; NotParsed if it is not a JSON object.
Result<nlohmann::ordered_json> readJsonObject(const std::string& file);

/// Reads the mandatory keys of a JSON object and keeps the first error, which names the file and,
/// as the field, `prefix` followed by the key. Other keys are ignored, because later versions may
/// add some. Unlike the conversions of the library, a number is never cut to fit its type.
class JsonFields {
public:
  JsonFields(const nlohmann::ordered_json& object, std::string file, std::string prefix);

  void text(const char* key, std::string& value);
  /// Reads a number, which is finite because JSON knows no others.
  void number(const char* key, double& value);
  /// Reads a whole number between `low` and `high`, inclusive.
  template <std::integral Integer>
  void integer(const char* key, Integer& value, Integer low, Integer high) {
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
  /// The same, but nothing for null.
  template <std::integral Integer>
  void integer(const char* key, std::optional<Integer>& value, Integer low, Integer high) {
    if (const nlohmann::ordered_json* found = find(key); found != nullptr && !found->is_null()) {
      Integer read = low;
      integer(key, read, low, high);
      value = read;
    }
  }
  /// Returns the array of objects under a key, or null after an error. More than kMaxRecordEntries
  /// entries, and an entry that is not an object, are errors.
  const nlohmann::ordered_json* objects(const char* key);

  /// Records an error, unless there is one already.
  void fail(ErrorCode code, const char* key, std::string detail);
  /// Records the error of a part, unless there is one already.
  void recordErrorOf(const JsonFields& part);
  const std::optional<Error>& error() const { return error_; }

private:
  const nlohmann::ordered_json* find(const char* key);

  const nlohmann::ordered_json& object_;
  std::string file_;
  std::string prefix_;
  std::optional<Error> error_;
};

} // namespace dewpoint::trajectory
