// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/device_caps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace dewpoint::capture {
namespace {

/// Pixel formats of V4L2 and the GStreamer caps of the same images.
constexpr std::array<std::pair<std::string_view, const char*>, 19> kDeviceCaps{{
    {"MJPG", "image/jpeg"},
    {"JPEG", "image/jpeg"},
    {"H264", "video/x-h264"},
    {"HEVC", "video/x-h265"},
    {"VP80", "video/x-vp8"},
    {"VP90", "video/x-vp9"},
    {"YUYV", "video/x-raw,format=YUY2"},
    {"UYVY", "video/x-raw,format=UYVY"},
    {"YVYU", "video/x-raw,format=YVYU"},
    {"VYUY", "video/x-raw,format=VYUY"},
    {"NV12", "video/x-raw,format=NV12"},
    {"NV21", "video/x-raw,format=NV21"},
    {"YU12", "video/x-raw,format=I420"},
    {"YV12", "video/x-raw,format=YV12"},
    {"GREY", "video/x-raw,format=GRAY8"},
    {"Y16", "video/x-raw,format=GRAY16_LE"},
    {"RGB3", "video/x-raw,format=RGB"},
    {"BGR3", "video/x-raw,format=BGR"},
    {"RGBP", "video/x-raw,format=RGB16"},
}};

/// A rate as a fraction. Those of television, such as 29.97002997 = 30000/1001, are meant where
/// they fit; others have the smallest denominator.
std::string rateFraction(double rate) {
  constexpr int kMostParts = 1000;
  constexpr double kSame = 1e-6;         // relative
  constexpr int kTelevisionParts = 1001; // of thousandths
  const auto whole = std::lround(rate * kTelevisionParts / kMostParts);
  const auto thousandths = whole * kMostParts;
  if (std::abs(static_cast<double>(thousandths) / kTelevisionParts - rate) <= kSame * rate) {
    return fmt::format("{}/{}", thousandths, kTelevisionParts);
  }
  int parts = 1;
  while (parts < kMostParts && std::abs(std::round(rate * parts) / parts - rate) > kSame * rate) {
    ++parts;
  }
  return fmt::format("{}/{}", std::lround(rate * parts), parts);
}

/// Caps for images of these types. With a rate: exactly this one first, then those within 1 %,
/// since drivers round it.
std::string formatCaps(const DeviceFormat& format, const std::vector<std::string>& types) {
  const std::string size =
      format.width > 0 ? fmt::format(",width={},height={}", format.width, format.height) : "";
  std::vector<std::string> rates{""};
  if (format.frameRate > 0.0) {
    rates = {",framerate=" + rateFraction(format.frameRate),
             fmt::format(",framerate=[{}/1000,{}/1000]", std::lround(format.frameRate * 990.0),
                         std::lround(format.frameRate * 1010.0))};
  }
  std::vector<std::string> caps;
  for (const std::string& rate : rates) {
    for (const std::string& type : types) {
      caps.push_back(fmt::format("{}{}{}", type, size, rate));
    }
  }
  return fmt::format("{}", fmt::join(caps, ";"));
}

} // namespace

DeviceFormat requestedFormat(const LiveCamera& camera) {
  DeviceFormat format = camera.device.format;
  if (format.width == 0 && camera.width > 0 && camera.height > 0) {
    format.width = camera.sentWidth();
    format.height = camera.sentHeight();
  }
  return format;
}

std::optional<std::string> deviceCaps(const LiveCamera& camera) {
  const DeviceFormat format = requestedFormat(camera);
  if (format.pixelFormat.empty()) {
    // Compressed first: uncompressed images of several cameras rarely fit on one USB bus.
    return formatCaps(format, {"image/jpeg", "video/x-raw"});
  }
  const auto* const known =
      std::ranges::find(kDeviceCaps, format.pixelFormat, [](const auto& row) { return row.first; });
  return known == kDeviceCaps.end() ? std::nullopt
                                    : std::optional(formatCaps(format, {known->second}));
}

bool isInterCoded(std::string_view pixelFormat) {
  return pixelFormat == "H264" || pixelFormat == "HEVC" || pixelFormat.starts_with("VP");
}

} // namespace dewpoint::capture
