// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <exception>
#include <pybind11/pybind11.h>
#include <utility>

namespace dewpoint::app {

/// Calls an optional Python function from C++ work that runs without the GIL, in any thread. The
/// work must end if the function returns False or raises an exception, and on Ctrl-C. An exception
/// is stored until `rethrow()` is called, so that it does not pass through the core library.
class PythonProgress {
public:
  explicit PythonProgress(pybind11::object callback) : callback_(std::move(callback)) {}

  /// Calls the function and returns whether the work should continue. Acquires the GIL during the
  /// call.
  template <class... Arguments> bool call(Arguments&&... arguments) {
    const pybind11::gil_scoped_acquire gil;
    if (failed_) {
      return false;
    }
    try {
      if (PyErr_CheckSignals() != 0) {
        throw pybind11::error_already_set();
      }
      return callback_.is_none() ||
             callback_(std::forward<Arguments>(arguments)...).ptr() != Py_False;
    } catch (...) {
      failed_ = std::current_exception();
    }
    return false;
  }
  /// Throws the stored exception, if any. Call this after the work has ended, while holding the
  /// GIL.
  void rethrow() {
    if (failed_) {
      std::rethrow_exception(std::exchange(failed_, nullptr));
    }
  }

private:
  pybind11::object callback_;
  std::exception_ptr failed_;
};

} // namespace dewpoint::app
