// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/geometry/projector.h"
#include "core/tracking/camera_report.h"
#include "core/tracking/track_estimate.h"
#include "core/tracking/tracker_diagnostics.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>

// Reports of the `barrera` method about its target that supplement the estimate. `image` is the
// image of one camera (CV_8UC3; empty if the camera has no image), and `color` tests for the
// target's color.
namespace dewpoint::tracking {

/// Returns whether camera number `camera` confirms the target at the position of an estimate, and
/// the reason if the camera does not. `image` is the image of this camera.
CameraReport reportByColor(const cv::Mat& image, const ColorClassifier& color,
                           const Projector& projector, const SphereEstimate& estimate,
                           std::size_t camera);

/// Returns a map of the log likelihood of the color window (ColorWindow) around each pixel. The map
/// extends up to `reach` pixels in each direction from the projection of `position` (meters, world
/// frame). The map is empty if the position is not in view.
LikelihoodMap windowLikelihoodMap(const cv::Mat& image, const ColorClassifier& color,
                                  const Projector& projector, const Eigen::Vector3d& position,
                                  int reach);

} // namespace dewpoint::tracking
