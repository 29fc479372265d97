// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/project_handle.h"
#include "app/python/python_error.h"
#include "app/python/trajectory_handle.h"
#include "app/wiring/open_project.h"
#include "core/session/run/frame_feed.h"

#include <fmt/format.h>

#include <memory>
#include <mutex>
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <vector>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

/// A FrameFeed as Python holds it. Threads take turns; what waits or ends does so without the GIL,
/// which the last image of an array takes.
struct TrackerHandle {
  explicit TrackerHandle(FrameFeed from) : feed(std::move(from)) {}
  TrackerHandle(const TrackerHandle&) = delete;
  TrackerHandle& operator=(const TrackerHandle&) = delete;
  // Releasing the lock throws only without an interpreter, and then there is no handle either.
  ~TrackerHandle() { // NOLINT(bugprone-exception-escape)
    const py::gil_scoped_release release;
    feed.reset();
  }

  std::optional<FrameFeed> feed;
  std::mutex mutex;
};

/// What is believed of one target after a step: one or the other.
struct Estimate {
  std::string target;
  std::optional<TrajectorySample> sample;
  std::optional<BoxSample> box;
};

std::vector<std::string> targetNames(const FrameFeed& feed) {
  std::vector<std::string> names;
  for (const Target& target : feed.run().targets()) {
    names.push_back(target.name);
  }
  return names;
}

std::vector<Estimate> estimatesOfFeed(const FrameFeed& feed) {
  std::vector<Estimate> estimates;
  for (TrajectorySample& sample : feed.samples()) {
    const std::string name = sample.target;
    estimates.push_back({name, std::move(sample), std::nullopt});
  }
  const auto names = targetNames(feed);
  for (const BoxSample& box : feed.boxSamples()) {
    const std::string& name = names.at(static_cast<std::size_t>(box.target - 1));
    estimates.push_back({name, std::nullopt, box});
  }
  return estimates;
}

std::unique_ptr<TrackerHandle> makeTrackerOf(const ProjectHandle& handle, int threads) {
  if (threads < 1 || threads > 256) {
    raiseBadValue("threads", fmt::format("1 to 256 are expected, not {}", threads));
  }
  auto feed = completedProject(handle.project).and_then([&](const Project& project) {
    return FrameFeed::create(project, threads);
  });
  if (!feed) {
    raiseProjectError(handle, feed.error());
  }
  return std::make_unique<TrackerHandle>(std::move(*feed));
}

std::vector<Estimate> step(TrackerHandle& handle, const std::vector<py::object>& arrays,
                           double time, const std::string& order, bool copy) {
  std::vector<cv::Mat> images;
  images.reserve(arrays.size());
  for (const py::object& array : arrays) {
    images.push_back(toImage(array, order, copy));
  }
  Status tracked;
  std::vector<Estimate> estimates;
  {
    const py::gil_scoped_release release;
    const std::lock_guard lock(handle.mutex);
    tracked = handle.feed->step(images, time);
    estimates = estimatesOfFeed(*handle.feed);
    images.clear();
  }
  valueOrRaise(tracked);
  return estimates;
}

py::tuple particlesOfTracker(TrackerHandle& handle, const py::object& target, int limit) {
  if (limit < 1) {
    raiseBadValue("limit", fmt::format("1 or more are expected, not {}", limit));
  }
  std::vector<std::string> names;
  {
    const py::gil_scoped_release release;
    const std::lock_guard lock(handle.mutex);
    names = targetNames(*handle.feed);
  }
  const std::size_t number = findTargetIndex(target, names);
  ParticleSample particles;
  {
    const py::gil_scoped_release release;
    const std::lock_guard lock(handle.mutex);
    particles = particlesOf(handle.feed->run(), number, limit);
  }
  return toArrays(std::move(particles));
}

/// A part of the estimate in the room; None of a box.
template <class Part> auto ofSample(Part part) {
  return [part](const Estimate& estimate) {
    using Value = decltype(part(*estimate.sample));
    return estimate.sample ? std::optional<Value>(part(*estimate.sample)) : std::nullopt;
  };
}

py::object bestOf(const Estimate& estimate) {
  return estimate.sample && estimate.sample->bestParticle
             ? py::object(toArray(*estimate.sample->bestParticle))
             : py::object(py::none());
}

