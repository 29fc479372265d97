// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

namespace dewpoint::tracking {

/// Candidate position of a target.
struct CandidatePosition {
  enum class Kind {
    Existing,   ///< tracked before this frame
    New,        ///< found in the images of this frame
    Distractor, ///< another object that looks like the target
  };
  Kind kind = Kind::Existing;
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< meters, world frame
  double radius = 0.0;                                ///< radius of the target, meters
  double probability = 0.0;        ///< probability that the target is at this position
  double logLikelihoodRatio = 0.0; ///< log likelihood ratio of the position, sum over all cameras
};

/// Log likelihood around a target in one camera's image. The value at a pixel is the log likelihood
/// of a target whose center projects to this pixel, at the distance of the estimate.
struct LikelihoodMap {
  cv::Rect area;                 ///< part of the image, pixels; empty if the target is not in view
  cv::Mat logLikelihood;         ///< log likelihoods, CV_32F, one per pixel of the area
  double minLogLikelihood = 0.0; ///< log likelihood that means "certainly not here"
  double maxLogLikelihood = 0.0; ///< log likelihood of a fully visible target
};

} // namespace dewpoint::tracking
