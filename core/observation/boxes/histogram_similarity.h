// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/box_kernel.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// Weighted histogram p of the bins (CV_16UC1, each below `binCount`) under a kernel with center
/// (x, y): equations 7 and 8 of Sugandi et al. 2009. It sums to 1 over the pixels within the image;
/// all zero if there are none.
std::vector<double> weightedHistogram(const cv::Mat& bins, int binCount, const BoxKernel& kernel,
                                      double x, double y);

/// Bhattacharyya coefficient rho[p, q] (equation 10): 1 for equal histograms, 0 for histograms
/// without a common bin.
double bhattacharyyaCoefficient(const std::vector<double>& p, const std::vector<double>& q);

/// Similarity rho between a reference histogram and the histogram at many positions in an image. A
/// color that is not in the reference adds nothing to rho. Each image is therefore reduced once to
/// the pixels whose colors are in the reference; they store the reference's bin (slot) instead of
/// the color, and only they are counted. Counts go to eight sets of accumulators in turn.
/// Neighboring pixels often have the same color, and repeated additions to one number would have to
/// wait for each other.
class HistogramSimilarity {
public:
  HistogramSimilarity(const std::vector<double>& reference, BoxKernel kernel);

  const BoxKernel& kernel() const { return kernel_; }
  /// Reads the bins of a part of an image. The part must contain every pixel that at() will read.
  void show(const cv::Mat& bins, const cv::Rect& part);
  /// Reads the colors of a part of an image (CV_8UC3) as bins of rgbBin().
  void showColors(const cv::Mat& bgr, const cv::Rect& part);
  /// Similarity rho with the kernel's center at (x, y), pixels from the image's corner; 0 if no
  /// pixel is in the image. May be called from several threads.
  double at(double x, double y) const;
  /// Approximate size of a copy, bytes.
  std::size_t memoryBytes() const {
    return sizeof(std::uint16_t) * (slotOfBin_.capacity() + before_.capacity()) +
           sizeof(float) * rootOfSlot_.capacity() + sizeof(std::uint32_t) * pixels_.capacity();
  }

private:
  void fit(const cv::Mat& image);
  void takeRow(const std::uint16_t* bins, int row, int first, int count);
  double weightInside(const KernelPlacement& placement) const;

  BoxKernel kernel_;
  std::vector<std::uint16_t> slotOfBin_; ///< slot of each bin; 0: not in the reference
  std::vector<float> rootOfSlot_;        ///< square root of the reference's share; 0 in slot 0
  std::vector<std::uint32_t> pixels_;    ///< pixels with a slot, row by row: column and slot
  std::vector<std::uint16_t> before_;    ///< number of them left of each column of the row
  int columns_ = 0;
  int rows_ = 0;
};

} // namespace dewpoint::observation
