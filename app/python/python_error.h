// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <pybind11/pybind11.h>
#include <string>
#include <type_traits>
#include <utility>

namespace dewpoint::app {

/// Creates the exception `dewpoint.Error` for an error; its text is the sentence that the command
/// line prints.
pybind11::object pythonError(const Error& error);
/// Throws the exception for an error; requires the GIL.
[[noreturn]] void raise(const Error& error);
/// Throws an existing exception.
[[noreturn]] void raise(const pybind11::object& exception);
/// Throws the exception for a BadValue error about an argument.
[[noreturn]] void raiseBadValue(const char* argument, std::string detail);

/// Returns the value of a result, or throws its error as an exception.
template <class T> T valueOf(Result<T> result) {
  if (!result) {
    raise(result.error());
  }
  if constexpr (!std::is_void_v<T>) {
    return std::move(*result);
  }
}

} // namespace dewpoint::app
