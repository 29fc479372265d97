// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace dewpoint::base {

/// Kinds of failure that callers need to distinguish. Each code has its own phrase (see
/// errorPhrase()), which the user interface translates.
enum class ErrorCode {
  FileMissing,
  FileUnreadable,
  FileUnwritable,
  NotParsed,
  UnknownKey,
  MissingKey,
  WrongType,
  BadValue,
  Mismatch,   ///< two pieces of data do not fit each other
  EndedEarly, ///< a file or recording ended before its expected end
  DeviceUnavailable,
  ConnectionLost, ///< the camera stopped delivering images
  NotFound,       ///< the requested item does not exist
  Undetermined,   ///< the observations do not determine the result
  Canceled,       ///< stopped at the user's request
  ImagesBlack,
  ImagesFrozen, ///< the images do not change
  ImagesRepeat, ///< the camera sends some images repeatedly
  ImagesLate,   ///< the images arrive late
  ImagesFew,    ///< the camera sends fewer images than it should
};

/// Description of a failure: its kind, the file (or the device or network address), the field in
/// the file, and details. `file` and `field` are empty if they do not apply.
struct Error {
  ErrorCode code = ErrorCode::BadValue;
  std::string file;
  std::string field;
  std::string detail;

  bool operator==(const Error&) const = default;
};

/// A value, or the error that prevented computing it.
template <class T> using Result = tl::expected<T, Error>;
/// Success, or an error.
using Status = Result<void>;

/// Builds the failure value for a function that returns a Result.
inline tl::unexpected<Error> failure(ErrorCode code, std::string file, std::string field,
                                     std::string detail) {
  return tl::make_unexpected(Error{code, std::move(file), std::move(field), std::move(detail)});
}

/// Returns the plain English phrase for a code, without file, field or detail, for example "the
/// file does not exist".
const char* errorPhrase(ErrorCode code);

/// Returns the error as one sentence for the user, for example "project.toml: camera 1.video: the
/// file does not exist (a.mkv)".
std::string errorSentence(const Error& error);

} // namespace dewpoint::base
