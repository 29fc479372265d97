// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/calibration_arguments.h"
#include "app/python/project_handle.h"
#include "app/python/python_error.h"
#include "app/python/python_progress.h"
#include "app/wiring/open_project.h"
#include "core/base/angle.h"
#include "core/setup/calibration/board_outcome.h"
#include "core/setup/calibration/calibration_exchange.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

/// The value of a name; throws what the argument may be.
template <class T>
T chosen(const std::map<std::string, T>& choices, const char* argument, const std::string& name) {
  const auto found = choices.find(name);
  if (found != choices.end()) {
    return found->second;
  }
  std::string names;
  for (const auto& [one, value] : choices) {
    names += (names.empty() ? "" : ", ") + one;
  }
  raiseBadValue(argument, fmt::format("one of {}; not {}", names, name));
}

std::optional<double> metersFrom(const std::optional<std::string>& unit) {
  if (!unit) {
    return std::nullopt;
  }
  const auto meters = parseLengthUnit(*unit);
  if (!meters) {
    raiseBadValue("unit", lengthUnitProblem(*unit));
  }
  return meters;
}

CalibrationImport importInto(ProjectHandle& handle, const std::filesystem::path& path,
                             const std::string& format, const std::optional<std::string>& unit,
                             const std::optional<std::array<int, 2>>& size,
                             const std::optional<std::string>& lens,
                             const std::optional<std::string>& poses,
                             const std::optional<std::string>& fit, const CameraRenaming& names) {
  ImportRequest request{path, {format, metersFrom(unit), std::nullopt, size, std::nullopt}};
  if (lens) {
    request.hints.lens = chosen<LensModel>(
        {{"pinhole", LensModel::Pinhole}, {"fisheye", LensModel::Fisheye}}, "lens", *lens);
  }
  if (poses) {
    request.hints.posesAreWorldFromCamera =
        chosen<bool>({{"camera-from-world", false}, {"world-from-camera", true}}, "poses", *poses);
  }
  request.adaptation = {names, sizeFitFromName(fit)};
  CalibrationImport imported = valueOrRaise(importCalibration(handle.project, request));
  handle.project = imported.project;
  return imported;
}

std::vector<std::string> exportTo(const ProjectHandle& handle, const std::filesystem::path& path,
                                  const std::string& format, const std::optional<std::string>& unit,
                                  bool replace) {
  const CalibrationOutput target{path, format, metersFrom(unit), replace};
  return valueOrRaise(exportCalibration(handle.project, target)).decisions;
}

struct BoardArguments {
  BoardCalibrationRequest request;
  BoardGoal goal;
};

BoardOutcome calibrateWithBoard(ProjectHandle& handle, const BoardArguments& arguments,
                                const py::object& callback) {
  SessionInputs inputs = openProjectInputs(handle);
  PythonProgress progress(callback);
  auto outcome = [&] {
    const py::gil_scoped_release release;
    return calibrateFromBoards(
        inputs.project, *inputs.source, arguments.request, arguments.goal,
        [&](CalibrationStage /*stage*/, double part) { return progress.call(part); });
  }();
  progress.rethrow();
  if (!outcome) {
    raise(outcome.error());
  }
  handle.project = outcome->project;
  return std::move(*outcome);
}

BoardOutcome calibrateBoard(ProjectHandle& handle, const std::string& board, bool lenses,
                            bool poses, const std::string& model, const std::string& pixels,
                            int maxSearchedFrames, int views, int instants,
                            const std::optional<std::int64_t>& worldFrame, bool refineLenses,
                            const py::object& progress) {
  if (!lenses && !poses) {
    raiseBadValue("lenses", "at least one of lenses and poses must be True");
  }
  if (maxSearchedFrames < 1 || views < 3 || instants < 1 || worldFrame.value_or(0) < 0) {
    raiseBadValue("looks", "looks and instants from 1, views from 3, world_frame from 0 on");
  }
  BoardArguments arguments;
  arguments.goal = {lenses, poses};
  arguments.request.board = valueOrRaise(parseBoard(board, "board"));
  arguments.request.model = chosen<IntrinsicsModel>({{"5", IntrinsicsModel::FiveCoefficients},
                                                     {"8", IntrinsicsModel::EightCoefficients},
                                                     {"fisheye", IntrinsicsModel::Fisheye}},
                                                    "model", model);
  arguments.request.pixelShape = chosen<PixelShape>({{"measured", PixelShape::Measured},
                                                     {"square", PixelShape::Square},
                                                     {"free", PixelShape::Free}},
                                                    "pixels", pixels);
  arguments.request.maxSearchedFrames = maxSearchedFrames;
  arguments.request.maxViews = views;
  arguments.request.maxInstants = instants;
  arguments.request.floorFrame = worldFrame;
  arguments.request.refinesIntrinsics = refineLenses;
  return calibrateWithBoard(handle, arguments, progress);
}

