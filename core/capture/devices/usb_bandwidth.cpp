// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/devices/usb_bandwidth.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

namespace dewpoint::capture {
namespace {

// Judgments.
constexpr double kUsableShare = 0.8; ///< of a bus: the rest is protocol
constexpr double kUnknownRate = 30.0;
constexpr double kLowestRate = 10.0; ///< of a proposal, images per second
/// Of one pixel: JPEG of a scene full of detail; video codecs need a tenth of it.
constexpr double kJpegBits = 3.0;
constexpr double kVideoBits = 0.3;
constexpr double kRawBits = 16.0; ///< of a format that is not in the table

constexpr std::array<std::pair<std::string_view, double>, 22> kPixelBits{{
    {"MJPG", kJpegBits},  {"JPEG", kJpegBits},  {"H264", kVideoBits}, {"HEVC", kVideoBits},
    {"VP80", kVideoBits}, {"VP90", kVideoBits}, {"YUYV", 16.0},       {"UYVY", 16.0},
    {"YVYU", 16.0},       {"Y16", 16.0},        {"RGBP", 16.0},       {"NV12", 12.0},
    {"NV21", 12.0},       {"YU12", 12.0},       {"YV12", 12.0},       {"RGB3", 24.0},
    {"BGR3", 24.0},       {"GREY", 8.0},        {"BA81", 8.0},        {"GBRG", 8.0},
    {"GRBG", 8.0},        {"RGGB", 8.0},
}};

/// A format that could be proposed, with what it needs.
struct Choice {
  DeviceFormat format;
  double bits = 0.0;
  bool isCompressed = false;
};

double areaOf(const DeviceFormat& format) {
  return static_cast<double>(format.width) * format.height;
}

double rateOrUsual(const DeviceFormat& format) {
  return format.frameRate > 0.0 ? format.frameRate : kUnknownRate;
}

/// All that a device offers and that is not more than requested.
std::vector<Choice> choicesOf(const CameraDevice& device, const DeviceFormat& requested) {
  std::vector<Choice> choices;
  for (const OfferedFormat& format : device.formats) {
    for (const OfferedSize& size : format.sizes) {
      for (const double rate : size.frameRates) {
        const DeviceFormat one{format.pixelFormat, size.width, size.height, rate};
        const bool isMore = areaOf(one) > areaOf(requested) || rate > rateOrUsual(requested) + 0.01;
        const bool isSlow = rate < std::min(kLowestRate, rateOrUsual(requested));
        if (!isMore && !isSlow) {
          choices.push_back({one, bitsPerSecond(one), format.isCompressed});
        }
      }
    }
  }
  return choices;
}

/// The nearest choice that needs less: the same size before a smaller one, then the higher rate,
/// then compressed images before others.
std::optional<DeviceFormat> lighter(const std::vector<Choice>& choices, double bits) {
  const Choice* best = nullptr;
  const auto rank = [](const Choice& one) {
    return std::tuple(areaOf(one.format), one.format.frameRate, one.isCompressed, one.bits);
  };
  for (const Choice& one : choices) {
    if (one.bits < bits && (best == nullptr || rank(one) > rank(*best))) {
      best = &one;
    }
  }
  return best == nullptr ? std::nullopt : std::optional(best->format);
}

/// A request on a bus while proposals are looked for.
struct Load {
  std::size_t request = 0;
  DeviceFormat format;
  double bits = 0.0;
  double own = 0.0; ///< capacity of the device's own connection, bits per second
  std::vector<Choice> choices;
  bool isChanged = false;
};

double sumOf(const std::vector<Load>& loads) {
  double sum = 0.0;
  for (const Load& load : loads) {
    sum += load.bits;
  }
  return sum;
}

/// Whether each device's own connection can carry its images.
bool fitsAlone(const std::vector<Load>& loads) {
  return std::ranges::all_of(loads, [](const Load& load) { return load.bits <= load.own; });
}

bool fits(const std::vector<Load>& loads, double available) {
  return sumOf(loads) <= available && fitsAlone(loads);
}

/// Makes the load lighter by one step. Returns whether that was possible.
bool lighten(Load& load) {
  const auto format = lighter(load.choices, load.bits);
  if (format) {
    load.format = *format;
    load.bits = bitsPerSecond(*format);
    load.isChanged = true;
  }
  return format.has_value();
}

/// Changes the heaviest request, again and again, until all fit.
std::vector<BandwidthProposal> proposalsFor(std::vector<Load> loads, double available) {
  const auto isHeavier = [](const Load& a, const Load& b) { return a.bits > b.bits; };
  while (!fits(loads, available)) {
    std::ranges::stable_sort(loads, isHeavier);
    // What its own connection cannot carry comes first, else the heaviest that can be changed.
    auto changed = std::ranges::find_if(loads, [](const Load& one) { return one.bits > one.own; });
    bool isLighter = changed != loads.end() && lighten(*changed);
    for (changed = loads.begin(); !isLighter && fitsAlone(loads) && changed != loads.end();
         ++changed) {
      isLighter = lighten(*changed);
    }
    if (!isLighter) {
      return {};
    }
  }
  std::vector<BandwidthProposal> proposals;
  for (const Load& load : loads) {
    if (load.isChanged) {
      proposals.push_back({load.request, load.format});
    }
  }
  std::ranges::sort(proposals, {}, &BandwidthProposal::requestIndex);
  return proposals;
}

} // namespace

double bitsPerSecond(const DeviceFormat& format) {
  const auto* const known = std::ranges::find(kPixelBits, std::string_view(format.pixelFormat),
                                              &std::pair<std::string_view, double>::first);
  return areaOf(format) * rateOrUsual(format) *
         (known == kPixelBits.end() ? kRawBits : known->second);
}

std::vector<BandwidthShortage> findBandwidthShortages(std::span<const BandwidthRequest> requests) {
  constexpr double kMega = 1e6;
  std::map<int, std::vector<Load>> buses;
  std::map<int, double> available;
  for (std::size_t k = 0; k < requests.size(); ++k) {
    const auto& [device, format] = requests[k];
    if (device.usbLink.busNumber == 0 || device.usbLink.busMbitPerSecond <= 0.0) {
      continue;
    }
    Load load;
    load.request = k;
    load.format = completedFormat(format, device.formats);
    load.bits = bitsPerSecond(load.format);
    load.own = kUsableShare * kMega * device.usbLink.deviceMbitPerSecond;
    load.choices = choicesOf(device, load.format);
    buses[device.usbLink.busNumber].push_back(std::move(load));
    available[device.usbLink.busNumber] = kUsableShare * kMega * device.usbLink.busMbitPerSecond;
  }
  std::vector<BandwidthShortage> shortages;
  for (const auto& [bus, loads] : buses) {
    if (fits(loads, available[bus])) {
      continue;
    }
    BandwidthShortage& shortage = shortages.emplace_back();
    shortage.busNumber = bus;
    shortage.neededBitsPerSecond = sumOf(loads);
    shortage.availableBitsPerSecond = available[bus];
    for (const Load& load : loads) {
      shortage.requestIndices.push_back(load.request);
    }
    shortage.proposals = proposalsFor(loads, available[bus]);
  }
  return shortages;
}

} // namespace dewpoint::capture
