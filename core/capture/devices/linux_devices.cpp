// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef __linux__
#include "core/capture/devices/linux_devices.h"

#include "core/capture/devices/linux_controls.h"
#include "core/capture/devices/linux_formats.h"
#include "core/capture/devices/linux_sysfs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <linux/videodev2.h>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace dewpoint::capture {
namespace {

namespace fs = std::filesystem;

constexpr const char* kByPath = "dev/v4l/by-path";
constexpr const char* kById = "dev/v4l/by-id";
constexpr std::string_view kFirstIndex = "-video-index0";

/// A text of a fixed number of bytes, which need not end in a zero.
template <std::size_t Size> std::string textOf(const __u8 (&bytes)[Size]) {
  const auto* text = reinterpret_cast<const char*>(bytes);
  return {text, ::strnlen(text, Size)};
}

/// Connector in the words of udev, or else in those of the driver.
std::string busOf(const std::string& byPath, const v4l2_capability& capability) {
  std::string bus = byPath.empty() ? textOf(capability.bus_info) : byPath;
  if (bus.ends_with(kFirstIndex)) {
    bus.resize(bus.size() - kFirstIndex.size());
  }
  return bus;
}

bool isCamera(const v4l2_capability& capability) {
  const std::uint32_t abilities = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0
                                      ? capability.device_caps
                                      : capability.capabilities;
  constexpr std::uint32_t kOthers = V4L2_CAP_VIDEO_M2M | V4L2_CAP_VIDEO_M2M_MPLANE | V4L2_CAP_IO_MC;
  return (abilities & V4L2_CAP_VIDEO_CAPTURE) != 0 && (abilities & kOthers) == 0;
}

/// What can be said of a node that cannot be opened. Nodes after the first of a device are left
/// out: they are for metadata, mostly.
std::optional<CameraDevice> closedDevice(CameraDevice device, const SysfsFacts& facts, int problem,
                                         const std::string& sysfsName) {
  const bool isGone = problem == ENOENT || problem == ENODEV || problem == ENXIO;
  if (isGone || facts.nodeIndex != 0) {
    return std::nullopt;
  }
  device.identity.name = facts.product.empty() ? sysfsName : facts.product;
  device.problem = problem == EACCES || problem == EPERM
                       ? "you have no permission to open it; add your user to the group 'video'"
                       : "it cannot be opened: " + systemErrorText(problem);
  return device;
}

std::optional<CameraDevice> deviceAt(const fs::path& root, const LinuxCallsPtr& calls,
                                     const std::string& node) {
  const SysfsFacts facts = readSysfsFacts(root, node);
  const std::string byPath = sysfsLinkTarget(root, kByPath, node);
  CameraDevice device;
  device.path = "/dev/" + node;
  device.stablePath = byPath.empty() ? device.path : fmt::format("/{}/{}", kByPath, byPath);
  device.identity.serial = facts.serial;
  device.identity.vendorAndProductId = facts.vendorAndProductId;
  device.identity.bus = busOf(byPath, {});
  device.usbLink = facts.usbLink;
  LinuxNode opened(calls, (root / "dev" / node).string());
  if (opened.openError() != 0) {
    return closedDevice(std::move(device), facts, opened.openError(), node);
  }
  v4l2_capability capability{};
  if (opened.callIoctl(VIDIOC_QUERYCAP, capability) != 0 || !isCamera(capability)) {
    return std::nullopt;
  }
  device.formats = readLinuxFormats(opened);
  if (device.formats.empty()) {
    return std::nullopt;
  }
  device.driver = textOf(capability.driver);
  device.identity.name = textOf(capability.card);
  device.identity.bus = busOf(byPath, capability);
  return device;
}

/// Owner, permissions and time of change of a node: a device that is plugged in again differs.
std::string stateOf(const fs::path& node) {
  struct stat status {};
  if (::stat(node.c_str(), &status) != 0) {
    return "-";
  }
  return fmt::format("{}.{} {}", status.st_ctim.tv_sec, status.st_ctim.tv_nsec,
                     ::access(node.c_str(), R_OK | W_OK));
}

} // namespace

LinuxDevices::LinuxDevices(fs::path root, LinuxCallsPtr calls)
    : root_(std::move(root)), calls_(std::move(calls)) {}

std::string LinuxDevices::below(const std::string& path) const {
  return (root_ / fs::path(path).relative_path()).string();
}

std::vector<CameraDevice> LinuxDevices::listDevices() {
  std::vector<CameraDevice> devices;
  for (const std::string& node : listVideoNodes(root_)) {
    if (auto device = deviceAt(root_, calls_, node)) {
      devices.push_back(std::move(*device));
    }
  }
  for (CameraDevice& device : devices) {
    const std::string& serial = device.identity.serial;
    const auto others = [&](const CameraDevice& one) { return one.identity.serial == serial; };
    if (!serial.empty() && std::ranges::count_if(devices, others) == 1) {
      const std::string byId =
          sysfsLinkTarget(root_, kById, fs::path(device.path).filename().string());
      device.stablePath = byId.empty() ? device.stablePath : fmt::format("/{}/{}", kById, byId);
    }
  }
  return devices;
}

std::string LinuxDevices::deviceListSignature() {
  std::string text;
  for (const std::string& node : listVideoNodes(root_)) {
    text += fmt::format("{} {} {} {}\n", node, stateOf(root_ / "dev" / node),
                        sysfsLinkTarget(root_, kByPath, node), sysfsLinkTarget(root_, kById, node));
  }
  return text;
}

Result<std::vector<DeviceControl>> LinuxDevices::readControls(const std::string& path) {
  LinuxNode node(calls_, below(path));
  if (node.openError() != 0) {
    return failure(ErrorCode::DeviceUnavailable, path, "", systemErrorText(node.openError()));
  }
  return readLinuxControls(node);
}

Status LinuxDevices::setControl(const std::string& path, const std::string& name,
                                std::int64_t value) {
  LinuxNode node(calls_, below(path));
  if (node.openError() != 0) {
    return failure(ErrorCode::DeviceUnavailable, path, name, systemErrorText(node.openError()));
  }
  return setLinuxControl(node, path, name, value);
}

} // namespace dewpoint::capture
#endif
