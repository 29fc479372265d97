// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"
#include "core/capture/frame_reader.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace dewpoint::experiment {

/// One instant of a recording: its time and the frame of each camera.
struct ClipInstant {
  double time = 0.0;                ///< seconds, on the recording's own clock
  std::vector<std::int64_t> frames; ///< frame index in each camera's file, counted from 0
  std::vector<double> times;        ///< time of each camera's frame, seconds on the same clock
};

/// Returns instants at which all cameras take frame k simultaneously, at k / `framesPerSecond`
/// seconds, for k from `first` to `end` - 1.
std::vector<ClipInstant> simultaneousInstants(std::int64_t first, std::int64_t end,
                                              std::size_t cameras, double framesPerSecond);

/// Reads the images of a recording, one ClipInstant at a time. Reading is fastest in ascending
/// order. Only one thread may use an object at a time.
class ClipFrames {
public:
  /// Opens a video or an image folder for each camera. Errors: FileMissing, FileUnreadable, or
  /// EndedEarly if a file has fewer frames than the instants need.
  static Result<std::shared_ptr<ClipFrames>> open(const std::vector<std::filesystem::path>& cameras,
                                                  std::vector<ClipInstant> instants);

  std::int64_t instantCount() const { return static_cast<std::int64_t>(instants_.size()); }
  /// Returns the frames of the instant with this index, with times relative to the first instant. A
  /// frame that cannot be read is null, like a frame that a camera did not deliver.
  FrameSetPtr at(std::int64_t instant);

private:
  ClipFrames() = default;

  std::vector<FrameReaderPtr> readers_;
  std::vector<ClipInstant> instants_;
};

} // namespace dewpoint::experiment
