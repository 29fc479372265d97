// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/recording.h"

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/python_error.h"
#include "core/session/run/frame_loop.h"

#include <fmt/format.h>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace dewpoint::app {
namespace {

py::list imagesOf(const FrameSet& set) {
  py::list images;
  for (const FramePtr& frame : set.frames) {
    images.append(frame ? toArray(frame->image) : py::object(py::none()));
  }
  return images;
}

/// The number of a frame as Python counts, from the end where it is negative.
std::int64_t frameNumber(const RecordingHandle& recording, std::int64_t frame) {
  const auto count = recording.frameCount();
  const std::int64_t number = frame < 0 ? frame + count.value_or(0) : frame;
  if (number < 0 || (count && number >= *count)) {
    throw py::index_error(
        fmt::format("frame {} was requested, but there are {}", frame, count.value_or(0)));
  }
  return number;
}

void bindFrameSet(py::module_& module) {
  py::class_<FrameSet, std::shared_ptr<FrameSet>>(module, "Frames",
                                                  "The images that all cameras took at one time.")
      .def_readonly("index", &FrameSet::index, "Frame number, counted from 0.")
      .def_property_readonly(
          "time", [](const FrameSet& set) { return seconds(set.time); },
          "Seconds since the first frame.")
      .def_property_readonly("images", imagesOf,
                             "One array per camera (height x width x 3, uint8, blue green red), "
                             "None where it has none. Read-only and not copied.")
      .def("__repr__", [](const FrameSet& set) {
        return fmt::format("<dewpoint.Frames {} at {} s>", set.index, seconds(set.time));
      });
}

/// pybind11 holds no pointers to const; nothing that is bound writes.
std::shared_ptr<FrameSet> held(const FrameSetPtr& set) {
  return std::const_pointer_cast<FrameSet>(set);
}

} // namespace

Result<FrameSetPtr> RecordingHandle::take() {
  const py::gil_scoped_release release;
  const std::lock_guard lock(mutex_);
  return inputs_.source->next();
}

FrameSetPtr RecordingHandle::nextFrameSet() {
  while (true) {
    if (PyErr_CheckSignals() != 0) {
      throw py::error_already_set();
    }
    FrameSetPtr set = valueOrRaise(take());
    if (!set || hasImages(*set)) {
      return set;
    }
  }
}

void RecordingHandle::seek(std::int64_t frame) {
  const auto sought = [&] {
    const py::gil_scoped_release release;
    const std::lock_guard lock(mutex_);
    return inputs_.source->seek(frame);
  }();
  valueOrRaise(sought);
}

FrameSetPtr RecordingHandle::frameSetAt(std::int64_t frame) {
  seek(frame);
  return nextFrameSet();
}

void bindRecording(py::module_& module) {
  bindFrameSet(module);
  py::class_<RecordingHandle, std::shared_ptr<RecordingHandle>>(
      module, "Recording",
      "The images of a project's cameras, frame by frame: iterate over it, or get one by its "
      "number.")
      .def_property_readonly("frame_count", &RecordingHandle::frameCount,
                             "Number of frames; None for live cameras.")
      .def_property_readonly("frames_per_second", &RecordingHandle::framesPerSecond,
                             "Frames per second of the recording.")
      .def("__len__",
           [](const RecordingHandle& recording) {
             const auto count = recording.frameCount();
             if (!count) {
               throw py::type_error("live cameras have no number of frames");
             }
             return *count;
           })
      .def("__getitem__",
           [](RecordingHandle& recording, std::int64_t frame) {
             const FrameSetPtr set = recording.frameSetAt(frameNumber(recording, frame));
             if (!set) {
               throw py::index_error("there is no such frame");
             }
             return held(set);
           })
      .def("__iter__",
           [](const std::shared_ptr<RecordingHandle>& recording) {
             recording->seek(0);
             return recording;
           })
      .def("__next__", [](RecordingHandle& recording) {
        const FrameSetPtr set = recording.nextFrameSet();
        if (!set) {
          throw py::stop_iteration();
        }
        return held(set);
      });
}

} // namespace dewpoint::app
