// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/people/person_observation.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

TEST(MotionLikelihood, SmoothsAndHasAFloor) {
  cv::Mat mask = cv::Mat::zeros(80, 80, CV_8UC1);
  mask.colRange(40, 80).setTo(255);
  cv::Mat likelihood;
  computeMotionLikelihood(mask, 4.0, 0.2, likelihood);
  EXPECT_NEAR(likelihood.at<float>(40, 60), 1.0, 1e-5);
  EXPECT_NEAR(likelihood.at<float>(40, 10), 0.2, 1e-6); // p_B
  // An edge smoothed by a Gaussian is its distribution function: half a pixel and 4.5 pixels
  // inside of it, at sigma = 4 px.
  EXPECT_NEAR(likelihood.at<float>(40, 40), 0.5 * (1.0 + std::erf(0.5 / 4.0 / std::sqrt(2.0))),
              0.01);
  EXPECT_NEAR(likelihood.at<float>(40, 44), 0.5 * (1.0 + std::erf(4.5 / 4.0 / std::sqrt(2.0))),
              0.01);
  EXPECT_NEAR(likelihood.at<float>(40, 79), 0.55, 0.06); // nothing moves outside the image
}

TEST(ColorCue, IsThePapersEquations) {
  const unsigned char red[3] = {0, 0, 200}; // hue 0, saturation 1
  ColorCue cue{0.05, 0.1, 0.3, 0.4};
  const double peak = std::sqrt(2.0 * std::numbers::pi);
  const double hue = 0.3 + 0.7 * std::exp(-0.5 * 0.04 * 0.04 / 0.0025) / (peak * 0.05);
  const double saturation = 0.4 + 0.6 * std::exp(-0.5) / (peak * 0.1);
  // d_h is circular: 0.96 is 0.04 away from 0.
  EXPECT_NEAR(cue.logLikelihood(red, 0.96, 0.9), std::log(hue) + std::log(saturation), 1e-9);
  const unsigned char gray[3] = {80, 80, 80}; // no hue, saturation 0
  EXPECT_NEAR(cue.logLikelihood(gray, 0.5, 0.0), std::log(0.4 + 0.6 / (peak * 0.1)), 1e-9);
}

TEST(PersonObservation, MultipliesCamerasAndCues) {
  Camera camera;
  camera.intrinsics = {100, 80, 100.0, 100.0, 50.0, 40.0};
  camera.cameraFromWorld.translation().z() = 2.0;
  const Projector projector(camera);
  cv::Mat likelihood(80, 100, CV_32FC1, cv::Scalar(0.25));
  likelihood.at<float>(40, 50) = 0.75F;
  const cv::Mat image(80, 100, CV_8UC3, cv::Scalar(0, 0, 200));
  const std::vector<PersonCamera> views{{&projector, likelihood, image},
                                        {&projector, likelihood, image},
                                        {&projector, cv::Mat(), image}}; // has no image
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(3, 8);
  states(1, 0) = 0.5; // 25 px beside
  states(2, 0) = 3.0; // outside the image
  states.col(7) = 1.0;
  Eigen::ArrayXd motion = Eigen::ArrayXd::Zero(3);
  PersonObservation(views, 0.2, std::nullopt).addLogLikelihood(states, motion);
  EXPECT_NEAR(motion[0], 2.0 * std::log(0.75), 1e-6);
  EXPECT_NEAR(motion[1], 2.0 * std::log(0.25), 1e-6);
  EXPECT_NEAR(motion[2], 2.0 * std::log(0.2), 1e-6);
  Eigen::ArrayXd both = Eigen::ArrayXd::Zero(3);
  const ColorCue cue;
  PersonObservation(views, 0.2, cue).addLogLikelihood(states, both);
  const double color = cue.logLikelihood(image.ptr(0, 0), 0.0, 1.0);
  EXPECT_NEAR(both[0], motion[0] + 2.0 * color, 1e-6);
  // Outside both images: the floors of the color, h_B = s_B = 0.3, as for a color that does not
  // match at all.
  EXPECT_NEAR(both[2], motion[2] + 2.0 * std::log(0.3 * 0.3), 1e-6);
}

TEST(PersonObservation, LeavingAViewIsNoBetterThanAWrongColorInIt) {
  Camera camera;
  camera.intrinsics = {100, 80, 100.0, 100.0, 50.0, 40.0};
  camera.cameraFromWorld.translation().z() = 2.0;
  const Projector projector(camera);
  const cv::Mat likelihood(80, 100, CV_32FC1, cv::Scalar(0.2)); // p_B: nothing moves
  const cv::Mat image(80, 100, CV_8UC3, cv::Scalar(0, 0, 200)); // hue 0, saturation 1
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(2, 8);
  states.col(6) = 0.5; // the opposite hue: 12 sigma_h away, and 6 sigma_s from the saturation
  states.col(7) = 0.5;
  states(1, 0) = 3.0; // outside the image
  Eigen::ArrayXd logLikelihood = Eigen::ArrayXd::Zero(2);
  PersonObservation({{&projector, likelihood, image}}, 0.2, ColorCue{})
      .addLogLikelihood(states, logLikelihood);
  EXPECT_NEAR(logLikelihood[0], std::log(0.2 * 0.3 * 0.3), 1e-6);
  EXPECT_NEAR(logLikelihood[1], logLikelihood[0], 1e-6);
}

} // namespace
} // namespace dewpoint::tests