std::vector<std::optional<double>> lensErrors(const BoardOutcome& outcome) {
  std::vector<std::optional<double>> errors;
  for (std::size_t k = 0; outcome.lenses && k < outcome.lenses->cameras.size(); ++k) {
    const auto& camera = outcome.lenses->cameras[k];
    errors.push_back(camera ? std::optional(camera->rmsPx) : std::nullopt);
  }
  return errors;
}

void bindResults(py::module_& module) {
  py::class_<CalibrationImport>(module, "CalibrationImport",
                                "What Project.import_calibration() read.")
      .def_readonly("format", &CalibrationImport::formatTitle, "The name of the format.")
      .def_readonly("decisions", &CalibrationImport::decisions,
                    "The assumptions about units, axes and directions, in sentences.")
      .def_readonly("matched_by_order", &CalibrationImport::wereCamerasMatchedByOrder,
                    "Whether the cameras were matched by order because no names match.")
      .def_readonly("lens_only", &CalibrationImport::hasOnlyIntrinsics,
                    "Whether the file has no poses, so that those of the project are kept.")
      .def_readonly(
          "largest_pixels", &CalibrationImport::maxConversionErrorPx,
          "Largest difference between the cameras of the file and of the project, pixels.");
  py::class_<BoardOutcome>(module, "BoardCalibration", "What Project.calibrate_board() found.")
      .def_property_readonly(
          "lens_rms", lensErrors,
          "Per camera the root mean square distance of the corners, pixels; None "
          "for one that keeps its intrinsics.")
      .def_property_readonly(
          "rms",
          [](const BoardOutcome& outcome) {
            return outcome.extrinsics ? std::optional(outcome.extrinsics->rmsPx) : std::nullopt;
          },
          "The same over all cameras, for their poses, or None.")
      .def_readonly("accuracy", &BoardOutcome::accuracySummary,
                    "How accurate the poses are, in a sentence.")
      .def_property_readonly("remarks", outcomeRemarks, "What else you should know, in sentences.")
      .def_property_readonly("doubtful", isDoubtful,
                             "Whether a fault that has a name explains the images better.")
      .def_readonly("report", &BoardOutcome::report, "A report as one HTML page.");
}

} // namespace

void bindCalibration(py::module_& module, ProjectClass& project) {
  bindResults(module);
  project
      .def(
          "import_calibration", importInto, py::arg("path"), py::kw_only(), py::arg("format") = "",
          py::arg("unit") = py::none(), py::arg("size") = py::none(), py::arg("lens") = py::none(),
          py::arg("poses") = py::none(), py::arg("fit") = py::none(),
          py::arg("names") = CameraRenaming(),
          "Takes the calibration of its cameras from a file of any tool, matched by name, else by "
          "order. What the file does not define is given by format, unit (m, mm, ...), size "
          "(width, "
          "height), lens (pinhole, fisheye) and poses (camera-from-world, world-from-camera). fit: "
          "how the images were changed if they have another size than those of the calibration "
          "(crop, trim, scale, rotate-90, rotate-270). names: the name in the file of each camera "
          "of the project, if they differ.")
      .def("export_calibration", exportTo, py::arg("path"), py::kw_only(), py::arg("format") = "",
           py::arg("unit") = py::none(), py::arg("replace") = false,
           "Writes the calibration of its cameras in the format of a tool; returns the assumptions "
           "that were made, in sentences.")
      .def(
          "calibrate_board", calibrateBoard, py::arg("board"), py::kw_only(),
          py::arg("lenses") = true, py::arg("poses") = true, py::arg("model") = "5",
          py::arg("pixels") = "measured", py::arg("looks") = 300, py::arg("views") = 30,
          py::arg("instants") = 60, py::arg("world_frame") = py::none(),
          py::arg("refine_lenses") = false, py::arg("progress") = py::none(),
          "Calibrates its cameras by a board in their recordings (chessboard:9x6:0.025, "
          "charuco:7x5:0.054:0.040:DICT_4X4_50): lenses, poses or both. The arguments are those of "
          "dewpoint-cli calibrate; progress is called with the part of each stage that is done.");
}

} // namespace dewpoint::app
