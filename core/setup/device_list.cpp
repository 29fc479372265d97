// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/device_list.h"

#include "core/setup/new_project/project_devices.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace dewpoint::setup {
namespace {

using Json = nlohmann::ordered_json;

const char* kindName(ControlKind kind) {
  switch (kind) {
  case ControlKind::Integer:
    return "integer";
  case ControlKind::Boolean:
    return "boolean";
  case ControlKind::Menu:
    return "menu";
  }
  return "";
}

/// A line of the list: what it is about, and its text.
std::string listLine(const char* subject, const std::string& text) {
  return fmt::format("  {:<10} {}\n", subject, text);
}

std::string sizesText(const OfferedFormat& format) {
  std::vector<std::string> sizes;
  for (const OfferedSize& size : format.sizes) {
    std::vector<std::string> rates;
    for (const double rate : size.frameRates) {
      rates.push_back(fmt::format("{:.4g}", rate));
    }
    sizes.push_back(fmt::format("{}x{}{}{}", size.width, size.height, rates.empty() ? "" : " at ",
                                fmt::join(rates, ", ")));
  }
  if (format.hasOtherSizes) {
    sizes.emplace_back("and other sizes");
  }
  return fmt::format("{}", fmt::join(sizes, "; "));
}

std::string allowedText(const DeviceControl& control) {
  if (control.kind != ControlKind::Menu) {
    return fmt::format("{} to {}{}, default {}", control.minimum, control.maximum,
                       control.step > 1 ? fmt::format(" in steps of {}", control.step) : "",
                       control.defaultValue);
  }
  std::vector<std::string> items;
  for (const ControlMenuItem& item : control.menuItems) {
    items.push_back(fmt::format("{} = {}", item.value, item.name));
  }
  return fmt::format("{}, default {}", fmt::join(items, ", "), control.defaultValue);
}

std::string controlText(const DeviceControl& control) {
  return fmt::format("{} = {} ({}{}{})", control.name, control.value, allowedText(control),
                     control.isReadOnly ? ", cannot be set" : "",
                     control.isInactive ? ", set by an automatic now" : "");
}

std::string deviceText(const ListedDevice& listed) {
  const CameraDevice& device = listed.device;
  std::string text = device.identity.name + "\n" + listLine("address", device.stablePath);
  if (device.path != device.stablePath) {
    text += listLine("node", device.path);
  }
  const std::string usb = device.usbLink.busNumber > 0
                              ? fmt::format(" (USB bus {}, {} Mbit/s)", device.usbLink.busNumber,
                                            device.usbLink.deviceMbitPerSecond)
                              : std::string();
  text += listLine("connector", device.identity.bus + usb);
  text += listLine("serial", device.identity.serial.empty() ? "none" : device.identity.serial);
  if (!device.problem.empty()) {
    text += listLine("problem", device.problem);
  }
  for (const OfferedFormat& format : device.formats) {
    text += listLine("format", format.pixelFormat + ": " + sizesText(format));
  }
  for (const DeviceControl& control : listed.controls.value_or(std::vector<DeviceControl>())) {
    text += listLine("control", controlText(control));
  }
  return text;
}

Json formatsJson(const std::vector<OfferedFormat>& formats) {
  auto list = Json::array();
  for (const OfferedFormat& format : formats) {
    auto sizes = Json::array();
    for (const OfferedSize& size : format.sizes) {
      sizes.push_back({{"width", size.width}, {"height", size.height}, {"rates", size.frameRates}});
    }
    list.push_back({{"pixel_format", format.pixelFormat},
                    {"description", format.description},
                    {"compressed", format.isCompressed},
                    {"other_sizes", format.hasOtherSizes},
                    {"sizes", std::move(sizes)}});
  }
  return list;
}

Json controlsJson(const std::vector<DeviceControl>& controls) {
  auto list = Json::array();
  for (const DeviceControl& control : controls) {
    auto menu = Json::array();
    for (const ControlMenuItem& item : control.menuItems) {
      menu.push_back({{"value", item.value}, {"name", item.name}});
    }
    list.push_back({{"name", control.name},
                    {"label", control.label},
                    {"kind", kindName(control.kind)},
                    {"value", control.value},
                    {"minimum", control.minimum},
                    {"maximum", control.maximum},
                    {"step", control.step},
                    {"default", control.defaultValue},
                    {"read_only", control.isReadOnly},
                    {"inactive", control.isInactive},
                    {"menu", std::move(menu)}});
  }
  return list;
}

Json deviceJson(const ListedDevice& listed) {
  const CameraDevice& device = listed.device;
  Json object{{"name", device.identity.name},
              {"address", device.stablePath},
              {"node", device.path},
              {"bus", device.identity.bus},
              {"serial", device.identity.serial},
              {"vendor_product", device.identity.vendorAndProductId},
              {"driver", device.driver},
              {"usb_bus", device.usbLink.busNumber},
              {"usb_mbit", device.usbLink.deviceMbitPerSecond},
              {"problem", device.problem},
              {"formats", formatsJson(device.formats)}};
  if (listed.controls) {
    object["controls"] = controlsJson(*listed.controls);
  }
  return object;
}

} // namespace

std::string deviceListText(std::span<const ListedDevice> devices) {
  std::string text;
  for (const ListedDevice& device : devices) {
    text += (text.empty() ? "" : "\n") + deviceText(device);
  }
  return text;
}

std::string deviceListJson(std::span<const ListedDevice> devices) {
  auto list = Json::array();
  for (const ListedDevice& device : devices) {
    list.push_back(deviceJson(device));
  }
  return list.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::size_t identifyDevices(Project& project, std::span<const CameraDevice> devices) {
  const auto matches = matchProjectDevices(project, devices);
  std::size_t count = 0;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    ProjectCamera& camera = project.cameras[k];
    if (matches[k].deviceIndex && camera.device.identity.isEmpty()) {
      const CameraDevice& device = devices[*matches[k].deviceIndex];
      camera.device.identity = device.identity;
      camera.location = device.stablePath;
      ++count;
    }
  }
  return count;
}

} // namespace dewpoint::setup
