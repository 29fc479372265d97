// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/body/part_shapes.h"
#include "core/simulation/scene/stage.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

using simulation::MovingPart;
using simulation::Stage;
using simulation::StageBody;
using simulation::Vector3f;

const Vector3f kPink{145.0F, 85.0F, 245.0F};

/// A small camera that looks along the world's Y at (0.5, 0.5, 0.15).
std::shared_ptr<const simulation::RoomView> smallView() {
  static const auto view = [] {
    Camera camera;
    camera.intrinsics = {160, 120, 175.0, 175.0, 79.5, 59.5};
    camera.cameraFromWorld = lookAt({0.5, 0.0, 0.195}, {0.5, 0.5, 0.15});
    return std::make_shared<const simulation::RoomView>(
        camera, simulation::Room(simulation::Furnishing::Desk));
  }();
  return view;
}

Stage stageOf(StageBody body) {
  Stage stage;
  stage.views.push_back(smallView());
  stage.noiseSigma = 0.0;
  stage.bodies.push_back(std::move(body));
  return stage;
}

StageBody ballAt(const Eigen::Vector3d& center) {
  StageBody body;
  body.path = [center](double) { return center; };
  return body;
}

StageBody bodyOf(std::vector<MovingPart> parts) {
  StageBody body = ballAt({0.5, 0.5, 0.15});
  body.parts = [parts = std::move(parts)](double) { return parts; };
  return body;
}

/// Pixels that differ from the background image by more than 8 gray levels.
int changed(const Stage& stage, double time = 0.0) {
  cv::Mat room;
  smallView()->background.convertTo(room, CV_8UC3);
  cv::Mat difference;
  cv::absdiff(renderStage(stage, 0, time, 0), room, difference);
  int count = 0;
  for (int row = 0; row < difference.rows; ++row) {
    for (int column = 0; column < difference.cols; ++column) {
      const auto& pixel = difference.at<cv::Vec3b>(row, column);
      count += pixel[0] > 8 || pixel[1] > 8 || pixel[2] > 8 ? 1 : 0;
    }
  }
  return count;
}

TEST(PartPainter, ABallOfOnePartLooksLikeAPlainBall) {
  const cv::Mat plain = renderStage(stageOf(ballAt({0.5, 0.5, 0.15})), 0, 0.0, 0);
  const cv::Mat part =
      renderStage(stageOf(bodyOf({simulation::ballPart(0.035, kPink)})), 0, 0.0, 0);
  // The two choose the pixels that are sampled more finely in different ways: one sample of 16.
  EXPECT_LE(cv::norm(plain, part, cv::NORM_INF), 255.0 / 16.0 + 2.0);
  EXPECT_LE(cv::norm(plain, part, cv::NORM_L1) / static_cast<double>(plain.total()), 0.1);
}

TEST(PartPainter, WhatIsNearerHidesPointByPoint) {
  // A rod through the ball's middle, across the line of sight: its near half is before the ball.
  const MovingPart ball = simulation::ballPart(0.035, kPink);
  const MovingPart before =
      simulation::capsuleBetween({-0.06, -0.05, 0.0}, {0.06, -0.05, 0.0}, 0.01, Vector3f::Zero());
  const MovingPart behind = movedPart(before, Eigen::Matrix3d::Identity(), {0.0, 0.1, 0.0});
  const auto at = [](const cv::Mat& image) { return image.at<cv::Vec3b>(60, 80); };
  const cv::Mat hidden = renderStage(stageOf(bodyOf({ball, before})), 0, 0.0, 0);
  const cv::Mat seen = renderStage(stageOf(bodyOf({behind, ball})), 0, 0.0, 0);
  EXPECT_LT(at(hidden)[2], 20);
  EXPECT_GT(at(seen)[2], 60);
}

TEST(PartPainter, ASpinningPatternIsBlurred) {
  auto pattern = std::make_shared<simulation::SurfacePattern>();
  pattern->patches.push_back({Vector3f::UnitX(), 0.0F, Vector3f{235.0F, 235.0F, 235.0F}});
  MovingPart part = simulation::ballPart(0.035, kPink);
  part.pattern = pattern;
  const auto spinning = [&](double rate) {
    StageBody body = ballAt({0.5, 0.5, 0.15});
    body.parts = [part, rate](double time) {
      const Eigen::AngleAxisd turn(rate * time, Eigen::Vector3d::UnitZ());
      return std::vector{movedPart(part, turn.toRotationMatrix(), Eigen::Vector3d::Zero())};
    };
    return renderStage(stageOf(body), 0, 0.0, 0);
  };
  // The patch's border is seen in the middle of the ball, 35 mm / 0.5 m x 175 px = 12 px from its
  // outline. 10 ms at 100 radians per second turn it by 1 radian.
  const auto steps = [](const cv::Mat& image) {
    int most = 0;
    for (int column = 72; column < 88; ++column) {
      most = std::max(most, std::abs(image.at<cv::Vec3b>(60, column)[1] -
                                     image.at<cv::Vec3b>(60, column - 1)[1]));
    }
    return most;
  };
  EXPECT_GT(steps(spinning(0.0)), 40);
  EXPECT_LT(steps(spinning(100.0)), 25);
}

TEST(PartPainter, APartIsDrawnWhereItCrossesTheWholeImage) {
  // Both of its ends are outside the image.
  const MovingPart rod =
      simulation::capsuleBetween({-1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.02, Vector3f::Zero());
  // 160 px wide, 0.04 m / 0.5 m x 175 px = 14 px tall.
  EXPECT_GT(changed(stageOf(bodyOf({rod}))), 0.85 * 160 * 14);
}

TEST(PartPainter, PartsAreAsLargeAsTheBodysRadiusSays) {
  StageBody body =
      bodyOf({simulation::capsuleBetween({0.1, 0.0, 0.0}, {0.2, 0.0, 0.0}, 0.01, kPink)});
  EXPECT_EQ(body.partsAt(0.0).front().size.x(), 0.01F);
  body.radius = 0.5 * body.nominalRadius;
  const MovingPart half = body.partsAt(0.0).front();
  EXPECT_NEAR(half.size.x(), 0.005F, 1e-6F);
  EXPECT_NEAR(half.size.z(), 0.025F, 1e-6F);
  EXPECT_NEAR(half.center.x(), 0.075F, 1e-6F);
  EXPECT_TRUE(ballAt({0.0, 0.0, 0.0}).partsAt(0.0).empty());
}

TEST(PartPainter, WhatIsAbsentIsNotDrawn) {
  StageBody body = bodyOf({simulation::ballPart(0.035, kPink)});
  body.present = [](double time) { return time < 1.0; };
  const Stage stage = stageOf(body);
  EXPECT_GT(changed(stage, 0.0), 300);
  EXPECT_EQ(changed(stage, 2.0), 0);
}

} // namespace
} // namespace dewpoint::tests
