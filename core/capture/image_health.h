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

/// What is wrong with the images of a camera, found with a code (`phrase()` of it says what) and
/// the numbers or the advice that belong to it.
struct ImageFault {
  ErrorCode code = ErrorCode::ImagesBlack;
  std::string detail;
};

/// Judges the images of one live camera by their last second: whether they are black, do not
/// change, repeat earlier ones, arrive late, or are fewer than before. A fault is found within a
/// second after it began, if the camera sends at least four images per second. The images are used
/// all the same. Not thread safe.
class ImageHealth {
public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::milliseconds kWindow{1000}; ///< images that are looked at
  /// How long images have to be black, identical or late to be reported. Chosen: a wink of a camera
  /// is no fault, and there is time left to report it within a second.
  static constexpr std::chrono::milliseconds kPatience{700};
  /// Brightness (largest channel) up to which a pixel is black, and the fraction of pixels that may
  /// be brighter in a black image. Chosen: noise of a covered camera, and a few defective pixels.
  static constexpr int kBlackLevel = 24;
  static constexpr double kBrightShare = 0.002;
  /// Fraction of the images of a window that were sent before, from which on they repeat. A
  /// judgment: a camera that sends every image twice repeats half of them.
  static constexpr double kRepeatedShare = 0.3;
  /// Age of images at their arrival, beyond the camera's delay, from which on they are late.
  static constexpr std::chrono::milliseconds kLateness{500};
  /// Fraction of its rate below which a camera is slow. A judgment: half the rate, as cameras
  /// choose in poor light, is; a few lost images are not.
  static constexpr double kSlowShare = 0.6;

  /// `requestedRate`: images per second that were requested from the camera; 0: none, then its own
  /// highest rate of two seconds counts. `delay`: how late the images of the camera may be,
  /// seconds.
  explicit ImageHealth(double requestedRate = 0.0, double delay = 0.0);

  /// Forgets the images, because the camera is opened again. Its rate stays known.
  void restart(Clock::time_point now);
  /// Adds an image (CV_8UC3) that arrived at `arrived` and was captured at `captured`, if that is
  /// known.
  void add(const cv::Mat& image, Clock::time_point arrived,
           std::optional<Clock::time_point> captured);
  /// Returns the most serious fault at `now`, or nothing. A camera that sends no images at all has
  /// none: see LiveCameraThread::problem().
  std::optional<ImageFault> fault(Clock::time_point now) const;

private:
  /// What is kept of an image.
  struct Seen {
    Clock::time_point arrived{};
    std::uint64_t content = 0; ///< hash of some of its rows
    bool isRepeated = false;   ///< see isRepeat()
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
  std::int64_t imagesOfPeriod_ = 0; ///< since periodBegin_
  Clock::time_point periodBegin_{};
  Clock::time_point begun_{}; ///< when the camera began to send, or went on after a silence
  std::deque<Seen> seen_;     ///< of the last window
  // When the present run of such images began; empty if the last one was not like that.
  std::optional<Clock::time_point> blackSince_;
  std::optional<Clock::time_point> sameSince_;
  std::optional<Clock::time_point> lateSince_;
};

/// Returns whether a notice with this code is about images that are used all the same.
bool isImageFault(ErrorCode code);

} // namespace dewpoint::capture