py::object boxOfEstimate(const Estimate& estimate) {
  if (!estimate.box) {
    return py::none();
  }
  const ImageBox& box = estimate.box->estimate.box;
  return py::make_tuple(box.x, box.y, box.width, box.height);
}

void bindEstimate(py::module_& module) {
  using Sample = TrajectorySample;
  py::class_<Estimate>(module, "Estimate",
                       "The estimate of a target after a step: a position in the room, or a box in "
                       "an image; what does not apply is None.")
      .def_readonly("target", &Estimate::target, "The name of the target.")
      .def_property_readonly("position",
                             ofSample([](const Sample& s) { return toArray(s.position); }),
                             "x, y, z in the world, meters.")
      .def_property_readonly("covariance",
                             ofSample([](const Sample& s) { return toArray(s.covariance); }),
                             "3 x 3, of the position, m².")
      .def_property_readonly("best", bestOf, "The particle of highest weight, meters.")
      .def_property_readonly("existence",
                             ofSample([](const Sample& s) { return s.existenceProbability; }),
                             "Probability that the target is where the estimate says.")
      .def_property_readonly(
          "valid",
          [](const Estimate& estimate) {
            return estimate.sample ? estimate.sample->isValid : estimate.box->estimate.isVisible;
          },
          "Whether the cameras confirm the target.")
      .def_property_readonly("ambiguous", ofSample([](const Sample& s) { return s.isAmbiguous; }),
                             "Whether another object may equally well be the target.")
      .def_property_readonly("cameras", ofSample([](const Sample& s) { return s.cameraCount; }),
                             "How many cameras show the target.")
      .def_property_readonly("effective_sample_size",
                             ofSample([](const Sample& s) { return s.effectiveSampleSize; }),
                             "Effective sample size of the particles.")
      .def_property_readonly("box", boxOfEstimate, "x, y, width, height in pixels.")
      .def_property_readonly(
          "similarity",
          [](const Estimate& estimate) {
            return estimate.box ? std::optional(estimate.box->estimate.similarity) : std::nullopt;
          },
          "Similarity of the colors in the box to those in the first box, 0 to 1.")
      .def("__repr__", [](const Estimate& estimate) {
        return fmt::format("<dewpoint.Estimate {}>", estimate.target);
      });
}

} // namespace

void bindTracker(py::module_& module) {
  bindEstimate(module);
  py::class_<TrackerHandle>(module, "Tracker",
                            "Tracks the images of a program that reads its cameras itself.")
      .def(
          py::init(&makeTrackerOf), py::arg("project"), py::kw_only(), py::arg("threads") = 1,
          "For the cameras, targets and parameters that a project has now; its own sources are not "
          "read. threads never change the result.")
      .def("step", step, py::arg("images"), py::arg("time"), py::kw_only(),
           py::arg("order") = "bgr", py::arg("copy") = false,
           "Tracks one instant and returns an Estimate for each target. images: one array per "
           "camera "
           "(height x width x 3, uint8), None where there is none; time: seconds, later than "
           "before; "
           "order of the channels: bgr (as OpenCV), or rgb, which is converted. The arrays are not "
           "copied, and kept for a while: with copy=False nobody may change them any more.")
      .def("particles", particlesOfTracker, py::arg("target") = 0, py::arg("limit") = 1000000,
           "Particles of a target now, at most limit: positions (N x 3, meters), weights (N).")
      .def(
          "restart",
          [](TrackerHandle& handle) {
            const py::gil_scoped_release release;
            const std::lock_guard lock(handle.mutex);
            handle.feed->restart();
          },
          "Forgets everything; the time may begin again.")
      .def_property_readonly(
          "targets",
          [](TrackerHandle& handle) {
            const py::gil_scoped_release release;
            const std::lock_guard lock(handle.mutex);
            return targetNames(*handle.feed);
          },
          "The names of the targets.")
      .def_property_readonly(
          "steps",
          [](TrackerHandle& handle) {
            const py::gil_scoped_release release;
            const std::lock_guard lock(handle.mutex);
            return handle.feed->stepCount();
          },
          "Steps since the (re)start.");
}

} // namespace dewpoint::app
