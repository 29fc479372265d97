// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/capture_instant.h"
#include "core/capture/gstreamer/encoded_feed.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Storage of images that a camera sends uncompressed.
enum class RawStorage {
  Jpeg,     ///< JPEG of quality 95
  Lossless, ///< uncompressed: 18 to 28 MB/s for 640 x 480 pixels at 30 images per second
};

/// Files of the recording of one camera.
struct StreamFiles {
  std::filesystem::path videoFile; ///< video file in Matroska format (.mkv)
  std::filesystem::path timesFile; ///< file with the table of capture times (.csv)
};

/// Progress of a recording.
struct RecordedCounts {
  std::int64_t imageCount = 0; ///< number of images in the files
  /// Number of these images that were captured before the start of the recording.
  std::int64_t preRollImageCount = 0;
  std::int64_t droppedImageCount =
      0;                      ///< number of images that were received, but are not in the files
  std::int64_t byteCount = 0; ///< size of the video file
  /// Images per second, computed from the capture times of the first and the last image; 0 before
  /// the second image.
  double framesPerSecond = 0.0;
  /// Source of the latest capture time: driver, sender or arrival.
  TimeOrigin origin = TimeOrigin::Arrival;
  /// True if the stored pixels differ from the received ones, for example because of
  /// RawStorage::Jpeg.
  bool hasChangedPixels = false;
  /// Reason why images are missing, for example a full disk. Images that were written before can be
  /// read.
  std::optional<Error> problem;
};

/// Records the stream of one camera. Images that the camera compresses are stored unchanged;
/// RawStorage determines how uncompressed images are stored. A table next to the video contains the
/// capture time of each image in seconds since `zero` (see the constructor), in the format of
/// readCaptureTimes().
///
/// Images and lines of the table are passed to the operating system immediately. If the program is
/// killed, at most the last 2 s of images are lost. If the disk is slower than the camera, images
/// are dropped and counted; the camera never waits.
class StreamRecording {
public:
  using Clock = std::chrono::steady_clock;

  /// Starts recording the images of `feed`. Images captured before `zero` are left out. Later
  /// images of the feed's pre-roll are written first. `begin` is the start of the recording;
  /// earlier images count as RecordedCounts::preRollImageCount. Without `begin`, the recording
  /// starts at `zero`. The files are created with the first image, which for H.264 and H.265 is a
  /// key frame. Capture times are relative to `zero`. `field` names the camera in errors.
  StreamRecording(EncodedFeedPtr feed, StreamFiles files, RawStorage raw, Clock::time_point zero,
                  std::string field, std::optional<Clock::time_point> begin = std::nullopt);
  StreamRecording(const StreamRecording&) = delete;
  StreamRecording& operator=(const StreamRecording&) = delete;
  /// Ends the recording and completes its files (stop()).
  ~StreamRecording();

  /// Returns the progress of the recording. Thread-safe.
  RecordedCounts counts() const;
  /// Returns, for each image in the video, the number that identified it in the live stream
  /// (CaptureInstant::imageId). Thread-safe.
  std::vector<std::int64_t> imageStamps() const;
  /// Ends the recording in less than 1 s, and completes the files: writes the index of the video
  /// and the last line of the table. Images that cannot be written in this time are dropped.
  void stop();

private:
  struct Writer;

  EncodedFeedPtr feed_;
  std::shared_ptr<Writer> writer_; ///< shared with the threads of GStreamer
  std::atomic<bool> stopped_ = false;
};

} // namespace dewpoint::capture
