// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_schedule.h"

#include "core/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace dewpoint::capture {
namespace {

/// Times are written with a microsecond or so.
constexpr double kTimeRounding = 1e-5;

} // namespace

CaptureSchedule::CaptureSchedule(std::vector<CameraImages> cameras, double rate)
    : cameras_(std::move(cameras)), rate_(rate) {
  if (!hasTimes()) {
    count_ = frameSetCountOf(*std::ranges::min_element(cameras_, {}, frameSetCountOf));
    return;
  }
  double end = std::numeric_limits<double>::infinity();
  origin_ = -end;
  for (const CameraImages& camera : cameras_) {
    origin_ = std::max(origin_, camera.times->front() - camera.delay);
    end = std::min(end, camera.times->back() - camera.delay);
  }
  const double frames = (end - origin_ + kTimeRounding) * rate_;
  count_ = frames < 0.0 ? 0 : static_cast<std::int64_t>(std::floor(frames)) + 1;
}

std::optional<CaptureSchedule::ScheduledImage> CaptureSchedule::imageAt(std::size_t camera,
                                                                        std::int64_t frame) const {
  const CameraImages& pictures = cameras_[camera];
  if (hasTimes()) {
    return byTime(pictures, frame);
  }
  const std::int64_t number = frame + std::llround(pictures.delay * rate_);
  const double time = static_cast<double>(number) / rate_ - pictures.delay;
  if (pictures.sequenceNumbers.empty()) {
    const bool isThere = number >= 0 && number < pictures.imageCount;
    return isThere ? std::optional(ScheduledImage{number, time}) : std::nullopt;
  }
  const auto found = std::ranges::lower_bound(pictures.sequenceNumbers, number);
  const bool isThere = found != pictures.sequenceNumbers.end() && *found == number;
  return isThere ? std::optional(ScheduledImage{found - pictures.sequenceNumbers.begin(), time})
                 : std::nullopt;
}

std::optional<CaptureSchedule::ScheduledImage> CaptureSchedule::byTime(const CameraImages& camera,
                                                                       std::int64_t frame) const {
  const CaptureTimes& times = *camera.times;
  const double wanted = static_cast<double>(frame) / rate_;
  const auto since = [&](CaptureTimes::const_iterator at) { return *at - camera.delay - origin_; };
  auto nearest = std::ranges::lower_bound(times, wanted + camera.delay + origin_);
  if (nearest == times.end() ||
      (nearest != times.begin() && wanted - since(nearest - 1) <= since(nearest) - wanted)) {
    --nearest;
  }
  const double time = since(nearest);
  if (std::abs(time - wanted) > 0.5 / rate_ + kTimeRounding) {
    return std::nullopt;
  }
  return ScheduledImage{nearest - times.begin(), time};
}

double CaptureSchedule::highestRateOf(const std::vector<CameraImages>& cameras) {
  double rate = 0.0;
  for (const CameraImages& camera : cameras) {
    if (camera.times && camera.times->size() > 1) {
      std::vector<double> intervals(camera.times->size() - 1);
      std::ranges::transform(camera.times->begin() + 1, camera.times->end(), camera.times->begin(),
                             camera.times->end() - 1, intervals.begin(), std::minus<>());
      rate = std::max(rate, 1.0 / upperMedian(std::move(intervals)));
    }
  }
  return rate;
}

} // namespace dewpoint::capture
