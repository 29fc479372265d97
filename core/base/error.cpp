// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include "core/base/one_line.h"

namespace dewpoint::base {

const char* errorPhrase(ErrorCode code) {
  switch (code) {
  case ErrorCode::FileMissing:
    return "the file does not exist";
  case ErrorCode::FileUnreadable:
    return "the file cannot be read";
  case ErrorCode::FileUnwritable:
    return "cannot be written";
  case ErrorCode::NotParsed:
    return "invalid format";
  case ErrorCode::UnknownKey:
    return "unknown key";
  case ErrorCode::MissingKey:
    return "this key is missing";
  case ErrorCode::WrongType:
    return "wrong type of value";
  case ErrorCode::BadValue:
    return "not a usable value";
  case ErrorCode::Mismatch:
    return "does not match the other data";
  case ErrorCode::EndedEarly:
    return "ends earlier than expected";
  case ErrorCode::DeviceUnavailable:
    return "the camera cannot be opened";
  case ErrorCode::ConnectionLost:
    return "the camera stopped delivering images";
  case ErrorCode::NotFound:
    return "not found";
  case ErrorCode::Undetermined:
    return "cannot be determined from the observations";
  case ErrorCode::Canceled:
    return "stopped on request";
  case ErrorCode::ImagesBlack:
    return "the images are black";
  case ErrorCode::ImagesFrozen:
    return "the images do not change";
  case ErrorCode::ImagesRepeat:
    return "the camera repeats images";
  case ErrorCode::ImagesLate:
    return "the images arrive late";
  case ErrorCode::ImagesFew:
    return "the camera sends fewer images than it should";
  }
  return "failed";
}

std::string errorSentence(const Error& error) {
  std::string text;
  if (!error.file.empty()) {
    text += toSingleLine(error.file) + ": ";
  }
  if (!error.field.empty()) {
    text += toSingleLine(error.field) + ": ";
  }
  text += errorPhrase(error.code);
  if (!error.detail.empty()) {
    text += " (" + toSingleLine(error.detail) + ")";
  }
  return text;
}

} // namespace dewpoint::base
