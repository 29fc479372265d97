// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <chrono>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace dewpoint::capture {

/// Fault of a camera's images, for example that they are black. `code` identifies the fault
/// (errorPhrase() returns its text); `detail` adds numbers or advice.
struct ImageFault {
  ErrorCode code = ErrorCode::ImagesBlack;
  std::string detail;
};

/// Assesses the images of one live camera in the last second: whether they are black, do not
/// change, repeat earlier ones, arrive late, or are fewer than expected. A fault is found within a
/// second after it began, if the camera sends at least four images per second. Images with a fault
/// are still used. Not thread-safe.
class ImageHealth {
public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds kObservationPeriod{
      1000}; ///< period whose images are assessed
  /// Time for which images must be black, identical or late to count as a fault. Chosen so that a
  /// short disturbance does not count, but a fault is reported within a second.
  static constexpr std::chrono::milliseconds kMinFaultDuration{700};
  /// A pixel is black if its largest channel is at most this gray level. Chosen to allow for the
  /// noise of a covered camera.
  static constexpr int kBlackLevel = 24;
  /// An image is black if at most this fraction of its pixels is not black. Chosen to allow for a
  /// few defective pixels.
  static constexpr double kMaxBrightShareOfBlackImage = 0.002;
  /// A camera repeats images if at least this fraction of the images in the last second
  /// (kObservationPeriod) repeats an earlier image. Chosen by judgment: a camera that sends every
  /// image twice repeats half of them.
  static constexpr double kMinRepeatedShare = 0.3;
  /// An image is late if more than this time plus the camera's delay passes between its capture and
  /// its arrival.
  static constexpr std::chrono::milliseconds kMaxLatency{500};
  /// A camera is slow if its rate is below this fraction of the expected rate. Chosen by judgment:
  /// cameras that halve their rate in poor light are slow, but a few lost images do not matter.
  static constexpr double kMinRateShare = 0.6;

  /// Creates the assessment for one camera. `requestedRate`: images per second that were requested
  /// from the camera. If it is 0, the expected rate is the highest rate that the camera has had
  /// over two seconds. `delay`: delay of the camera, seconds (LiveCamera::delaySeconds).
  explicit ImageHealth(double requestedRate = 0.0, double delay = 0.0);

  /// Forgets all images, but not the highest frame rate that the camera has had. Call this when the
  /// camera is opened again.
  void restart(Clock::time_point now);
  /// Adds an image (CV_8UC3) that arrived at `arrived` and was captured at `captured`, if that is
  /// known.
  void add(const cv::Mat& image, Clock::time_point arrived,
           std::optional<Clock::time_point> captured);
  /// Returns the most serious fault at `now`, or nothing if there is none. A camera that sends no
  /// images at all is not reported here; see LiveCameraThread::problem().
  std::optional<ImageFault> fault(Clock::time_point now) const;

private:
  /// Data that are kept of an image.
  struct Seen {
    Clock::time_point arrivalTime{};
    std::uint64_t contentHash = 0; ///< hash of some of its rows
    bool isRepeated = false;       ///< see isRepeat()
  };

  void learnRate(Clock::time_point now);
  double expectedRate() const { return requestedRate_ > 0.0 ? requestedRate_ : bestRate_; }
  bool isRepeat(std::uint64_t content) const;
  bool isLongAgo(const std::optional<Clock::time_point>& since) const;
  bool isSlow(Clock::time_point now) const;
  bool isRepeating() const;

  double requestedRate_;
  Clock::duration delay_;
  double bestRate_ = 0.0;
  std::int64_t imagesOfPeriod_ = 0; ///< number of images since periodBegin_
  Clock::time_point periodBegin_{};
  /// Time at which the camera was opened, or sent images again after a pause.
  Clock::time_point begun_{};
  std::deque<Seen> seen_; ///< images in the window
  // Since when all images have been black, identical or late; empty if the last one was not.
  std::optional<Clock::time_point> blackSince_;
  std::optional<Clock::time_point> sameSince_;
  std::optional<Clock::time_point> lateSince_;
};

/// Returns whether an error code stands for a fault of a camera's images (ImageFault). Images with
/// such a fault are still used.
bool isImageFault(ErrorCode code);

} // namespace dewpoint::capture
