// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/python_error.h"

#include "app/python/bindings.h"

namespace py = pybind11;

namespace dewpoint::app {
namespace {

constexpr const char* kErrorDoc =
    "What went wrong, in the same sentence as on the command line.\n\ncode: an ErrorCode; file, "
    "field, detail: the parts of the sentence, possibly empty;\nresult: what Project.track() found "
    "before the recording failed, otherwise None.";

/// Lives as long as the interpreter.
PyObject* errorType = nullptr;

} // namespace

py::object pythonError(const Error& error) {
  py::object exception = py::reinterpret_borrow<py::object>(errorType)(errorSentence(error) + ".");
  exception.attr("code") = py::cast(error.code);
  exception.attr("file") = error.file;
  exception.attr("field") = error.field;
  exception.attr("detail") = error.detail;
  exception.attr("result") = py::none();
  return exception;
}

void raise(const py::object& exception) {
  PyErr_SetObject(errorType, exception.ptr());
  throw py::error_already_set();
}

void raise(const Error& error) {
  raise(pythonError(error));
}

void raiseBadValue(const char* argument, std::string detail) {
  raise(Error{ErrorCode::BadValue, "", argument, std::move(detail)});
}

void bindErrors(py::module_& module) {
  py::enum_<ErrorCode>(module, "ErrorCode", "What kind of failure an Error is.")
      .value("FILE_MISSING", ErrorCode::FileMissing)
      .value("FILE_UNREADABLE", ErrorCode::FileUnreadable)
      .value("FILE_UNWRITABLE", ErrorCode::FileUnwritable)
      .value("NOT_PARSED", ErrorCode::NotParsed)
      .value("UNKNOWN_KEY", ErrorCode::UnknownKey)
      .value("MISSING_KEY", ErrorCode::MissingKey)
      .value("WRONG_TYPE", ErrorCode::WrongType)
      .value("BAD_VALUE", ErrorCode::BadValue)
      .value("MISMATCH", ErrorCode::Mismatch)
      .value("ENDED_EARLY", ErrorCode::EndedEarly)
      .value("DEVICE_UNAVAILABLE", ErrorCode::DeviceUnavailable)
      .value("CONNECTION_LOST", ErrorCode::ConnectionLost)
      .value("NOT_FOUND", ErrorCode::NotFound)
      .value("UNDETERMINED", ErrorCode::Undetermined)
      .value("CANCELED", ErrorCode::Canceled)
      .value("IMAGES_BLACK", ErrorCode::ImagesBlack)
      .value("IMAGES_FROZEN", ErrorCode::ImagesFrozen)
      .value("IMAGES_REPEAT", ErrorCode::ImagesRepeat)
      .value("IMAGES_LATE", ErrorCode::ImagesLate)
      .value("IMAGES_FEW", ErrorCode::ImagesFew);
  errorType = PyErr_NewExceptionWithDoc("dewpoint.Error", kErrorDoc, PyExc_Exception, nullptr);
  if (errorType == nullptr) {
    throw py::error_already_set();
  }
  module.attr("Error") = py::reinterpret_borrow<py::object>(errorType);
}

} // namespace dewpoint::app
