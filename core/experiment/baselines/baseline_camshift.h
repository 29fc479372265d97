// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/baseline_tracker.h"

#include <opencv2/core/types.hpp>

namespace dewpoint::experiment {

/// OpenCV's CamShift (Bradski 1998) in each camera, with the color mask as its probability image,
/// so that it sees what the other methods see. A window starts, and starts again when it has lost
/// its color, as the box of the largest blob. The position is the center of mass in the window, not
/// the rounded center that CamShift itself returns.
class CamShiftFinder final : public BearingFinder {
public:
  void forget() override { windows_.clear(); }
  std::vector<std::optional<Eigen::Vector2d>> find(const std::vector<cv::Mat>& masks) override;

private:
  std::vector<cv::Rect> windows_; ///< per camera; empty when lost
};

} // namespace dewpoint::experiment
