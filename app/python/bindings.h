// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <pybind11/pybind11.h>

namespace dewpoint::app {

// What the Python module consists of, in the order in which it is bound: a class is bound before a
// signature names it.
void bindErrors(pybind11::module_& module);
void bindCatalog(pybind11::module_& module);
void bindTargets(pybind11::module_& module);
void bindCameras(pybind11::module_& module);
void bindRecording(pybind11::module_& module);
void bindTrajectory(pybind11::module_& module);
void bindProject(pybind11::module_& module);
void bindTracker(pybind11::module_& module);

} // namespace dewpoint::app
