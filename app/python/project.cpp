// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/bindings.h"
#include "app/python/calibration_arguments.h"
#include "app/python/project_handle.h"
#include "app/python/python_error.h"
#include "app/python/recording.h"
#include "app/python/trajectory_handle.h"
#include "app/wiring/open_project.h"
#include "core/project/project_check.h"
#include "core/project/project_save.h"
#include "core/project/project_targets.h"
#include "core/setup/new_project/new_project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/catalog/method_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

using Point = std::tuple<double, double, double>;
using Volume = std::pair<Point, Point>;

ProjectHandlePtr handleOf(Project project, std::string origin) {
  return std::make_shared<ProjectHandle>(ProjectHandle{std::move(project), std::move(origin)});
}

ProjectHandlePtr openNamed(const std::filesystem::path& nameOrFile) {
  const std::string name = nameOrFile.string();
  return handleOf(valueOrRaise(resolveProject(name)), name);
}

void warn(const char* sentence) {
  if (PyErr_WarnEx(PyExc_UserWarning, sentence, 1) != 0) {
    throw py::error_already_set();
  }
}

/// The cameras of a dict (name: source), or of a list of sources, which are called as their files.
std::vector<NewCamera> newCameras(const py::object& cameras) {
  std::vector<NewCamera> made;
  const auto add = [&](const std::string& name, const py::handle& source) {
    const std::string location = source.cast<std::filesystem::path>().string();
    made.push_back({name, guessSourceKind(location), location});
  };
  if (py::isinstance<py::dict>(cameras)) {
    for (const auto& [name, source] : cameras.cast<py::dict>()) {
      add(name.cast<std::string>(), source);
    }
  } else {
    for (const py::handle& source : cameras) {
      add("", source);
    }
  }
  return made;
}

ProjectHandlePtr makeNew(const py::object& cameras,
                         const std::optional<std::filesystem::path>& calibration,
                         const std::string& name, double framesPerSecond,
                         const std::optional<std::string>& fit, const CameraRenaming& names) {
  NewProject wanted;
  wanted.cameras = newCameras(cameras);
  wanted.calibrationFile = calibration;
  wanted.name = name;
  wanted.framesPerSecond = framesPerSecond;
  wanted.adaptation = {names, sizeFitFromName(fit)};
  CreatedProject made = valueOrRaise(createNewProject(wanted));
  if (made.lacksCalibration) {
    warn("without a calibration, the camera positions are guesses");
  }
  if (made.wereCamerasMatchedByOrder) {
    warn("the calibration uses other camera names; the cameras were matched by order");
  }
  return handleOf(std::move(made.project), "");
}

void setMethod(ProjectHandle& handle, const std::string& name) {
  if (findMethod(name) == nullptr) {
    raiseProjectError(handle, {ErrorCode::BadValue, "", "method",
                               fmt::format("known methods: {}", fmt::join(methodNames(), ", "))});
  }
  if (name != handle.project.method) {
    handle.project.parameters = carryOverParameters(handle.project.parameters, name);
    handle.project.method = name;
  }
}

void setTargets(ProjectHandle& handle, std::vector<Target> targets) {
  Project changed = handle.project;
  replaceTargets(changed, std::move(targets));
  if (const auto good = checkProject(changed); !good) {
    raiseProjectError(handle, good.error());
  }
  handle.project = std::move(changed);
}

std::optional<Volume> volumeOf(const ProjectHandle& handle) {
  const auto& box = handle.project.volumeOfInterest;
  if (!box) {
    return std::nullopt;
  }
  return Volume{{box->min.x(), box->min.y(), box->min.z()},
                {box->max.x(), box->max.y(), box->max.z()}};
}

void setVolume(ProjectHandle& handle, const std::optional<Volume>& corners) {
  Project changed = handle.project;
  changed.volumeOfInterest.reset();
  if (corners) {
    const auto vectorOf = [](const Point& point) {
      return Eigen::Vector3d(std::get<0>(point), std::get<1>(point), std::get<2>(point));
    };
    changed.volumeOfInterest = WorldBox{vectorOf(corners->first), vectorOf(corners->second)};
  }
  if (const auto good = checkProject(changed); !good) {
    raiseProjectError(handle, good.error());
  }
  handle.project = std::move(changed);
}

