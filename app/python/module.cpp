// SPDX-License-Identifier: GPL-3.0-or-later
// The compiled part of the Python package dewpoint (app/python/dewpoint), which names what it
// holds.
#include "app/python/bindings.h"
#include "app/wiring/quiet_libraries.h"

#include <pybind11/pybind11.h>

namespace dewpoint::app {
namespace {

void bindAll(pybind11::module_& module) {
  bindErrors(module);
  bindCatalog(module);
  bindTargets(module);
  bindCameras(module);
  bindRecording(module);
  bindTrajectory(module);
  bindProject(module);
  bindTracker(module);
}

} // namespace
} // namespace dewpoint::app

PYBIND11_MODULE(_dewpoint, module) {
  dewpoint::app::silenceLibraries();
  const pybind11::object ownName = module.attr("__name__");
  module.attr("__name__") = "dewpoint"; // where users find what is bound
  dewpoint::app::bindAll(module);
  module.attr("__name__") = ownName;
  module.attr("__version__") = DEWPOINT_VERSION;
}
