// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/geometry/projector.h"
#include "core/tracking/camera_report.h"
#include "core/tracking/track_estimate.h"
#include "core/tracking/tracker_diagnostics.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>

// Reports of the `barrera` method about its target that supplement the estimate. `image` is one
// camera's image (CV_8UC3; empty if there is none), and `color` that of the target.
namespace dewpoint::tracking {

/// Returns whether camera number `camera` confirms the target of an estimate, and the reason if it
/// does not.
CameraReport explainByColor(const cv::Mat& image, const ColorClassifier& color,
                            const Projector& projector, const SphereEstimate& estimate,
                            std::size_t camera);

/// Returns the log likelihood of the color window (ColorWindow) around each pixel, up to `reach`
/// pixels from the projection of a position (meters, world frame) in each direction. Empty if the
/// position is not in view.
LikelihoodMap windowLikelihoodMap(const cv::Mat& image, const ColorClassifier& color,
                                  const Projector& projector, const Eigen::Vector3d& position,
                                  int reach);

} // namespace dewpoint::tracking
