// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <pybind11/pybind11.h>
#include <string>
#include <type_traits>
#include <utility>

namespace dewpoint::app {

/// Creates the Python exception `dewpoint.Error` for an error. The text of the exception is the
/// sentence that the command line prints.
pybind11::object pythonError(const Error& error);
/// Throws the Python exception `dewpoint.Error` for an error. The caller must hold the GIL.
[[noreturn]] void raise(const Error& error);
/// Throws an existing Python exception.
[[noreturn]] void raise(const pybind11::object& exception);
/// Throws the Python exception `dewpoint.Error` for an argument with a wrong value.
[[noreturn]] void raiseBadValue(const char* argument, std::string detail);

/// Returns the value of a result, or throws its error as a Python exception.
template <class T> T valueOrRaise(Result<T> result) {
  if (!result) {
    raise(result.error());
  }
  if constexpr (!std::is_void_v<T>) {
    return std::move(*result);
  }
}

} // namespace dewpoint::app
