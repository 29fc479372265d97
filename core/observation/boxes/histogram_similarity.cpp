// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/histogram_similarity.h"

#include "core/base/vector_kernel.h"
#include "core/color/rgb_bins.h"

#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

namespace dewpoint::observation {
namespace {

constexpr int kSets = 8;
constexpr std::size_t kMostSlots = 1024;
/// From one set to the next: a cache line more than a page, so that sets do not share cache sets.
constexpr std::size_t kStride = kMostSlots + 16;
constexpr std::size_t kStrands = 4;
/// A pixel in one word: its column above its slot.
constexpr int kColumnShift = 16;
constexpr std::uint32_t kSlotMask = (1U << kColumnShift) - 1U;

/// What some pixels of one row add to the sets. `weights`: of the columns from `left` on.
void addPixels(const std::uint32_t* pixels, std::ptrdiff_t count, const std::uint32_t* weights,
               std::ptrdiff_t left, std::uint32_t* sums) {
  std::ptrdiff_t i = 0;
  for (; i + kSets <= count; i += kSets) {
    for (std::ptrdiff_t k = 0; k < kSets; ++k) {
      const std::uint32_t pixel = pixels[i + k];
      sums[std::size_t(k) * kStride + (pixel & kSlotMask)] +=
          weights[std::ptrdiff_t(pixel >> kColumnShift) - left];
    }
  }
  for (; i < count; ++i) {
    sums[std::size_t(i % kSets) * kStride + (pixels[i] & kSlotMask)] +=
        weights[std::ptrdiff_t(pixels[i] >> kColumnShift) - left];
  }
}

/// The square root of each slot's sum over the sets, times that of the reference.
struct SlotKernel {
  DEWPOINT_KERNEL void run(const std::uint32_t* sums, const float* roots, int count, float* terms) {
    for (int slot = 0; slot < count; ++slot) {
      std::uint32_t sum = sums[slot];
      for (std::size_t set = 1; set < kSets; ++set) {
        sum += sums[set * kStride + std::size_t(slot)];
      }
      terms[slot] = roots[slot] * std::sqrt(float(static_cast<std::int32_t>(sum))); // below 2^31
    }
  }
};

struct RgbBinKernel {
  DEWPOINT_KERNEL void run(const std::uint8_t* bgr, int count, std::uint16_t* bins) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      bins[i] = rgbBin(bgr[3 * i], bgr[3 * i + 1], bgr[3 * i + 2]);
    }
  }
};

