// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace dewpoint::base {

/// What went wrong, as far as a caller can act on it. Each code has one sentence of its own
/// (phrase()), which the window translates.
enum class ErrorCode {
  FileMissing,
  FileUnreadable,
  FileUnwritable,
  NotParsed,
  UnknownKey,
  MissingKey,
  WrongType,
  BadValue,
  Mismatch,
  EndedEarly,
  DeviceUnavailable,
  ConnectionLost,
  NotFound,
  Undetermined,
  Cancelled,
};

/// One failure, as a value: which file (or device, or address), which field in it, and the
/// particulars. `file` and `field` may be empty where they make no sense.
struct Error {
  ErrorCode code = ErrorCode::BadValue;
  std::string file;
  std::string field;
  std::string detail;
};

template <class T> using Result = tl::expected<T, Error>;
using Status = Result<void>;

/// Shorthand to return a failure from a function that returns a Result.
inline tl::unexpected<Error> failure(ErrorCode code, std::string file, std::string field,
                                     std::string detail) {
  return tl::make_unexpected(Error{code, std::move(file), std::move(field), std::move(detail)});
}

/// The plain English words of a code, without file, field or detail ("the file does not exist").
const char* phrase(ErrorCode code);

/// One clear sentence for the user: "project.toml: camera 1.video: the file does not exist
/// (a.mkv)".
std::string sentence(const Error& error);

} // namespace dewpoint::base
