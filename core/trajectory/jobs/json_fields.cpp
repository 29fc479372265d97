// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/jobs/json_fields.h"

#include "core/base/limits.h"
#include "core/base/text_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::trajectory {

using nlohmann::ordered_json;

Result<ordered_json> readJsonObject(const std::string& file) {
  const auto text = readTextFile(file);
  if (!text) {
    return tl::make_unexpected(text.error());
  }
  if (text->size() > limits::kMaxRecordBytes) {
    return failure(ErrorCode::FileUnreadable, file, "",
                   fmt::format("it is larger than {} MiB", limits::kMaxRecordBytes >> 20U));
  }
  // The library's errors end here.
  try {
    ordered_json json = ordered_json::parse(*text);
    if (!json.is_object()) {
      return failure(ErrorCode::NotParsed, file, "", "a JSON object is expected");
    }
    return json;
  } catch (const ordered_json::exception& error) {
    return failure(ErrorCode::NotParsed, file, "", error.what());
  }
}

JsonFieldReader::JsonFieldReader(const ordered_json& object, std::string file, std::string prefix)
    : object_(object), file_(std::move(file)), prefix_(std::move(prefix)) {}

void JsonFieldReader::readText(const char* key, std::string& value) {
  if (const ordered_json* found = find(key)) {
    if (found->is_string()) {
      value = found->get<std::string>();
    } else {
      fail(ErrorCode::WrongType, key, "a text is expected");
    }
  }
}

void JsonFieldReader::readNumber(const char* key, double& value) {
  if (const ordered_json* found = find(key)) {
    if (found->is_number()) {
      value = found->get<double>();
    } else {
      fail(ErrorCode::WrongType, key, "a number is expected");
    }
  }
}

const ordered_json* JsonFieldReader::findObjectArray(const char* key) {
  const ordered_json* found = find(key);
  if (found == nullptr) {
    return nullptr;
  }
  if (!found->is_array() ||
      !std::ranges::all_of(*found, [](const ordered_json& one) { return one.is_object(); })) {
    fail(ErrorCode::WrongType, key, "an array of objects is expected");
    return nullptr;
  }
  if (found->size() > kMaxRecordEntries) {
    fail(ErrorCode::BadValue, key,
         fmt::format("{}; at most {} are possible", found->size(), kMaxRecordEntries));
    return nullptr;
  }
  return found;
}

void JsonFieldReader::fail(ErrorCode code, const char* key, std::string detail) {
  if (!error_) {
    error_ = Error{code, file_, prefix_ + key, std::move(detail)};
  }
}

void JsonFieldReader::recordErrorOf(const JsonFieldReader& part) {
  if (!error_) {
    error_ = part.error_;
  }
}

const ordered_json* JsonFieldReader::find(const char* key) {
  const auto found = object_.find(key);
  if (found == object_.end()) {
    fail(ErrorCode::MissingKey, key, "");
    return nullptr;
  }
  return &*found;
}

} // namespace dewpoint::trajectory
