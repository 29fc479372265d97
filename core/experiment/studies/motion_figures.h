// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/report/experiment_options.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::experiment {

/// How well a motion mask covers the people in an image.
struct MaskQuality {
  int regions = 0;        ///< connected regions (8 neighbors) of at least kSmallestRegion pixels
  double recall = 0.0;    ///< share of the people's pixels that the mask has; 1 without people
  double precision = 0.0; ///< share of the mask's pixels that are people's; 1 of an empty mask
};

/// Pixels; smaller regions are noise; chosen.
inline constexpr int kSmallestRegion = 20;

/// Of a mask (CV_8UC1, 0 or 255) against the people that are there (CV_8UC1, not 0 where one is).
MaskQuality maskQuality(const cv::Mat& mask, const cv::Mat& people);

/// Mohedano et al. 2009, figures 1 (image, motion mask and motion likelihood image D) and 3 (motion
/// masks over some frames), in the simulated office, as FigureExperiment::run.
Status mohedanoMotionFigures(const ExperimentOptions& options);

} // namespace dewpoint::experiment
