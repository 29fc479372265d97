// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/box_kernel.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// Returns the weighted histogram p of the color bins under a kernel with center (x, y), by
/// equations 7 and 8 of Sugandi et al. 2009. `bins` is an image of bin numbers (CV_16UC1, each
/// below `binCount`). The histogram sums to 1, or is all zero if no pixel under the kernel lies
/// inside the image.
std::vector<double> weightedHistogram(const cv::Mat& bins, int binCount, const BoxKernel& kernel,
                                      double x, double y);

/// Returns the Bhattacharyya coefficient rho[p, q] (equation 10 of Sugandi et al. 2009): 1 for
/// equal histograms, 0 for histograms without a common bin.
double bhattacharyyaCoefficient(const std::vector<double>& p, const std::vector<double>& q);

/// Computes the similarity rho (bhattacharyyaCoefficient()) between a reference histogram and the
/// histogram at many positions in an image. A color that is not in the reference adds nothing to
/// rho. Each image is therefore reduced once to the pixels whose colors are in the reference, and
/// only these pixels are counted. For each such pixel, the reference bin (slot) is stored instead
/// of the color. Pixels are added to eight sets of accumulators in turn, because with a single set,
/// an addition would often have to wait for the previous addition to the same number.
class HistogramSimilarity {
public:
  HistogramSimilarity(const std::vector<double>& reference, BoxKernel kernel);

  const BoxKernel& kernel() const { return kernel_; }
  /// Reads the bins of a part of an image. The part must contain every pixel that at() will read.
  void loadBins(const cv::Mat& bins, const cv::Rect& part);
  /// Reads the colors of a part of an image (CV_8UC3) as bins of rgbBin().
  void loadColors(const cv::Mat& bgr, const cv::Rect& part);
  /// Returns the similarity rho with the kernel's center at (x, y), in pixels from the upper left
  /// corner of the image. Returns 0 if no pixel under the kernel is inside the image. May be called
  /// from several threads at the same time.
  double at(double x, double y) const;
  /// Returns the approximate size of a copy, bytes.
  std::size_t memoryBytes() const {
    return sizeof(std::uint16_t) * (slotOfBin_.capacity() + before_.capacity()) +
           sizeof(float) * rootOfSlot_.capacity() + sizeof(std::uint32_t) * pixels_.capacity();
  }

private:
  void fit(const cv::Mat& image);
  void addRow(const std::uint16_t* bins, int row, int first, int count);
  double weightInside(const KernelPlacement& placement) const;

  BoxKernel kernel_;
  std::vector<std::uint16_t> slotOfBin_; ///< slot of each bin; 0: not in the reference
  std::vector<float> rootOfSlot_;        ///< square root of the reference value; 0 in slot 0
  std::vector<std::uint32_t> pixels_;    ///< pixels with a slot, row by row: column and slot
  std::vector<std::uint16_t>
      before_; ///< number of these pixels to the left of each column in the row
  int columns_ = 0;
  int rows_ = 0;
};

} // namespace dewpoint::observation
