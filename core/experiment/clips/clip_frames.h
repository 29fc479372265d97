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

/// One instant of a recording: which frame of each camera, and when it was taken.
struct ClipInstant {
  double time = 0.0;                ///< seconds; of the instant, on the recording's own clock
  std::vector<std::int64_t> frames; ///< per camera, counted from 0 in its file
  std::vector<double> times;        ///< per camera, seconds on the same clock
};

/// The instants at which all cameras take frame k together, for k from `first` to `end` - 1, at
/// k / `framesPerSecond` seconds.
std::vector<ClipInstant> evenInstants(std::int64_t first, std::int64_t end, std::size_t cameras,
                                      double framesPerSecond);

/// The images of a recording, instant by instant. Fast when the instants rise one by one. Used by
/// one thread at a time.
class ClipFrames {
public:
  /// `cameras`: a video, or a folder of images, per camera. FileMissing or FileUnreadable;
  /// EndedEarly when a file has fewer frames than the instants need.
  static Result<std::shared_ptr<ClipFrames>> open(const std::vector<std::filesystem::path>& cameras,
                                                  std::vector<ClipInstant> instants);

  std::int64_t count() const { return static_cast<std::int64_t>(instants_.size()); }
  /// The frames of an instant, times counted from the first instant. A frame that cannot be read is
  /// missing (null), as that of a camera that did not deliver.
  FrameSetPtr at(std::int64_t instant);

private:
  ClipFrames() = default;

  std::vector<PictureReaderPtr> readers_;
  std::vector<ClipInstant> instants_;
};

} // namespace dewpoint::experiment
