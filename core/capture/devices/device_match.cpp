// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/device_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dewpoint::capture {
namespace {

bool contradicts(const std::string& a, const std::string& b) {
  return !a.empty() && !b.empty() && a != b;
}

bool isSameModel(const DeviceIdentity& wanted, const DeviceIdentity& present) {
  return !contradicts(wanted.vendorAndProductId, present.vendorAndProductId) &&
         !contradicts(wanted.name, present.name);
}

/// Whether the model is known to be the same, rather than not known to differ.
bool isKnownModel(const DeviceIdentity& wanted, const DeviceIdentity& present) {
  const bool hasProduct = !wanted.vendorAndProductId.empty() && !present.vendorAndProductId.empty();
  const bool hasName = !wanted.name.empty() && !present.name.empty();
  return (hasProduct || hasName) && isSameModel(wanted, present);
}

bool isSameUnit(const DeviceIdentity& wanted, const DeviceIdentity& present) {
  return !wanted.serial.empty() && wanted.serial == present.serial && isSameModel(wanted, present);
}

bool isAtSameBus(const DeviceIdentity& wanted, const DeviceIdentity& present) {
  return !wanted.bus.empty() && wanted.bus == present.bus && isSameModel(wanted, present) &&
         !contradicts(wanted.serial, present.serial);
}

bool mayBeMoved(const DeviceIdentity& wanted, const DeviceIdentity& present) {
  return isKnownModel(wanted, present) && !contradicts(wanted.serial, present.serial);
}

using MatchRule = bool (*)(const DeviceIdentity&, const DeviceIdentity&);

class DeviceMatching {
public:
  DeviceMatching(std::span<const DeviceIdentity> identities, std::span<const CameraDevice> devices)
      : identities_(identities), devices_(devices), matches_(identities.size()),
        taken_(devices.size(), false) {}

  /// Gives a device to each camera that alone claims exactly this one by the rule.
  void apply(MatchRule rule, MatchBasis basis) {
    std::vector<std::vector<std::size_t>> claimed(identities_.size());
    std::vector<int> claims(devices_.size(), 0);
    for (std::size_t k = 0; k < identities_.size(); ++k) {
      claimed[k] = matches_[k].deviceIndex ? std::vector<std::size_t>() : fitting(k, rule);
      for (const std::size_t device : claimed[k]) {
        ++claims[device];
      }
    }
    for (std::size_t k = 0; k < identities_.size(); ++k) {
      if (claimed[k].size() == 1 && claims[claimed[k].front()] == 1) {
        matches_[k].deviceIndex = claimed[k].front();
        matches_[k].basis = basis;
        taken_[claimed[k].front()] = true;
      }
    }
  }

  std::vector<DeviceMatch> finished() {
    for (std::size_t k = 0; k < identities_.size(); ++k) {
      if (!matches_[k].deviceIndex) {
        matches_[k].candidateIndices =
            fitting(k, [](const DeviceIdentity& wanted, const DeviceIdentity& present) {
              return isKnownModel(wanted, present) || isAtSameBus(wanted, present);
            });
      }
    }
    return std::move(matches_);
  }

private:
  std::vector<std::size_t> fitting(std::size_t identity, MatchRule rule) const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < devices_.size(); ++k) {
      if (!taken_[k] && rule(identities_[identity], devices_[k].identity)) {
        found.push_back(k);
      }
    }
    return found;
  }

  std::span<const DeviceIdentity> identities_;
  std::span<const CameraDevice> devices_;
  std::vector<DeviceMatch> matches_;
  std::vector<bool> taken_; ///< of the devices
};

} // namespace

std::vector<DeviceMatch> matchDevices(std::span<const DeviceIdentity> identities,
                                      std::span<const CameraDevice> devices) {
  DeviceMatching matching(identities, devices);
  matching.apply(isSameUnit, MatchBasis::Serial);
  matching.apply(isAtSameBus, MatchBasis::Bus);
  matching.apply(mayBeMoved, MatchBasis::Name);
  return matching.finished();
}

DeviceMatch matchDevice(const DeviceIdentity& identity, std::span<const CameraDevice> devices) {
  return matchDevices({&identity, 1}, devices).front();
}

std::string mismatchReason(const DeviceMatch& match, const DeviceIdentity& identity,
                           std::span<const CameraDevice> devices) {
  if (match.deviceIndex) {
    return {};
  }
  if (match.isMissing()) {
    return fmt::format("{} is not connected", describe(identity));
  }
  std::string names;
  for (const std::size_t candidate : match.candidateIndices) {
    names += fmt::format("{}'{}' at {}", names.empty() ? "" : ", ",
                         devices[candidate].identity.name, devices[candidate].path);
  }
  return fmt::format("it is not certain which device is {}: {}; select the device of this camera "
                     "again",
                     describe(identity), names);
}

} // namespace dewpoint::capture
