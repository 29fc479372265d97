// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/box_histogram.h"

#include "core/color/rgb_bins.h"
#include "core/observation/boxes/box_kernel.h"
#include "core/observation/boxes/histogram_similarity.h"

#include <opencv2/core.hpp>

#include <algorithm>

namespace dewpoint::observation {

std::vector<double> boxHistogram(const cv::Mat& bgr, const ImageBox& box) {
  const BoxKernel kernel(box);
  const Eigen::Vector2d center = box.center();
  if (bgr.empty() || !center.allFinite()) {
    return {};
  }
  const KernelPlacement placement = placeKernel(kernel, center.x(), center.y(), bgr.cols, bgr.rows);
  if (placement.isEmpty()) {
    return {};
  }
  // Only the pixels of the box: the bins of a whole image would take longer than all else.
  const cv::Rect part(
      placement.imageLeft + placement.firstColumn, placement.imageTop + placement.firstRow,
      placement.endColumn - placement.firstColumn, placement.endRow - placement.firstRow);
  const cv::Mat pixels = bgr(part);
  std::vector<double> histogram(kRgbBinCount, 0.0);
  double sum = 0.0;
  for (int row = 0; row < part.height; ++row) {
    const auto* from = pixels.ptr<cv::Vec3b>(row);
    const auto* weights = kernel.row(placement.firstRow + row) + placement.firstColumn;
    for (int column = 0; column < part.width; ++column) {
      const cv::Vec3b& color = from[column];
      histogram[rgbBin(color[0], color[1], color[2])] += weights[column];
      sum += weights[column];
    }
  }
  for (double& share : histogram) {
    share /= std::max(sum, 1.0);
  }
  return histogram;
}

} // namespace dewpoint::observation
