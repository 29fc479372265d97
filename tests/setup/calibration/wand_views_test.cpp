// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_views.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace dewpoint::tests {
namespace {

const ColorRange kRedRange{340.0, 20.0, 0.4, 1.0, 0.1, 0.9};
const ColorRange kBlueRange{220.0, 260.0, 0.4, 1.0, 0.1, 0.9};

Project twoBalls() {
  Project project;
  project.targets = {{"red", 0.04, kRedRange}, {"blue", 0.05, kBlueRange}};
  project.cameras.resize(2);
  return project;
}

TEST(WandViews, CollectsBothBallsPerCameraWithTheirTimes) {
  const Project project = twoBalls();
  WandOptions options;
  options.targets = {"red", "blue"};
  options.stickLength = 0.5;
  const auto colors = wandColorClassifiers(project, options);
  ASSERT_TRUE(colors);
  WandViews views(2, *colors);
  cv::Mat image(120, 160, CV_8UC3, cv::Scalar(120, 120, 120));
  cv::circle(image, {50, 60}, 8, cv::Scalar(30, 30, 220), cv::FILLED);
  cv::circle(image, {110, 60}, 10, cv::Scalar(220, 30, 30), cv::FILLED);
  FrameSet set{0, timeStamp(0.0), {}};
  set.frames = {std::make_shared<const Frame>(Frame{0, timeStamp(0.25), image}), nullptr};
  views.add(set);
  ASSERT_EQ(views.views()[0].size(), 2U);
  EXPECT_TRUE(views.views()[1].empty());
  const MarkerObservation& blue = views.views()[0][1];
  EXPECT_EQ(blue.ball, 1U);
  EXPECT_EQ(blue.time, 0.25);
  EXPECT_NEAR((blue.pixel - Eigen::Vector2d(110.0, 60.0)).norm(), 0.0, 0.1);
  EXPECT_NEAR(blue.radius, 10.3, 0.4); // cv::circle fills the pixels up to 10 from the middle one
}

TEST(WandViews, TheOptionsMakeTheProblem) {
  const Project project = twoBalls();
  WandOptions options;
  options.targets = {"red", "blue"};
  options.stickLength = 0.5;
  const auto problem = makeWandProblem(project, options);
  ASSERT_TRUE(problem);
  EXPECT_EQ(problem->scaleMethod, WandScale::Stick);
  EXPECT_EQ(problem->ballRadii[1], 0.05);
  EXPECT_EQ(problem->initialRig.size(), 2U);

  options.targets = {"red"}; // a stick has two balls
  EXPECT_EQ(makeWandProblem(project, options).error().field, "target");
  options.stickLength = 0.0;
  options.usesBallDiameter = true;
  EXPECT_EQ(makeWandProblem(project, options)->scaleMethod, WandScale::Diameter);
  options.targets = {"green"};
  EXPECT_EQ(makeWandProblem(project, options).error().code, ErrorCode::NotFound);
  options.targets = {}; // which of the two?
  EXPECT_EQ(makeWandProblem(project, options).error().code, ErrorCode::MissingKey);
}

} // namespace
} // namespace dewpoint::tests
