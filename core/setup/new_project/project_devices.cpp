// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/project_devices.h"

#include "core/capture/gstreamer/device_caps.h"
#include "core/setup/new_project/new_project.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <optional>

namespace dewpoint::setup {
namespace {

/// A control that is on if it does not have this value.
struct AutomaticSwitch {
  capture::ColorAutomatic automatic;
  const char* name;
  std::int64_t off;
};

// V4L2_EXPOSURE_MANUAL is 1.
constexpr std::array<AutomaticSwitch, 4> kAutomaticSwitches{
    {{capture::ColorAutomatic::Exposure, "auto_exposure", 1},
     {capture::ColorAutomatic::Gain, "gain_automatic", 0},
     {capture::ColorAutomatic::WhiteBalance, "white_balance_automatic", 0},
     {capture::ColorAutomatic::Hue, "hue_automatic", 0}}};

bool isDeviceNumber(const std::string& text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](unsigned char digit) { return std::isdigit(digit) != 0; });
}

std::optional<std::size_t> deviceAt(const std::string& location,
                                    std::span<const capture::CameraDevice> devices) {
  const std::string path = isDeviceNumber(location) ? "/dev/video" + location : location;
  const auto found = std::ranges::find_if(devices, [&](const capture::CameraDevice& device) {
    return device.path == path || device.stablePath == path;
  });
  return found == devices.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - devices.begin()));
}

/// The format that is requested from the device of a camera when it is opened. A camera with a
/// guessed calibration takes images of any size.
capture::DeviceFormat formatToOpen(const Project& project, std::size_t index) {
  const ProjectCamera& camera = project.cameras[index];
  capture::LiveCamera live;
  live.device = camera.device;
  live.rotateDegrees = camera.rotateDegrees;
  live.crop = camera.crop;
  if (!hasGuessedPose(project, index) || !hasGuessedLens(project, index)) {
    live.width = camera.camera.intrinsics.width;
    live.height = camera.camera.intrinsics.height;
  }
  return capture::requestedFormat(live);
}

} // namespace

CameraSource sourceOf(const capture::CameraDevice& device) {
  CameraSource source;
  source.kind = SourceKind::Device;
  source.location = device.stablePath.empty() ? device.path : device.stablePath;
  source.device.identity = device.identity;
  return source;
}

std::vector<capture::DeviceMatch>
matchProjectDevices(const Project& project, std::span<const capture::CameraDevice> devices) {
  std::vector<capture::DeviceMatch> matches(project.cameras.size());
  std::vector<std::size_t> known;
  std::vector<capture::DeviceIdentity> identities;
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    const ProjectCamera& camera = project.cameras[k];
    if (camera.source != SourceKind::Device) {
      continue;
    }
    if (camera.device.identity.isEmpty()) {
      matches[k].deviceIndex = deviceAt(camera.location, devices);
    } else {
      known.push_back(k);
      identities.push_back(camera.device.identity);
    }
  }
  const auto found = capture::matchDevices(identities, devices);
  for (std::size_t i = 0; i < known.size(); ++i) {
    matches[known[i]] = found[i];
  }
  return matches;
}

std::vector<capture::BandwidthShortage>
projectBandwidthShortages(const Project& project, std::span<const capture::CameraDevice> devices) {
  const auto matches = matchProjectDevices(project, devices);
  std::vector<capture::BandwidthRequest> requests;
  std::vector<std::size_t> cameras; // of the requests
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (!matches[k].deviceIndex) {
      continue;
    }
    const capture::CameraDevice& device = devices[*matches[k].deviceIndex];
    const capture::DeviceFormat format = formatToOpen(project, k);
    if (capture::isOffered(format, device.formats)) { // else it sends no images
      requests.push_back({device, format});
      cameras.push_back(k);
    }
  }
  auto shortages = capture::findBandwidthShortages(requests);
  for (capture::BandwidthShortage& shortage : shortages) {
    for (std::size_t& request : shortage.requestIndices) {
      request = cameras[request];
    }
    for (capture::BandwidthProposal& proposal : shortage.proposals) {
      proposal.requestIndex = cameras[proposal.requestIndex];
    }
  }
  return shortages;
}

std::vector<capture::ColorAutomatic>
automaticsOn(const std::vector<capture::DeviceControl>& controls) {
  std::vector<capture::ColorAutomatic> on;
  for (const AutomaticSwitch& one : kAutomaticSwitches) {
    const auto found = std::ranges::find(controls, one.name, &capture::DeviceControl::name);
    if (found != controls.end() && found->value != one.off) {
      on.push_back(one.automatic);
    }
  }
  return on;
}

} // namespace dewpoint::setup
