// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace dewpoint::base {

/// Kind of a failure, as far as a caller can act on it. Each code has its own sentence (phrase()),
/// which the window translates.
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
  Canceled,
};

/// A failure as a value: the file (or device, or network address), the field in it, and details.
/// `file` and `field` may be empty where they do not apply.
struct Error {
  ErrorCode code = ErrorCode::BadValue;
  std::string file;
  std::string field;
  std::string detail;
};

/// A value, or the error that prevented it.
template <class T> using Result = tl::expected<T, Error>;
/// Success, or an error.
using Status = Result<void>;

/// Shorthand for returning a failure from a function that returns a Result.
inline tl::unexpected<Error> failure(ErrorCode code, std::string file, std::string field,
                                     std::string detail) {
  return tl::make_unexpected(Error{code, std::move(file), std::move(field), std::move(detail)});
}

/// Plain English phrase for a code, without file, field or detail ("the file does not exist").
const char* phrase(ErrorCode code);

/// One clear sentence for the user: "project.toml: camera 1.video: the file does not exist
/// (a.mkv)".
std::string sentence(const Error& error);

} // namespace dewpoint::base
