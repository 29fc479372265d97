// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/bindings.h"
#include "app/python/python_error.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/catalog/method_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

using Declarations = std::vector<ParameterDeclaration>;

void bindParameter(py::module_& module) {
  py::class_<ParameterDeclaration>(module, "Parameter", "A parameter of a method, as declared.")
      .def_readonly("key", &ParameterDeclaration::key, "Its name in projects.")
      .def_readonly("label", &ParameterDeclaration::label, "Its name in the window.")
      .def_readonly("unit", &ParameterDeclaration::unit, "\"m\", or \"\" for a plain number.")
      .def_readonly("minimum", &ParameterDeclaration::minimum, "The smallest allowed value.")
      .def_readonly("maximum", &ParameterDeclaration::maximum, "The largest allowed value.")
      .def_readonly("default", &ParameterDeclaration::defaultValue, "The value if none is given.")
      .def_readonly("from_cameras", &ParameterDeclaration::isDerivedFromCameras,
                    "Whether the value is derived from what the cameras see if none is given.")
      .def_property_readonly(
          "whole",
          [](const ParameterDeclaration& declaration) {
            return declaration.kind == ParameterKind::Integer;
          },
          "Whether only whole numbers are allowed.")
      .def_readonly("sentence", &ParameterDeclaration::description, "What it does.")
      .def("__repr__", [](const ParameterDeclaration& declaration) {
        return fmt::format("<dewpoint.Parameter {}: {}>", declaration.key,
                           parameterText(declaration));
      });
}

void bindMethod(py::module_& module) {
  py::class_<Method>(module, "Method", "A tracking method.")
      .def_readonly("name", &Method::name, "Its name in projects.")
      .def_property_readonly(
          "title", [](const Method& method) { return method.text.title; }, "What it tracks.")
      .def_property_readonly(
          "sentence", [](const Method& method) { return method.text.summary; },
          "What it is for, or what sets it apart.")
      .def_property_readonly(
          "paper", [](const Method& method) { return method.text.paper; },
          "The paper that it follows exactly; \"\" for the project's own methods.")
      .def_property_readonly(
          "needs_calibration", [](const Method& method) { return method.family.needsCalibration; },
          "Whether it estimates positions in the room; otherwise boxes in the images of one "
          "camera.")
      .def_property_readonly(
          "parameters",
          [](const Method& method) {
            const auto declared = method.parameters();
            return Declarations(declared.begin(), declared.end());
          },
          "Its parameters, as declared.")
      .def_property_readonly("reference", methodReference,
                             "All of this as text, with a line for each parameter.")
      .def("__repr__", [](const Method& method) {
        return fmt::format("<dewpoint.Method {}: {}>", method.name, method.text.title);
      });
}

py::list allMethods() {
  py::list all;
  for (const Method& method : methods()) {
    all.append(py::cast(&method, py::return_value_policy::reference));
  }
  return all;
}

} // namespace

void bindCatalog(py::module_& module) {
  bindParameter(module);
  bindMethod(module);
  module.def("methods", allMethods, "All tracking methods, the default first.");
}

} // namespace dewpoint::app