/// In four strands, so that additions need not wait for each other.
double sumOf(const float* terms, std::size_t count) {
  std::array<double, kStrands> sums{};
  std::size_t i = 0;
  for (; i + kStrands <= count; i += kStrands) {
    for (std::size_t strand = 0; strand < kStrands; ++strand) {
      sums[strand] += double(terms[i + strand]);
    }
  }
  for (; i < count; ++i) {
    sums[0] += double(terms[i]);
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace

std::vector<double> weightedHistogram(const cv::Mat& bins, int binCount, const BoxKernel& kernel,
                                      double x, double y) {
  std::vector<double> histogram(std::size_t(binCount), 0.0);
  const KernelPlacement placement = placeKernel(kernel, x, y, bins.cols, bins.rows);
  for (int row = placement.firstRow; row < placement.endRow; ++row) {
    const auto* from = bins.ptr<std::uint16_t>(placement.imageTop + row);
    for (int column = placement.firstColumn; column < placement.endColumn; ++column) {
      histogram[from[placement.imageLeft + column]] += kernel.row(row)[column];
    }
  }
  const double sum = std::accumulate(histogram.begin(), histogram.end(), 0.0);
  for (double& share : histogram) {
    share /= std::max(sum, 1.0);
  }
  return histogram;
}

double bhattacharyyaCoefficient(const std::vector<double>& p, const std::vector<double>& q) {
  assert(p.size() == q.size());
  double sum = 0.0;
  for (std::size_t bin = 0; bin < p.size(); ++bin) {
    sum += std::sqrt(p[bin] * q[bin]);
  }
  return sum;
}

HistogramSimilarity::HistogramSimilarity(const std::vector<double>& reference, BoxKernel kernel)
    : kernel_(std::move(kernel)), slotOfBin_(reference.size(), 0), rootOfSlot_{0.0F} {
  for (std::size_t bin = 0; bin < reference.size(); ++bin) {
    if (reference[bin] > 0.0) {
      slotOfBin_[bin] = static_cast<std::uint16_t>(rootOfSlot_.size());
      rootOfSlot_.push_back(static_cast<float>(std::sqrt(reference[bin])));
    }
  }
  assert(rootOfSlot_.size() <= kMostSlots);
}

void HistogramSimilarity::fit(const cv::Mat& image) {
  assert(std::uint32_t(image.cols) <= kSlotMask);
  columns_ = image.cols;
  rows_ = image.rows;
  pixels_.resize(image.total());
  before_.resize(std::size_t(columns_ + 1) * std::size_t(rows_));
}

void HistogramSimilarity::addRow(const std::uint16_t* bins, int row, int first, int count) {
  std::uint32_t* pixels = pixels_.data() + std::ptrdiff_t(row) * columns_;
  std::uint16_t* before = before_.data() + std::ptrdiff_t(row) * (columns_ + 1) + first;
  std::uint32_t found = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t slot = slotOfBin_[bins[i]];
    before[i] = static_cast<std::uint16_t>(found);
    pixels[found] = (std::uint32_t(first + i) << kColumnShift) | slot;
    found += slot != 0 ? 1U : 0U;
  }
  before[count] = static_cast<std::uint16_t>(found);
}

void HistogramSimilarity::loadBins(const cv::Mat& bins, const cv::Rect& part) {
  fit(bins);
  for (int row = part.y; row < part.y + part.height; ++row) {
    addRow(bins.ptr<std::uint16_t>(row) + part.x, row, part.x, part.width);
  }
}

void HistogramSimilarity::loadColors(const cv::Mat& bgr, const cv::Rect& part) {
  assert(slotOfBin_.size() == kRgbBinCount);
  fit(bgr);
  std::vector<std::uint16_t> bins(std::size_t(part.width));
  for (int row = part.y; row < part.y + part.height; ++row) {
    const auto* from = bgr.ptr<std::uint8_t>(row) + 3 * std::ptrdiff_t(part.x);
    runKernel<RgbBinKernel>(from, part.width, bins.data());
    addRow(bins.data(), row, part.x, part.width);
  }
}

/// Of the part of the kernel that lies in the image.
double HistogramSimilarity::weightInside(const KernelPlacement& placement) const {
  std::uint64_t sum = 0;
  for (int row = placement.firstRow; row < placement.endRow; ++row) {
    const std::uint32_t* weights = kernel_.row(row);
    sum = std::accumulate(weights + placement.firstColumn, weights + placement.endColumn, sum);
  }
  return double(sum);
}

double HistogramSimilarity::at(double x, double y) const {
  const KernelPlacement placement = placeKernel(kernel_, x, y, columns_, rows_);
  if (placement.isEmpty()) {
    return 0.0;
  }
  const std::size_t slotCount = rootOfSlot_.size();
  std::array<std::uint32_t, kSets * kStride> sums;
  for (std::size_t set = 0; set < kSets; ++set) {
    std::fill_n(sums.begin() + std::ptrdiff_t(set * kStride), slotCount, 0U);
  }
  for (int row = placement.firstRow; row < placement.endRow; ++row) {
    const std::ptrdiff_t imageRow = placement.imageTop + row;
    const std::uint16_t* before = before_.data() + imageRow * (columns_ + 1);
    const std::ptrdiff_t first = before[placement.imageLeft + placement.firstColumn];
    const std::ptrdiff_t end = before[placement.imageLeft + placement.endColumn];
    addPixels(pixels_.data() + imageRow * columns_ + first, end - first, kernel_.row(row),
              placement.imageLeft, sums.data());
  }
  std::array<float, kMostSlots> terms;
  runKernel<SlotKernel>(sums.data(), rootOfSlot_.data(), static_cast<int>(slotCount), terms.data());
  const bool whole = placement.endColumn - placement.firstColumn == kernel_.width() &&
                     placement.endRow - placement.firstRow == kernel_.height();
  const double inside = whole ? kernel_.sum() : weightInside(placement);
  return inside > 0.0 ? sumOf(terms.data(), slotCount) / std::sqrt(inside) : 0.0;
}

} // namespace dewpoint::observation
