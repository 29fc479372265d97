// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef __linux__
#include "core/capture/devices/linux_sysfs.h"

#include "core/base/text_number.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

namespace dewpoint::capture {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kNodePrefix = "video";

/// The first line of an attribute, without spaces at its ends.
std::string attribute(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  constexpr auto kSpace = " \t\r\n";
  const auto first = line.find_first_not_of(kSpace);
  return first == std::string::npos ? std::string()
                                    : line.substr(first, line.find_last_not_of(kSpace) + 1 - first);
}

std::optional<int> numberOf(std::string_view node) {
  return node.starts_with(kNodePrefix) ? toNumber<int>(node.substr(kNodePrefix.size()))
                                       : std::nullopt;
}

template <class Visit> void eachEntry(const fs::path& folder, const Visit& visit) {
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    visit(entry->path());
  }
}

} // namespace

std::vector<std::string> listVideoNodes(const fs::path& root) {
  std::vector<std::string> nodes;
  eachEntry(root / "sys/class/video4linux", [&](const fs::path& entry) {
    if (numberOf(entry.filename().string())) {
      nodes.push_back(entry.filename().string());
    }
  });
  std::ranges::sort(nodes, {}, [](const std::string& node) { return numberOf(node); });
  return nodes;
}

SysfsFacts readSysfsFacts(const fs::path& root, const std::string& node) {
  SysfsFacts facts;
  const fs::path entry = root / "sys/class/video4linux" / node;
  facts.nodeIndex = toNumber<int>(attribute(entry / "index")).value_or(0);
  std::error_code problem;
  const fs::path interface = fs::canonical(entry / "device", problem);
  if (problem) {
    return facts;
  }
  // Up from the USB interface to the device, and on to the hub that is the bus itself.
  std::string hub;
  for (fs::path up = interface; up.has_relative_path(); up = up.parent_path()) {
    if (hub.empty() && fs::exists(up / "idVendor", problem)) {
      facts.vendorAndProductId = attribute(up / "idVendor") + ":" + attribute(up / "idProduct");
      facts.product = attribute(up / "product");
      facts.serial = attribute(up / "serial");
      facts.usbLink.busNumber = toNumber<int>(attribute(up / "busnum")).value_or(0);
      facts.usbLink.deviceMbitPerSecond = toNumber<double>(attribute(up / "speed")).value_or(0.0);
      facts.usbLink.busMbitPerSecond = facts.usbLink.deviceMbitPerSecond;
      hub = "usb" + attribute(up / "busnum");
    }
    if (!hub.empty() && up.filename() == hub) {
      facts.usbLink.busMbitPerSecond =
          toNumber<double>(attribute(up / "speed")).value_or(facts.usbLink.busMbitPerSecond);
      break;
    }
  }
  return facts;
}

std::string sysfsLinkTarget(const fs::path& root, const std::string& folder,
                            const std::string& node) {
  std::string first;
  eachEntry(root / folder, [&](const fs::path& link) {
    std::error_code problem;
    const fs::path target = fs::read_symlink(link, problem);
    const std::string name = link.filename().string();
    if (!problem && target.filename() == node && (first.empty() || name < first)) {
      first = name;
    }
  });
  return first;
}

} // namespace dewpoint::capture
#endif
