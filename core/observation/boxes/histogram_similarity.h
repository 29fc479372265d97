// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/box_kernel.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// The weighted histogram p of the bins (CV_16UC1, each below `binCount`) under a kernel whose
/// center is (x, y): equations 7 and 8 of Sugandi et al. 2009. It sums to 1 over the pixels within
/// the image; all zero when there are none.
std::vector<double> weightedHistogram(const cv::Mat& bins, int binCount, const BoxKernel& kernel,
                                      double x, double y);

/// rho[p, q] of equation 10: 1 for equal histograms, 0 for those without a common bin.
double bhattacharyyaCoefficient(const std::vector<double>& p, const std::vector<double>& q);

/// rho between a reference histogram and the histogram at many positions in an image. A color that
/// is not in the reference adds nothing to rho: each image is reduced once to the pixels whose
/// colors are, with the reference's bin (slot) instead of the color, and only those are counted.
/// Counts go to eight sets of accumulators in turn: neighboring pixels are of one color, and adding
/// to the same number again and again would wait each time.
class HistogramSimilarity {
public:
  HistogramSimilarity(const std::vector<double>& reference, BoxKernel kernel);

  const BoxKernel& kernel() const { return kernel_; }
  /// Takes the bins of a part of an image, which must hold every pixel that at() will read.
  void show(const cv::Mat& bins, const cv::Rect& part);
  /// Takes the bins of a part of a color image (CV_8UC3), by rgbBin().
  void showColors(const cv::Mat& bgr, const cv::Rect& part);
  /// rho at a center (x, y), pixels from the image's corner; 0 where no pixel is in the image.
  /// May be called from several threads.
  double at(double x, double y) const;
  /// About how many bytes a copy takes.
  std::size_t memoryBytes() const {
    return sizeof(std::uint16_t) * (slotOfBin_.capacity() + before_.capacity()) +
           sizeof(float) * rootOfSlot_.capacity() + sizeof(std::uint32_t) * pixels_.capacity();
  }

private:
  void fit(const cv::Mat& image);
  void takeRow(const std::uint16_t* bins, int row, int first, int count);
  double weightInside(const KernelPlacement& placement) const;

  BoxKernel kernel_;
  std::vector<std::uint16_t> slotOfBin_; ///< 0: not in the reference
  std::vector<float> rootOfSlot_;        ///< square root of the reference's share; 0 in slot 0
  std::vector<std::uint32_t> pixels_;    ///< of each row those with a slot: column and slot
  std::vector<std::uint16_t> before_;    ///< how many of them are left of each column of the row
  int columns_ = 0;
  int rows_ = 0;
};

} // namespace dewpoint::observation
