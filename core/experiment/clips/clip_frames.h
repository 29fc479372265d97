// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"
#include "core/capture/picture_reader.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace dewpoint::experiment {

/// One instant of a recording: the frame of each camera, and its time.
struct ClipInstant {
  double time = 0.0;                ///< seconds on the recording's own clock
  std::vector<std::int64_t> frames; ///< one per camera, counted from 0 in its file
  std::vector<double> times;        ///< one per camera, seconds on the same clock
};

/// Instants at which all cameras take frame k together, for k from `first` to `end` - 1, at k /
/// `framesPerSecond` seconds.
std::vector<ClipInstant> evenInstants(std::int64_t first, std::int64_t end, std::size_t cameras,
                                      double framesPerSecond);

/// Images of a recording, by instant. Fast if instants are read in ascending order. For one thread
/// at a time.
class ClipFrames {
public:
  /// Opens a video, or a folder of images, per camera. FileMissing or FileUnreadable; EndedEarly if
  /// a file has fewer frames than the instants need.
  static Result<std::shared_ptr<ClipFrames>> open(const std::vector<std::filesystem::path>& cameras,
                                                  std::vector<ClipInstant> instants);

  std::int64_t count() const { return static_cast<std::int64_t>(instants_.size()); }
  /// Frames of an instant; times are counted from the first instant. A frame that cannot be read is
  /// missing (null), like a frame that a camera did not deliver.
  FrameSetPtr at(std::int64_t instant);

private:
  ClipFrames() = default;

  std::vector<PictureReaderPtr> readers_;
  std::vector<ClipInstant> instants_;
};

} // namespace dewpoint::experiment
