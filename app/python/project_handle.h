// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/session_inputs.h"

#include <memory>
#include <pybind11/pybind11.h>
#include <string>

namespace dewpoint::app {

/// Project as a Python object.
struct ProjectHandle {
  Project project;
  /// File or name with which the project was opened, for error messages; may be empty.
  std::string openedNameOrFile;
};
using ProjectHandlePtr = std::shared_ptr<ProjectHandle>;
using ProjectClass = pybind11::class_<ProjectHandle, ProjectHandlePtr>;

// Functions that bind the methods of the Python class of a project, grouped by purpose.
void bindParameters(pybind11::module_& module, ProjectClass& project);
void bindColorLearning(pybind11::module_& module, ProjectClass& project);
void bindCalibration(pybind11::module_& module, ProjectClass& project);
void bindTracking(pybind11::module_& module, ProjectClass& project);

/// Throws the Python exception for an error in a project, with the text that the command line
/// prints.
[[noreturn]] void raiseProjectError(const ProjectHandle& handle, Error error);
/// Opens the videos or cameras of a project. Releases the GIL meanwhile.
SessionInputs openProjectInputs(const ProjectHandle& handle);

} // namespace dewpoint::app
