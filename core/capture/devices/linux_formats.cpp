// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef __linux__
#include "core/capture/devices/linux_formats.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <linux/videodev2.h>
#include <utility>

namespace dewpoint::capture {
namespace {

constexpr std::uint32_t kMostEntries = 1024; ///< of a list: a driver that never ends is broken
constexpr std::array<std::pair<std::uint32_t, std::uint32_t>, 11> kUsualSizes{{{320, 240},
                                                                               {640, 360},
                                                                               {640, 480},
                                                                               {800, 600},
                                                                               {960, 540},
                                                                               {1024, 768},
                                                                               {1280, 720},
                                                                               {1280, 960},
                                                                               {1920, 1080},
                                                                               {2560, 1440},
                                                                               {3840, 2160}}};
constexpr std::array<double, 10> kUsualRates{120, 100, 90, 60, 50, 30, 25, 20, 15, 10};

std::string textOfCode(std::uint32_t code) {
  std::string text;
  for (int shift = 0; shift < 32; shift += 8) {
    const auto letter = static_cast<char>((code >> shift) & 0x7fU); // bit 31 says big-endian
    text += letter >= ' ' && letter < 127 ? letter : '?';
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

double intervalRate(const v4l2_fract& interval) {
  return interval.numerator > 0 ? static_cast<double>(interval.denominator) / interval.numerator
                                : 0.0;
}

std::vector<double> ratesOf(LinuxNode& node, std::uint32_t code, std::uint32_t width,
                            std::uint32_t height) {
  std::vector<double> rates;
  for (std::uint32_t index = 0; index < kMostEntries; ++index) {
    v4l2_frmivalenum entry{};
    entry.index = index;
    entry.pixel_format = code;
    entry.width = width;
    entry.height = height;
    if (node.callIoctl(VIDIOC_ENUM_FRAMEINTERVALS, entry) != 0) {
      break;
    }
    if (entry.type == V4L2_FRMIVAL_TYPE_DISCRETE) {
      rates.push_back(intervalRate(entry.discrete));
      continue;
    }
    const double fastest = intervalRate(entry.stepwise.min);
    const double slowest = intervalRate(entry.stepwise.max);
    rates.insert(rates.end(), {fastest, slowest});
    std::ranges::copy_if(kUsualRates, std::back_inserter(rates),
                         [&](double rate) { return rate > slowest && rate < fastest; });
    break;
  }
  std::erase_if(rates, [](double rate) { return rate <= 0.0; });
  std::ranges::sort(rates, std::greater());
  rates.erase(std::unique(rates.begin(), rates.end()), rates.end());
  return rates;
}

using Sizes = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

bool isStep(std::uint32_t value, std::uint32_t least, std::uint32_t most, std::uint32_t step) {
  return value >= least && value <= most && (value - least) % std::max(step, 1U) == 0;
}

Sizes sizesInRange(const v4l2_frmsize_stepwise& range) {
  Sizes sizes;
  std::ranges::copy_if(kUsualSizes, std::back_inserter(sizes), [&](const auto& size) {
    return isStep(size.first, range.min_width, range.max_width, range.step_width) &&
           isStep(size.second, range.min_height, range.max_height, range.step_height);
  });
  sizes.insert(sizes.end(),
               {{range.max_width, range.max_height}, {range.min_width, range.min_height}});
  return sizes;
}

Sizes sizesOf(LinuxNode& node, std::uint32_t code, bool& hasRange) {
  Sizes sizes;
  for (std::uint32_t index = 0; index < kMostEntries; ++index) {
    v4l2_frmsizeenum entry{};
    entry.index = index;
    entry.pixel_format = code;
    if (node.callIoctl(VIDIOC_ENUM_FRAMESIZES, entry) != 0) {
      break;
    }
    if (entry.type != V4L2_FRMSIZE_TYPE_DISCRETE) {
      hasRange = true;
      sizes = sizesInRange(entry.stepwise);
      break;
    }
    sizes.emplace_back(entry.discrete.width, entry.discrete.height);
  }
  const auto area = [](const auto& size) { return std::uint64_t{size.first} * size.second; };
  std::ranges::stable_sort(sizes, std::greater(), area);
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

} // namespace

std::vector<OfferedFormat> readLinuxFormats(LinuxNode& node) {
  std::vector<OfferedFormat> formats;
  for (std::uint32_t index = 0; index < kMostEntries; ++index) {
    v4l2_fmtdesc entry{};
    entry.index = index;
    entry.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (node.callIoctl(VIDIOC_ENUM_FMT, entry) != 0) {
      break;
    }
    OfferedFormat& format = formats.emplace_back();
    format.pixelFormat = textOfCode(entry.pixelformat);
    format.description = reinterpret_cast<const char*>(entry.description);
    format.isCompressed = (entry.flags & V4L2_FMT_FLAG_COMPRESSED) != 0;
    for (const auto& [width, height] : sizesOf(node, entry.pixelformat, format.hasOtherSizes)) {
      format.sizes.push_back({static_cast<int>(width), static_cast<int>(height),
                              ratesOf(node, entry.pixelformat, width, height)});
    }
  }
  return formats;
}

} // namespace dewpoint::capture
#endif
