// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/filter/isotropic_motion.h"
#include "core/filter/models.h"
#include "core/filter/multinomial_resampling.h"
#include "core/filter/particle_filter.h"
#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "core/observation/sphere/color_window.h"

#include <opencv2/core.hpp>

#include <vector>

namespace dewpoint::bench {

/// The same rule as ColorWindow, written straight from the paper: per particle, and with an arc
/// cosine for every pixel it looks at.
struct NaiveColorWindow {
  std::vector<Projector> projectors;
  std::vector<cv::Mat> images;
  ColorRange range;

  int matchCount(const cv::Mat& image, int column, int row) const;
  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const;
};

/// The paper's two webcams at QVGA; the second is turned by 90 degrees, so its image is upright.
CameraRig paperRig();
/// Cameras at VGA on a circle around the ball.
CameraRig vgaRig(int cameraCount);

/// A filter that has been following a still pink ball of radius 2 cm on a desk full of colors.
struct BallScene {
  CameraRig rig;
  std::vector<cv::Mat> images;
  ColorWindow product;
  NaiveColorWindow naive;
  MotionProposal<IsotropicMotion> proposal{};
  MultinomialResampling resampling;
  ParticleFilter filter;
  ThreadTeam team;
  RandomKey key{1, 0, 0};
  Eigen::Index count;

  BallScene(const CameraRig& cameras, Eigen::Index particles, int threads = 1);

  /// The same images again, as if they were new, for so many iterations.
  void showFrame(int iterations = 1);
  StateEstimate iterateColorWindow();
  StateEstimate iterateNaive();
};

/// True if both versions have the same outcome, or comparing their times means nothing.
bool versionsAgree(const CameraRig& rig, Eigen::Index particles, int iterations);

} // namespace dewpoint::bench
