// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/project_handle.h"
#include "app/python/python_error.h"
#include "core/setup/default_parameters.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/catalog/method_reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

/// The parameters of a project's method, as a mapping.
struct ParametersHandle {
  ProjectHandlePtr project;
};

const ParameterDeclaration* declarationOf(const ParametersHandle& handle, const std::string& key) {
  const auto declared = handle.project->project.parameters.declarations();
  const auto found = std::ranges::find(declared, key, &ParameterDeclaration::key);
  return found == declared.end() ? nullptr : &*found;
}

/// The same; throws what setting an unknown one would say.
const ParameterDeclaration& neededDeclaration(const ParametersHandle& handle,
                                              const std::string& key) {
  const ParameterDeclaration* const found = declarationOf(handle, key);
  if (found == nullptr) {
    ParameterValues values = handle.project->project.parameters;
    valueOrRaise(values.set(key, 0.0));
  }
  return *found;
}

py::object valueFor(const ParameterDeclaration& declaration, const ParameterValues& values) {
  const double value = values.at(declaration.key);
  return declaration.kind == ParameterKind::Integer
             ? py::object(py::int_(static_cast<std::int64_t>(value)))
             : py::object(py::float_(value));
}

py::dict valuesInUse(const ParametersHandle& handle) {
  const ParameterValues used = effectiveParameters(handle.project->project);
  py::dict values;
  for (const ParameterDeclaration& declaration : used.declarations()) {
    values[py::str(declaration.key)] = valueFor(declaration, used);
  }
  return values;
}

/// The documentation of the class: every method with its parameters, as declared.
std::string parametersText() {
  std::string text = "The parameters of a project's method: a mapping from keys to the values with "
                     "which it is tracked. Values that come from the cameras do so until they are "
                     "set.\n";
  for (const Method& method : methods()) {
    text += "\n" + methodReference(method);
  }
  return text;
}

} // namespace

void bindParameters(py::module_& module, ProjectClass& project) {
  py::class_<ParametersHandle>(module, "Parameters", parametersText().c_str())
      .def("__getitem__",
           [](const ParametersHandle& handle, const std::string& key) {
             return valueFor(neededDeclaration(handle, key),
                             effectiveParameters(handle.project->project));
           })
      .def("__setitem__",
           [](const ParametersHandle& handle, const std::string& key, double value) {
             valueOrRaise(handle.project->project.parameters.set(key, value));
           })
      .def("__contains__",
           [](const ParametersHandle& handle, const std::string& key) {
             return declarationOf(handle, key) != nullptr;
           })
      .def("__len__",
           [](const ParametersHandle& handle) {
             return handle.project->project.parameters.declarations().size();
           })
      .def("__iter__", [](const ParametersHandle& handle) { return py::iter(valuesInUse(handle)); })
      .def(
          "keys", [](const ParametersHandle& handle) { return py::list(valuesInUse(handle)); },
          "Their keys.")
      .def(
          "items",
          [](const ParametersHandle& handle) {
            return py::list(valuesInUse(handle).attr("items")());
          },
          "Keys and values.")
      .def(
          "is_given",
          [](const ParametersHandle& handle, const std::string& key) {
            neededDeclaration(handle, key);
            return handle.project->project.parameters.isGiven(key);
          },
          py::arg("key"), "False for a value that comes from the cameras.")
      .def(
          "reset",
          [](const ParametersHandle& handle, const std::string& key) {
            neededDeclaration(handle, key);
            resetParameter(handle.project->project, key);
          },
          py::arg("key"),
          "Resets the value to its default, or to the value derived from the cameras.")
      .def("__repr__", [](const ParametersHandle& handle) {
        return fmt::format("<dewpoint.Parameters {}>",
                           py::repr(valuesInUse(handle)).cast<std::string>());
      });
  project.def_property_readonly(
      "parameters", [](const ProjectHandlePtr& handle) { return ParametersHandle{handle}; },
      "The parameters of its method; assign to a key to change one.");
}

} // namespace dewpoint::app