void save(ProjectHandle& handle, const std::optional<std::filesystem::path>& wanted) {
  const std::filesystem::path file = wanted.value_or(handle.project.file);
  if (file.empty()) {
    raise(Error{ErrorCode::MissingKey, "", "file", "the project has no file yet"});
  }
  if (const auto saved = saveProject(handle.project, file); !saved) {
    raise(saved.error());
  }
  handle.project.file = std::filesystem::absolute(file).lexically_normal();
  handle.openedNameOrFile = file.string();
}

py::object fileOf(const ProjectHandle& handle) {
  return handle.project.file.empty() ? py::object(py::none())
                                     : py::object(py::str(handle.project.file.string()));
}

std::shared_ptr<TrajectoryHandle> truthOf(const ProjectHandle& handle) {
  Trajectory truth = openProjectInputs(handle).truth;
  return truth.samples.empty() ? nullptr : std::make_shared<TrajectoryHandle>(std::move(truth));
}

/// All methods and their parameters, as declared.
std::string methodsText() {
  std::string text = "Name of the tracking method. Parameters that the new method has as well keep "
                     "their values.\n\n";
  for (const Method& method : methods()) {
    text += fmt::format("{}: {}. {}\n", method.name, method.text.title, method.text.summary);
  }
  return text;
}

void bindFields(ProjectClass& project) {
  project
      .def_property(
          "name", [](const ProjectHandle& handle) { return handle.project.name; },
          [](ProjectHandle& handle, const std::string& name) { handle.project.name = name; },
          "Its name.")
      .def_property_readonly("file", fileOf, "Its file, or None if it was never saved.")
      .def_property(
          "method", [](const ProjectHandle& handle) { return handle.project.method; }, setMethod,
          methodsText().c_str())
      .def_property(
          "seed", [](const ProjectHandle& handle) { return handle.project.seed; },
          [](ProjectHandle& handle, std::uint64_t seed) { handle.project.seed = seed; },
          "Seed of the random numbers: the same seed gives the same bits.")
      .def_property(
          "targets", [](const ProjectHandle& handle) { return handle.project.targets; }, setTargets,
          "What is tracked, a list of copies: assign another list to change the targets.")
      .def_property_readonly(
          "cameras", [](const ProjectHandle& handle) { return handle.project.cameras; },
          "Its cameras, a list of copies.")
      .def_property("volume", volumeOf, setVolume,
                    "The box in which targets are searched for, two corners in meters, or None.");
}

} // namespace

void raiseProjectError(const ProjectHandle& handle, Error error) {
  if (error.file.empty()) {
    error.file = handle.openedNameOrFile;
  }
  raise(error);
}

SessionInputs openProjectInputs(const ProjectHandle& handle) {
  Project project = handle.project;
  auto inputs = [&] {
    const py::gil_scoped_release release;
    return openInputs(std::move(project));
  }();
  if (!inputs) {
    raiseProjectError(handle, inputs.error());
  }
  return std::move(*inputs);
}

void bindProject(py::module_& module) {
  ProjectClass project(module, "Project",
                       "Cameras, targets, a method and its parameters: everything that a run "
                       "needs. Made by open() and make().");
  bindFields(project);
  bindParameters(module, project);
  bindColorLearning(module, project);
  bindCalibration(module, project);
  bindTracking(module, project);
  project
      .def(
          "recording",
          [](const ProjectHandle& handle) {
            return std::make_shared<RecordingHandle>(openProjectInputs(handle));
          },
          "Opens its cameras to read their images.")
      .def("truth", truthOf, "The true positions of its targets, or None if they are unknown.")
      .def("save", save, py::arg("file") = py::none(),
           "Writes it to a file (TOML), by default its own, which is replaced.")
      .def("__repr__", [](const ProjectHandle& handle) {
        return fmt::format("<dewpoint.Project {}, method {}>", handle.project.name,
                           handle.project.method);
      });
  module.def("open", openNamed, py::arg("name"),
             "Opens a project file, or a built-in scene by its name: demo.");
  module.def(
      "make", makeNew, py::arg("cameras"), py::kw_only(), py::arg("calibration") = py::none(),
      py::arg("name") = "", py::arg("frames_per_second") = 0.0, py::arg("fit") = py::none(),
      py::arg("names") = CameraRenaming(),
      "Makes a project of videos, folders of images, devices or streams: a dict of names "
      "and sources, or a list of sources. calibration: a file whose cameras are matched by "
      "name, otherwise by order; frames_per_second: of folders of images (default: 30). fit: "
      "how the images were changed if they have another size than those of the calibration "
      "(crop, trim, scale, rotate-90, rotate-270). names: the name in the file of each "
      "camera, if they differ.");
}

} // namespace dewpoint::app
