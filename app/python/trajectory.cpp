// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/python_error.h"
#include "app/python/trajectory_handle.h"
#include "core/trajectory/evaluation.h"
#include "core/trajectory/trajectory_reader.h"
#include "core/trajectory/trajectory_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

/// One target of a trajectory; keeps the trajectory.
struct TrackHandle {
  std::shared_ptr<TrajectoryHandle> owner;
  std::size_t target = 0;

  const TargetColumns& columns() const { return owner->columns.targets[target]; }
};

/// A column of a track, `width` numbers a row, as an array over it.
template <class T>
py::array_t<T> columnOf(const TrackHandle& track, const std::vector<T>& column,
                        std::vector<py::ssize_t> width = {}) {
  width.insert(width.begin(), static_cast<py::ssize_t>(track.owner->columns.frames.size()));
  return arrayView(column.data(), std::move(width), keepAliveCapsule(track.owner));
}

/// A column of zeros and ones as truth values, over the same memory.
py::object truthsOf(const TrackHandle& track, const std::vector<std::uint8_t>& column) {
  return columnOf(track, column).attr("view")("bool");
}

std::vector<std::string> namesOf(const TrajectoryHandle& handle) {
  std::vector<std::string> names;
  for (const TargetColumns& columns : handle.columns.targets) {
    names.push_back(columns.target);
  }
  return names;
}

TrackHandle trackOf(const std::shared_ptr<TrajectoryHandle>& handle, const py::object& key) {
  return {handle, findTargetIndex(key, namesOf(*handle))};
}

void bindTrack(py::module_& module) {
  py::class_<TrackHandle>(
      module, "Track",
      "One target of a trajectory, a row per frame of the trajectory. Where the "
      "target has no estimate, numbers are NaN. All arrays are read-only.")
      .def_property_readonly(
          "name", [](const TrackHandle& track) { return track.columns().target; }, "Its name.")
      .def_property_readonly(
          "positions",
          [](const TrackHandle& track) { return columnOf(track, track.columns().positions, {3}); },
          "Frames x 3: x, y, z in the world, meters.")
      .def_property_readonly(
          "covariances",
          [](const TrackHandle& track) {
            return columnOf(track, track.columns().covariances, {3, 3});
          },
          "Frames x 3 x 3: of the positions, m².")
      .def_property_readonly(
          "best",
          [](const TrackHandle& track) {
            return columnOf(track, track.columns().bestParticles, {3});
          },
          "Frames x 3: the particle of highest weight, meters.")
      .def_property_readonly(
          "existence",
          [](const TrackHandle& track) {
            return columnOf(track, track.columns().existenceProbabilities);
          },
          "Probability that the target is where the estimate says; 0 when read from a file.")
      .def_property_readonly(
          "effective_sample_size",
          [](const TrackHandle& track) {
            return columnOf(track, track.columns().effectiveSampleSizes);
          },
          "Effective sample size of the particles.")
      .def_property_readonly(
          "cameras",
          [](const TrackHandle& track) { return columnOf(track, track.columns().cameraCounts); },
          "How many cameras show the target.")
      .def_property_readonly(
          "valid",
          [](const TrackHandle& track) { return truthsOf(track, track.columns().validFlags); },
          "Whether the cameras confirm the target.")
      .def_property_readonly(
          "ambiguous",
          [](const TrackHandle& track) { return truthsOf(track, track.columns().ambiguousFlags); },
          "Whether another object may equally well be the target.")
      .def("__repr__", [](const TrackHandle& track) {
        return fmt::format("<dewpoint.Track {}, {} frames>", track.columns().target,
                           track.owner->columns.frames.size());
      });
}

