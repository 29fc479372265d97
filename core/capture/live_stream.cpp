// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/live_stream.h"

#include "core/base/text_number.h"

#include <opencv2/videoio.hpp>

#include <filesystem>
#include <optional>
#include <string_view>

namespace dewpoint::capture {

namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// After which opening a stream has failed, ...
constexpr int kOpenTimeoutMilliseconds = 3000;
/// ... and reading from it.
constexpr int kReadTimeoutMilliseconds = 2000;
constexpr std::string_view kDevicePrefix = "/dev/video";

std::optional<int> deviceNumber(std::string_view location) {
  if (location.starts_with(kDevicePrefix)) {
    location.remove_prefix(kDevicePrefix.size());
  }
  const auto number = toNumber<int>(location);
  return number && *number >= 0 ? number : std::nullopt;
}

class VideoStream final : public LiveStream {
public:
  explicit VideoStream(LiveCamera camera) : camera_(std::move(camera)) {}

  tl::expected<void, std::string> open() override {
    const std::string& location = camera_.location;
    if (location.find("://") != std::string::npos) {
      return opened(video_.open(location, cv::CAP_FFMPEG,
                                {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kOpenTimeoutMilliseconds,
                                 cv::CAP_PROP_READ_TIMEOUT_MSEC, kReadTimeoutMilliseconds}),
                    "no video stream answers at this address");
    }
    return openDevice(deviceNumber(location).value_or(0));
  }
  bool grab() override { return video_.grab(); }
  cv::Mat retrieve() override {
    cv::Mat picture;
    video_.retrieve(picture);
    return picture;
  }

private:
  static tl::expected<void, std::string> opened(bool good, const char* otherwise) {
    if (!good) {
      return tl::make_unexpected(std::string(otherwise));
    }
    return {};
  }

  tl::expected<void, std::string> openDevice(int number) {
    std::error_code ignored;
    if (!std::filesystem::exists(std::string(kDevicePrefix) + std::to_string(number), ignored)) {
      return opened(false, "no such device is plugged in");
    }
    if (!video_.open(number, cv::CAP_V4L2)) {
      return opened(false, "the device is busy, or it is not a camera");
    }
    if (camera_.width > 0 && camera_.height > 0) {
      video_.set(cv::CAP_PROP_FRAME_WIDTH, camera_.sentWidth());
      video_.set(cv::CAP_PROP_FRAME_HEIGHT, camera_.sentHeight());
    }
    return {};
  }

  LiveCamera camera_;
  cv::VideoCapture video_;
};

} // namespace

LiveStreamPtr makeVideoStream(const LiveCamera& camera) {
  return std::make_unique<VideoStream>(camera);
}

} // namespace dewpoint::capture
