// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/project_handle.h"
#include "core/capture/frame_source.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <pybind11/pybind11.h>

namespace dewpoint::app {

/// Camera images of a project, for use from Python. Calls from several threads are executed one
/// after another.
class RecordingHandle {
public:
  explicit RecordingHandle(SessionInputs inputs) : inputs_(std::move(inputs)) {}

  std::optional<std::int64_t> frameCount() const { return inputs_.source->frameCount(); }
  double framesPerSecond() const { return inputs_.source->framesPerSecond(); }
  /// Returns the next frame set that has images; null at the end. Releases the GIL while it waits
  /// for live cameras.
  FrameSetPtr nextFrameSet();
  /// Makes `frame` the frame that nextFrameSet() returns next.
  void seek(std::int64_t frame);
  FrameSetPtr frameSetAt(std::int64_t frame);

private:
  Result<FrameSetPtr> take();

  SessionInputs inputs_;
  std::mutex mutex_;
};

} // namespace dewpoint::app
