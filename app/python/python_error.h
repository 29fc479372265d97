// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <pybind11/pybind11.h>
#include <string>
#include <type_traits>
#include <utility>

namespace dewpoint::app {

/// The exception `dewpoint.Error` of a failure: its text is the sentence of the command line.
pybind11::object pythonError(const Error& error);
/// Throws it; needs the GIL.
[[noreturn]] void raise(const Error& error);
/// Throws an exception that was made already.
[[noreturn]] void raise(const pybind11::object& exception);
/// BadValue about an argument.
[[noreturn]] void raiseBadValue(const char* argument, std::string detail);

/// The value, or the exception.
template <class T> T valueOf(Result<T> result) {
  if (!result) {
    raise(result.error());
  }
  if constexpr (!std::is_void_v<T>) {
    return std::move(*result);
  }
}

} // namespace dewpoint::app
