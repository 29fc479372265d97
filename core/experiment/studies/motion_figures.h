// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::experiment {

/// Agreement of a motion mask with the visible people in an image.
struct MaskQuality {
  int regionCount =
      0; ///< number of connected regions (8 neighbors) of at least kMinRegionArea pixels
  double recall = 0.0; ///< fraction of the people's pixels that are in the mask; 1 without people
  double precision = 0.0; ///< fraction of the mask's pixels that are on people; 1 for an empty mask
};

/// Minimum area, in pixels, of a region of a motion mask. Smaller regions are considered noise.
/// Chosen by judgment.
inline constexpr int kMinRegionArea = 20;

/// Compares a motion mask (CV_8UC1, 0 or 255) with the pixels of people (CV_8UC1, nonzero on a
/// person).
MaskQuality measureMaskQuality(const cv::Mat& mask, const cv::Mat& people);

/// Reproduces figures 1 (image, motion mask and motion likelihood image D) and 3 (motion masks over
/// some frames) of Mohedano et al. 2009 in the simulated office. This is a function for
/// FigureExperiment::run.
Status writeMohedanoMotionFigures(const ExperimentOptions& options);

} // namespace dewpoint::experiment
