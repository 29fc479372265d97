// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"
#include "app/python/project_handle.h"
#include "app/python/python_error.h"
#include "app/python/python_progress.h"
#include "app/python/trajectory_handle.h"
#include "core/project/project_check.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

/// The first frame, and the one behind the last; None: as far as there are any.
using Frames = std::pair<std::int64_t, std::optional<std::int64_t>>;

FrameRange rangeFrom(const std::optional<Frames>& frames) {
  if (!frames) {
    return {};
  }
  const auto& [first, end] = *frames;
  if (first < 0 || (end && *end <= first)) {
    raiseBadValue("frames", "(first, end) is expected, from 0 on, the end greater or None");
  }
  return {first, end};
}

std::shared_ptr<RunHandle> track(const ProjectHandle& handle, const std::optional<Frames>& frames,
                                 const py::object& callback, int threads, int particles) {
  if (threads < 1 || threads > 256) {
    raiseBadValue("threads", fmt::format("1 to 256 are expected, not {}", threads));
  }
  if (particles < 0) {
    raiseBadValue("particles", fmt::format("0 or more are expected, not {}", particles));
  }
  const RecordRunOptions order{rangeFrom(frames), threads, particles};
  if (const auto good = checkMethodTargets(handle.project); !good) {
    raiseProjectError(handle, good.error()); // before anything is opened
  }
  SessionInputs inputs = openProjectInputs(handle);
  PythonProgress progress(callback);
  auto run = [&] {
    const py::gil_scoped_release release;
    return recordRun(inputs.project, *inputs.source, inputs.backgroundImages, order,
                     [&](std::int64_t done, const std::optional<std::int64_t>& total) {
                       return progress.call(done, total);
                     });
  }();
  progress.rethrow();
  if (!run) {
    raiseProjectError(handle, run.error());
  }
  const std::optional<Error> broken = run->endError;
  auto result = std::make_shared<RunHandle>(std::move(*run));
  if (broken) {
    const py::object error = pythonError(*broken);
    error.attr("result") = py::cast(result);
    raise(error);
  }
  return result;
}

py::tuple particlesOfRun(const RunHandle& handle, const py::object& target, std::int64_t frame) {
  const std::size_t number = findTargetIndex(target, handle.run.targetNames);
  const auto found = handle.run.particles.find({frame, number});
  if (found == handle.run.particles.end()) {
    throw py::key_error(fmt::format(
        "no particles were kept of frame {}; track(particles=500) keeps up to 500", frame));
  }
  return toArrays(found->second);
}

/// The rows of one target as arrays: frames, times, boxes (x, y, width, height), similarities.
py::dict boxesOfRun(const RunHandle& handle, const py::object& target) {
  const auto number = static_cast<int>(findTargetIndex(target, handle.run.targetNames)) + 1;
  std::vector<std::int64_t> frames;
  std::vector<double> times;
  std::vector<std::array<double, 4>> boxes;
  std::vector<double> similarities;
  for (const BoxSample& sample : handle.run.boxTrack.samples) {
    if (sample.target == number) {
      const ImageBox& box = sample.estimate.box;
      frames.push_back(sample.frame);
      times.push_back(sample.time);
      boxes.push_back({box.x, box.y, box.width, box.height});
      similarities.push_back(sample.estimate.similarity);
    }
  }
  py::dict columns;
  columns["frames"] =
      py::array_t<std::int64_t>(static_cast<py::ssize_t>(frames.size()), frames.data());
  columns["times"] = py::array_t<double>(static_cast<py::ssize_t>(times.size()), times.data());
  columns["boxes"] =
      py::array_t<double>({static_cast<py::ssize_t>(boxes.size()), static_cast<py::ssize_t>(4)},
                          boxes.empty() ? nullptr : boxes.front().data());
  columns["similarity"] =
      py::array_t<double>(static_cast<py::ssize_t>(similarities.size()), similarities.data());
  return columns;
}

} // namespace

void bindTracking(py::module_& module, ProjectClass& project) {
  py::class_<RunHandle, TrajectoryHandle, std::shared_ptr<RunHandle>>(
      module, "Run", "What Project.track() found: a trajectory, and how the run went.")
      .def_property_readonly(
          "finished", [](const RunHandle& handle) { return handle.run.isFinished; },
          "False when progress ended it before its last frame.")
      .def_property_readonly(
          "frame_count", [](const RunHandle& handle) { return handle.run.frameCount; },
          "Frames that were tracked.")
      .def_property_readonly(
          "notices", [](const RunHandle& handle) { return handle.run.notices; },
          "Sentences about the recording and its cameras.")
      .def("particles", particlesOfRun, py::arg("target"), py::arg("frame"),
           "Particles of a target in a frame: positions (N x 3, meters) and their weights (N). "
           "They are kept if track() is called with their number.")
      .def("boxes", boxesOfRun, py::arg("target"),
           "For methods that follow boxes: arrays frames, times, boxes (N x 4: x, y, width, height "
           "in pixels) and similarity of a target.")
      .def("__repr__", [](const RunHandle& handle) {
        return fmt::format("<dewpoint.Run {} frames{}>", handle.run.frameCount,
                           handle.run.isFinished ? "" : ", not finished");
      });
  project.def("track", track, py::kw_only(), py::arg("frames") = py::none(),
              py::arg("progress") = py::none(), py::arg("threads") = 1, py::arg("particles") = 0,
              "Tracks its recording; the same bits as dewpoint-cli track. frames: (first, end), "
              "without the end; progress: called as progress(done, total) before each frame, False "
              "ends the run and keeps what was found; threads never change the result; particles: "
              "how many to keep of each target in each frame.");
}

} // namespace dewpoint::app
