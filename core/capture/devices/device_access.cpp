// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/device_access.h"

#ifdef __linux__
#include "core/capture/devices/linux_devices.h"
#endif

namespace dewpoint::capture {

#ifdef __linux__

DeviceAccessPtr systemDevices() {
  return std::make_shared<LinuxDevices>();
}

#else
namespace {

class NoDevices final : public DeviceAccess {
public:
  std::vector<CameraDevice> listDevices() override { return {}; }
  std::string deviceListSignature() override { return {}; }
  Result<std::vector<DeviceControl>> readControls(const std::string& path) override {
    return failure(ErrorCode::DeviceUnavailable, path, "", kReason);
  }
  Status setControl(const std::string& path, const std::string& name,
                    std::int64_t /*value*/) override {
    return failure(ErrorCode::DeviceUnavailable, path, name, kReason);
  }

private:
  static constexpr const char* kReason = "camera devices are known on Linux only";
};

} // namespace

DeviceAccessPtr systemDevices() {
  return std::make_shared<NoDevices>();
}

#endif

} // namespace dewpoint::capture
