// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/camera_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dewpoint::capture {
namespace {

const OfferedFormat* offeredFormat(const std::vector<OfferedFormat>& offered,
                                   std::string_view code) {
  const auto found = std::ranges::find(offered, code, &OfferedFormat::pixelFormat);
  return found == offered.end() ? nullptr : &*found;
}

const OfferedSize* offeredSize(const OfferedFormat& offered, int width, int height) {
  const auto found = std::ranges::find_if(offered.sizes, [&](const OfferedSize& size) {
    return size.width == width && size.height == height;
  });
  return found == offered.sizes.end() ? nullptr : &*found;
}

/// The pixel format that opens unless one is requested: as open_live, JPEG before uncompressed
/// images, if it has the requested size and rate.
const OfferedFormat* preferredFormat(const DeviceFormat& requested,
                                     const std::vector<OfferedFormat>& offered) {
  std::vector<const OfferedFormat*> candidates;
  for (const char* code : {"MJPG", "JPEG"}) {
    if (const OfferedFormat* format = offeredFormat(offered, code)) {
      candidates.push_back(format);
    }
  }
  for (const OfferedFormat& format : offered) {
    if (!format.isCompressed) {
      candidates.push_back(&format);
    }
  }
  const auto fitting = std::ranges::find_if(
      candidates, [&](const OfferedFormat* format) { return isOffered(requested, {*format}); });
  return fitting != candidates.end() ? *fitting
         : !candidates.empty()       ? candidates.front()
         : offered.empty()           ? nullptr
                                     : &offered.front();
}

} // namespace

std::string describe(const DeviceIdentity& identity) {
  const std::string name = identity.name.empty() ? "the camera" : "'" + identity.name + "'";
  return !identity.serial.empty() ? fmt::format("{} (serial number {})", name, identity.serial)
         : !identity.bus.empty()  ? fmt::format("{} (connector {})", name, identity.bus)
                                  : name;
}

std::string describe(const DeviceFormat& format) {
  std::string text = format.pixelFormat;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : " ") + part; };
  if (format.width > 0) {
    add(fmt::format("{}x{}", format.width, format.height));
  }
  if (format.frameRate > 0.0) {
    add(fmt::format("{:.4g}", format.frameRate));
  }
  return text;
}

DeviceFormat completedFormat(const DeviceFormat& format,
                             const std::vector<OfferedFormat>& offered) {
  DeviceFormat complete = format;
  const OfferedFormat* known = format.pixelFormat.empty()
                                   ? preferredFormat(format, offered)
                                   : offeredFormat(offered, format.pixelFormat);
  if (known == nullptr) {
    return complete;
  }
  complete.pixelFormat = known->pixelFormat;
  if (complete.width == 0 && !known->sizes.empty()) {
    complete.width = known->sizes.front().width;
    complete.height = known->sizes.front().height;
  }
  const OfferedSize* size = offeredSize(*known, complete.width, complete.height);
  if (complete.frameRate == 0.0 && size != nullptr && !size->frameRates.empty()) {
    complete.frameRate = size->frameRates.front();
  }
  return complete;
}

bool isOffered(const DeviceFormat& format, const std::vector<OfferedFormat>& offered) {
  constexpr double kSameRate = 0.01; // relative: 29.97 is also written 30
  return std::ranges::any_of(offered, [&](const OfferedFormat& one) {
    if (!format.pixelFormat.empty() && format.pixelFormat != one.pixelFormat) {
      return false;
    }
    if (one.hasOtherSizes || (format.width == 0 && format.frameRate == 0.0)) {
      return true;
    }
    return std::ranges::any_of(one.sizes, [&](const OfferedSize& size) {
      const bool hasSize =
          format.width == 0 || (size.width == format.width && size.height == format.height);
      return hasSize && (format.frameRate == 0.0 || size.frameRates.empty() ||
                         std::ranges::any_of(size.frameRates, [&](double rate) {
                           return std::abs(rate - format.frameRate) <= kSameRate * rate;
                         }));
    });
  });
}

} // namespace dewpoint::capture
