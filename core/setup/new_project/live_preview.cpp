// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/live_preview.h"

#include "core/capture/gstreamer/open_live.h"
#include "core/capture/redacted_location.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace dewpoint::setup {
namespace {

using PreviewSeconds = std::chrono::duration<double>;
using PreviewClock = std::chrono::steady_clock;

/// As wide as the previews of recordings.
constexpr int kThumbnailWidth = 192;
/// How long a source is measured by captureLivePreview(), and how long it may take to begin;
/// seconds. Chosen: streams send their first key frame within a few seconds.
constexpr double kMeasured = 1.0;
constexpr double kPatience = 5.0;

double secondsSince(PreviewClock::time_point begin) {
  return PreviewSeconds(PreviewClock::now() - begin).count();
}

cv::Mat thumbnailOf(const cv::Mat& image) {
  cv::Mat color = image;
  if (image.channels() == 1) {
    cv::cvtColor(image, color, cv::COLOR_GRAY2BGR);
  } else if (image.channels() == 4) {
    cv::cvtColor(image, color, cv::COLOR_BGRA2BGR);
  }
  if (color.cols <= kThumbnailWidth) {
    return color.clone();
  }
  const double scale = static_cast<double>(kThumbnailWidth) / color.cols;
  const int height = std::max(1, static_cast<int>(std::lround(color.rows * scale)));
  cv::Mat small;
  cv::resize(color, small, {kThumbnailWidth, height}, 0.0, 0.0, cv::INTER_AREA);
  return small;
}

/// Images per second, from the capture times where they are known.
class MeasuredRate {
public:
  void add(const LiveStream& stream) {
    const auto captured = stream.captureTime();
    last_ = captured ? captured->time : PreviewClock::now();
    first_ = count_ == 0 ? last_ : first_;
    ++count_;
  }
  double value() const {
    const double seconds = PreviewSeconds(last_ - first_).count();
    return seconds > 0.0 ? (count_ - 1) / seconds : 0.0;
  }

private:
  PreviewClock::time_point first_;
  PreviewClock::time_point last_;
  int count_ = 0;
};

/// The same in a way that can be read: to the nearest whole number where it is near one.
double readableRate(double rate) {
  constexpr double kNear = 0.02;
  const double whole = std::round(rate);
  return whole > 0.0 && std::abs(rate - whole) <= kNear * whole ? whole : rate;
}

tl::unexpected<Error> noPreview(ErrorCode code, const LiveCamera& camera, std::string reason) {
  return failure(code, redactedLocation(camera.location), "", std::move(reason));
}

} // namespace

Status previewLive(const LiveCamera& camera, double interval, const PreviewReceiver& receive) {
  return previewLive(camera, interval, receive,
                     [](const LiveCamera& wanted) { return makeLiveStream(wanted, nullptr); });
}

Status previewLive(const LiveCamera& camera, double interval, const PreviewReceiver& receive,
                   const LiveStreamFactory& factory) {
  if (auto good = checkLocation(camera); !good) {
    return good;
  }
  const LiveStreamPtr stream = factory(camera);
  if (auto opened = stream->open(); !opened) {
    return noPreview(ErrorCode::DeviceUnavailable, camera, opened.error());
  }
  MeasuredRate rate;
  cv::Size size;
  double due = 0.0; // the first one at once
  const auto begin = PreviewClock::now();
  while (stream->grab()) {
    rate.add(*stream);
    const double now = secondsSince(begin);
    if (now < due) {
      continue;
    }
    due = now + interval;
    const cv::Mat image = stream->retrieve();
    if (image.empty()) {
      due = 0.0;
    } else {
      size = image.size();
    }
    if (!receive({image.empty() ? cv::Mat() : thumbnailOf(image), size, rate.value()})) {
      return {};
    }
  }
  return stream->hasEnded() ? Status()
                            : noPreview(ErrorCode::ConnectionLost, camera, stream->lostReason());
}

Result<LivePreview> captureLivePreview(const std::string& location,
                                       const std::function<bool()>& goesOn) {
  LiveCamera camera;
  camera.location = location;
  LivePreview first;
  bool isCanceled = false;
  const auto begin = PreviewClock::now();
  std::optional<PreviewClock::time_point> firstAt;
  const auto watched = previewLive(camera, 0.0, [&](const LivePreview& preview) {
    isCanceled = !goesOn();
    if (!firstAt && !preview.image.empty()) {
      firstAt = PreviewClock::now();
      first = preview;
    }
    first.framesPerSecond = readableRate(preview.framesPerSecond);
    return !isCanceled &&
           (firstAt ? secondsSince(*firstAt) < kMeasured : secondsSince(begin) < kPatience);
  });
  if (isCanceled || !goesOn()) {
    return noPreview(ErrorCode::Canceled, camera, "");
  }
  if (firstAt) {
    return first; // whatever came afterwards
  }
  return watched ? noPreview(ErrorCode::DeviceUnavailable, camera, "no image has arrived")
                 : tl::make_unexpected(watched.error());
}

} // namespace dewpoint::setup
