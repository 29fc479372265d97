// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_devices.h"

#include "core/base/limits.h"

#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace dewpoint::project {
namespace {

constexpr std::size_t kLongestIdentity = 500; ///< characters
constexpr std::size_t kLongestControl = 100;  ///< characters of a name
constexpr std::size_t kMostControls = 1000;
constexpr double kLowestRate = 0.001;
constexpr double kHighestRate = 10000.0;

/// The texts of an identity by their keys; `Identity` may be const.
template <class Identity> auto identityKeys(Identity& identity) {
  return std::array<std::pair<const char*, decltype(&identity.bus)>, 4>{
      {{"bus", &identity.bus},
       {"serial", &identity.serial},
       {"name", &identity.name},
       {"vendor_product", &identity.vendorAndProductId}}};
}

bool isPixelFormat(std::string_view code) {
  return code.size() <= 4 &&
         std::ranges::all_of(code, [](char c) { return c > ' ' && c < '\x7f'; });
}

bool isVendorProduct(std::string_view text) {
  bool isGood = text.size() == 9 && text[4] == ':';
  for (std::size_t k = 0; isGood && k < text.size(); ++k) {
    isGood = k == 4 || std::isxdigit(static_cast<unsigned char>(text[k])) != 0;
  }
  return isGood;
}

bool isControlName(std::string_view name) {
  return !name.empty() && name.size() <= kLongestControl &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
}

Status bad(std::string field, std::string detail) {
  return failure(ErrorCode::BadValue, "", std::move(field), std::move(detail));
}

void readSize(TableReader& reader, DeviceFormat& format) {
  std::array<double, 2> size{};
  if (!reader.readNumbers("size", size.data(), size.size(), 1.0, limits::kMaxImageSide)) {
    return;
  }
  format.width = static_cast<int>(size[0]);
  format.height = static_cast<int>(size[1]);
  if (format.width != size[0] || format.height != size[1]) {
    reader.fail(ErrorCode::BadValue, "size", "whole numbers of pixels are expected");
  }
}

void readControls(TableReader& camera, const std::string& file, const std::string& prefix,
                  ControlValues& controls) {
  const toml::table* table = camera.findTable("controls");
  if (table == nullptr) {
    return;
  }
  TableReader reader(*table, file, prefix + "controls.");
  for (const auto& [key, node] : *table) {
    const std::string name(key.str());
    std::int64_t value = 0;
    reader.readInteger(name.c_str(), value, std::numeric_limits<std::int64_t>::min(),
                       std::numeric_limits<std::int64_t>::max());
    controls[name] = value;
  }
  camera.recordError(reader.finish());
}

} // namespace

void readDeviceSettings(TableReader& reader, const std::string& file, const std::string& prefix,
                        ProjectCamera& camera) {
  DeviceSettings& settings = camera.device;
  reader.readText("pixel_format", settings.format.pixelFormat);
  readSize(reader, settings.format);
  reader.readNumber("rate", settings.format.frameRate, kLowestRate, kHighestRate);
  if (const toml::table* table = reader.findTable("identity")) {
    TableReader identity(*table, file, prefix + "identity.");
    for (const auto& [key, text] : identityKeys(settings.identity)) {
      identity.readText(key, *text);
    }
    reader.recordError(identity.finish());
  }
  readControls(reader, file, prefix, settings.controls);
  for (const char* key : {"pixel_format", "size", "rate", "identity", "controls"}) {
    if (reader.has(key) && camera.source != SourceKind::Device) {
      reader.fail(ErrorCode::BadValue, key, "only a camera with a device has it");
    }
  }
  if (const auto good = checkDeviceSettings(settings); !good) {
    reader.fail(good.error().code, good.error().field, good.error().detail);
  }
}

std::string deviceFormatText(const DeviceFormat& format) {
  std::string text;
  if (!format.pixelFormat.empty()) {
    text += "pixel_format = " + tomlQuoted(format.pixelFormat) + "\n";
  }
  if (format.width > 0) {
    text += fmt::format("size = [{}, {}]   # requested from the device, before the rotation\n",
                        format.width, format.height);
  }
  if (format.frameRate > 0.0) {
    text += fmt::format("rate = {}   # images per second\n", format.frameRate);
  }
  return text;
}

std::string deviceTablesText(const DeviceSettings& settings) {
  std::string text;
  if (!settings.identity.isEmpty()) {
    text += "[camera.identity]   # by which the device is recognized\n";
    for (const auto& [key, value] : identityKeys(settings.identity)) {
      text += value->empty() ? "" : fmt::format("{} = {}\n", key, tomlQuoted(*value));
    }
  }
  if (!settings.controls.empty()) {
    text += "[camera.controls]   # set when the device is opened\n";
    for (const auto& [name, value] : settings.controls) {
      text += fmt::format("{} = {}\n", name, value);
    }
  }
  return text;
}

Status checkDeviceSettings(const DeviceSettings& settings) {
  const DeviceFormat& format = settings.format;
  if (!isPixelFormat(format.pixelFormat)) {
    return bad("pixel_format", "a code of V4L2 is expected, such as MJPG or YUYV");
  }
  const bool hasSize = format.width > 0 && format.height > 0;
  if (!hasSize && (format.width != 0 || format.height != 0)) {
    return bad("size", "a positive width and height are expected");
  }
  if (format.frameRate != 0.0 &&
      !(format.frameRate >= kLowestRate && format.frameRate <= kHighestRate)) {
    return bad("rate",
               fmt::format("{} to {} images per second are expected", kLowestRate, kHighestRate));
  }
  for (const auto& [key, text] : identityKeys(settings.identity)) {
    if (text->size() > kLongestIdentity) {
      return bad(fmt::format("identity.{}", key),
                 fmt::format("at most {} characters are expected", kLongestIdentity));
    }
  }
  const std::string& vendorAndProductId = settings.identity.vendorAndProductId;
  if (!vendorAndProductId.empty() && !isVendorProduct(vendorAndProductId)) {
    return bad("identity.vendor_product", "four hexadecimal digits each are expected, such as "
                                          "046d:082d");
  }
  if (settings.controls.size() > kMostControls) {
    return bad("controls", fmt::format("at most {} are possible", kMostControls));
  }
  for (const auto& [name, value] : settings.controls) {
    if (!isControlName(name)) {
      return bad("controls." + name, "the name of a control has only small letters, digits and _");
    }
  }
  return {};
}

} // namespace dewpoint::project
