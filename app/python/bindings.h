// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <pybind11/pybind11.h>

namespace dewpoint::app {

// Functions that bind the parts of the Python module. Call them in this order, because a class must
// be bound before a signature uses it.
void bindErrors(pybind11::module_& module);
void bindCatalog(pybind11::module_& module);
void bindTargets(pybind11::module_& module);
void bindCameras(pybind11::module_& module);
void bindRecording(pybind11::module_& module);
void bindTrajectory(pybind11::module_& module);
void bindProject(pybind11::module_& module);
void bindTracker(pybind11::module_& module);

} // namespace dewpoint::app
