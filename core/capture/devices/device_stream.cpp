// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/device_stream.h"

#include "core/base/text_number.h"
#include "core/capture/devices/color_lock.h"
#include "core/capture/devices/device_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace dewpoint::capture {
namespace {

/// The path of a device's node, which a location may name by its number alone.
std::string nodePath(const std::string& location) {
  return toNumber<int>(location) ? "/dev/video" + location : location;
}

using OpenResult = tl::expected<void, std::string>;

class DeviceStream final : public LiveStream {
public:
  DeviceStream(LiveCamera camera, DeviceLookup lookup, LiveStreamFactory makeStream)
      : camera_(std::move(camera)), lookup_(std::move(lookup)), makeStream_(std::move(makeStream)) {
  }

  OpenResult open() override {
    LiveCamera found = camera_;
    warning_.clear();
    if (auto resolved = resolve(found); !resolved) {
      return resolved;
    }
    stream_ = makeStream_(found);
    if (auto opened = stream_->open(); !opened) {
      return opened;
    }
    if (hasOtherDevice(found.location)) {
      stream_.reset();
      return tl::make_unexpected(std::string("another device took its place while it was opened"));
    }
    setControls(nodePath(found.location));
    return {};
  }
  bool grab() override { return stream_->grab(); }
  cv::Mat retrieve() override { return stream_->retrieve(); }
  std::optional<CaptureInstant> captureTime() const override { return stream_->captureTime(); }
  std::optional<std::chrono::steady_clock::time_point> arrivalTime() const override {
    return stream_->arrivalTime();
  }
  std::string lostReason() const override { return stream_ ? stream_->lostReason() : ""; }
  bool hasEnded() const override { return stream_ && stream_->hasEnded(); }
  std::string warning() const override { return warning_; }

private:
  /// Gives the camera the location that its device has now.
  OpenResult resolve(LiveCamera& camera) const {
    const DeviceSettings& settings = camera.device;
    if (settings.identity.isEmpty() && settings.format == DeviceFormat{}) {
      return {};
    }
    const std::vector<CameraDevice> devices = lookup_.access->listDevices();
    if (settings.identity.isEmpty()) {
      const auto device = std::ranges::find_if(devices, [&](const CameraDevice& one) {
        return one.path == nodePath(camera.location) || one.stablePath == camera.location;
      });
      return device == devices.end() ? OpenResult() : check(*device);
    }
    const DeviceMatch match = matchDevices(lookup_.identities, devices).at(lookup_.cameraIndex);
    if (!match.deviceIndex) {
      return tl::make_unexpected(mismatchReason(match, settings.identity, devices));
    }
    camera.location = devices[*match.deviceIndex].path;
    return check(devices[*match.deviceIndex]);
  }

  /// Whether the node at `path` now belongs to another device than that of this camera. Nodes are
  /// numbered again when devices are plugged in, also between the search and the opening.
  bool hasOtherDevice(const std::string& path) const {
    if (camera_.device.identity.isEmpty()) {
      return false;
    }
    const std::vector<CameraDevice> devices = lookup_.access->listDevices();
    const auto there = std::ranges::find(devices, path, &CameraDevice::path);
    if (there == devices.end() || !there->problem.empty()) {
      return false; // unplugged, which reading will tell, or in use by this very connection
    }
    const auto device =
        matchDevices(lookup_.identities, devices).at(lookup_.cameraIndex).deviceIndex;
    return device != static_cast<std::size_t>(there - devices.begin());
  }

  /// Whether the device can deliver what is requested.
  OpenResult check(const CameraDevice& device) const {
    if (!device.problem.empty()) {
      return tl::make_unexpected(device.problem);
    }
    const DeviceFormat& format = camera_.device.format;
    if (isOffered(format, device.formats)) {
      return {};
    }
    return tl::make_unexpected(fmt::format(
        "{} does not offer the format {}; it offers {}, for example", describe(device.identity),
        describe(format), describe(completedFormat({}, device.formats))));
  }

  void setControls(const std::string& path) {
    for (const Error& error : applyControls(*lookup_.access, path, camera_.device.controls)) {
      warning_ += fmt::format("{}{}: {}", warning_.empty() ? "controls were not set: " : "; ",
                              error.field, error.detail);
    }
  }

  LiveCamera camera_;
  DeviceLookup lookup_;
  LiveStreamFactory makeStream_;
  LiveStreamPtr stream_;
  std::string warning_;
};

} // namespace

LiveStreamPtr makeDeviceStream(const LiveCamera& camera, DeviceLookup lookup,
                               LiveStreamFactory makeStream) {
  return std::make_unique<DeviceStream>(camera, std::move(lookup), std::move(makeStream));
}

} // namespace dewpoint::capture