void bindEvaluation(py::module_& module) {
  py::class_<Evaluation>(module, "Evaluation", "A target's estimate against the truth, in meters.")
      .def_readonly("target", &Evaluation::target, "Its name.")
      .def_readonly("rmse", &Evaluation::rmse, "Root mean square error from convergence on.")
      .def_readonly("median", &Evaluation::medianError, "Median error.")
      .def_readonly("p95", &Evaluation::p95, "95 % of the errors are smaller.")
      .def_readonly("max", &Evaluation::maxError, "The largest error.")
      .def_readonly("rmse_all", &Evaluation::rmseOfAllFrames,
                    "Root mean square error of all frames.")
      .def_property_readonly(
          "bias", [](const Evaluation& evaluation) { return toArray(evaluation.bias); },
          "Mean of estimate minus truth.")
      .def_readonly("frames_compared", &Evaluation::comparedFrameCount, "Frames with both.")
      .def_readonly("frames_to_converge", &Evaluation::convergenceFrameCount,
                    "Frames before the estimate stays near the truth, or None.")
      .def_readonly("lost_frames", &Evaluation::lostFrameCount,
                    "Frames after convergence in which the target was lost.")
      .def("__repr__", [](const Evaluation& evaluation) {
        return fmt::format("<dewpoint.Evaluation {}, rmse {:.4g} m>", evaluation.target,
                           evaluation.rmse);
      });
}

std::vector<Evaluation> evaluated(const TrajectoryHandle& estimate, const TrajectoryHandle& truth,
                                  double gate) {
  return valueOrRaise(evaluate(estimate.trajectory, truth.trajectory, gate));
}

} // namespace

std::size_t findTargetIndex(const py::object& key, const std::vector<std::string>& names) {
  if (py::isinstance<py::str>(key)) {
    const auto found = std::ranges::find(names, key.cast<std::string>());
    if (found == names.end()) {
      throw py::key_error(fmt::format("no target is called {}", key.cast<std::string>()));
    }
    return static_cast<std::size_t>(found - names.begin());
  }
  const auto count = static_cast<std::int64_t>(names.size());
  const auto given = key.cast<std::int64_t>();
  const std::int64_t number = given < 0 ? given + count : given;
  if (number < 0 || number >= count) {
    throw py::index_error(fmt::format("target {} was requested, but there are {}", given, count));
  }
  return static_cast<std::size_t>(number);
}

void bindTrajectory(py::module_& module) {
  bindTrack(module);
  bindEvaluation(module);
  py::class_<TrajectoryHandle, std::shared_ptr<TrajectoryHandle>>(
      module, "Trajectory", "Where targets were: trajectory[\"ball\"], or by number.")
      .def_property_readonly("targets", namesOf, "The names of its targets.")
      .def_property_readonly(
          "frames",
          [](const std::shared_ptr<TrajectoryHandle>& handle) {
            const auto& frames = handle->columns.frames;
            return arrayView(frames.data(), {static_cast<py::ssize_t>(frames.size())},
                             keepAliveCapsule(handle));
          },
          "Numbers of the frames; -1 where a file has only times.")
      .def_property_readonly(
          "times",
          [](const std::shared_ptr<TrajectoryHandle>& handle) {
            const auto& times = handle->columns.times;
            return arrayView(times.data(), {static_cast<py::ssize_t>(times.size())},
                             keepAliveCapsule(handle));
          },
          "Seconds, one per frame.")
      .def_property_readonly(
          "header",
          [](const TrajectoryHandle& handle) {
            py::dict header;
            for (const auto& [key, value] : handle.trajectory.header.entries) {
              header[py::str(key)] = value;
            }
            return header;
          },
          "Method, seed, parameters and version, as texts.")
      .def("__len__", [](const TrajectoryHandle& handle) { return handle.columns.targets.size(); })
      .def("__getitem__", trackOf)
      .def("evaluate", evaluated, py::arg("truth"), py::arg("gate") = kDefaultGate,
           "Compares each target with the truth of its name; gate: meters within which it counts "
           "as found.")
      .def(
          "save",
          [](const TrajectoryHandle& handle, const std::filesystem::path& file) {
            valueOrRaise(writeTrajectory(handle.trajectory, file));
          },
          py::arg("file"), "Writes it as CSV, as dewpoint-cli track does.")
      .def("__repr__", [](const TrajectoryHandle& handle) {
        return fmt::format("<dewpoint.Trajectory {} frames, {} targets>",
                           handle.columns.frames.size(), handle.columns.targets.size());
      });
  module.def(
      "read_trajectory",
      [](const std::filesystem::path& file) {
        return std::make_shared<TrajectoryHandle>(valueOrRaise(readTrajectory(file)));
      },
      py::arg("file"), "Reads a trajectory, or a truth, from CSV.");
}

} // namespace dewpoint::app
