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

/// How images are stored that a camera sends uncompressed.
enum class RawStorage {
  Jpeg,     ///< as JPEG of quality 95
  Lossless, ///< as they came, uncompressed: 18 to 28 MB/s for 640 x 480 at 30 images per second
};

/// Files of the recording of one camera.
struct StreamFiles {
  std::filesystem::path video; ///< Matroska (.mkv)
  std::filesystem::path times; ///< table of capture times (.csv)
};

/// What a recording has stored so far.
struct RecordedCounts {
  std::int64_t images = 0;        ///< in the files
  std::int64_t preRollImages = 0; ///< of them, captured before the start of the take
  std::int64_t dropped = 0;       ///< came, but are not in the files
  std::int64_t bytes = 0;         ///< size of the video
  /// Images per second, from the capture times of the first and the last image; 0 before the second
  /// one.
  double framesPerSecond = 0.0;
  TimeOrigin origin = TimeOrigin::Arrival; ///< of the last capture time
  bool isChanged = false; ///< images are stored with other pixels: raw ones as JPEG, for example
  /// Why something is missing, for instance a full disk. What was written before can be read.
  std::optional<Error> problem;
};

/// Records the stream of one camera as it comes: images that are compressed by the camera are
/// stored unchanged, others as RawStorage says. A table beside the video gives the capture time of
/// each image in seconds since the start of the take, in the format of readCaptureTimes().
///
/// Each image and its line are passed to the operating system as soon as they are there, so that a
/// killed program loses the images that wait in memory at most, less than 2 s. If the disk is
/// slower than the camera, images are dropped and counted; the camera never waits.
class StreamRecording {
public:
  using Clock = std::chrono::steady_clock;

  /// Connects to `feed` and begins with its next image (of H.264 and H.265: the next key frame).
  /// The files are created then. Capture times are relative to `zero`; images captured before it
  /// are left out. `field` names the camera in errors. Images of the feed's pre-roll that were
  /// captured between `zero` and `begin`, the start of the take, are written first.
  StreamRecording(EncodedFeedPtr feed, StreamFiles files, RawStorage raw, Clock::time_point zero,
                  std::string field, std::optional<Clock::time_point> begin = std::nullopt);
  StreamRecording(const StreamRecording&) = delete;
  StreamRecording& operator=(const StreamRecording&) = delete;
  /// Stops if that was not done.
  ~StreamRecording();

  /// May be called from any thread.
  RecordedCounts counts() const;
  /// Returns for each image in the video its CaptureInstant::stamp. May be called from any thread.
  std::vector<std::int64_t> stamps() const;
  /// Ends the recording in less than 1 s, and completes the files: with an index of the video, and
  /// a last line in the table. Images that cannot be written in this time are dropped.
  void stop();

private:
  struct Writer;

  EncodedFeedPtr feed_;
  std::shared_ptr<Writer> writer_; ///< shared with the threads of GStreamer
  std::atomic<bool> stopped_ = false;
};

} // namespace dewpoint::capture
