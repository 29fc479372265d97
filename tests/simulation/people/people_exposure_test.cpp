// SPDX-License-Identifier: GPL-3.0-or-later
// People in the light of several lamps, as a shutter sees them.
#include "core/simulation/people/people_exposure.h"
#include "core/simulation/room/room_view.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <memory>
#include <vector>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

/// One camera in the office's wall, which sees people at y = 1 from head to foot.
const RoomView& exposureView() {
  static const auto view = [] {
    Camera camera;
    camera.name = "camera 1";
    camera.intrinsics = {160, 120, 115.0, 115.0, 79.5, 59.5};
    camera.cameraFromWorld = lookAt({0.0, -3.3, 0.9}, {0.0, 3.0, 0.9});
    return std::make_unique<const RoomView>(camera, Room(Furnishing::Office));
  }();
  return *view;
}

/// Is at x = speed * time, y = 1.
PeopleAt passingAt(double speed) {
  return [speed](double time) {
    Walker walker;
    walker.waypoints = {{-10.0, {-10.0 * speed, 1.0}}, {10.0, {10.0 * speed, 1.0}}};
    return std::vector<std::vector<BodyPart>>{bodyParts(walker, time)};
  };
}

/// The office's lamp, and a reddish one from the left.
Illumination withLampFromTheLeft() {
  Illumination light;
  light.lampPosition = kOfficeLampPosition;
  light.additionalLamps.push_back({{-3.0F, 1.0F, 1.2F}, {0.2F, 0.4F, 0.8F}});
  return light;
}

/// The image of people under a light that a shutter sees at time 0.
cv::Mat exposedImage(const PeopleAt& people, const Illumination& light, const Shutter& shutter) {
  const RelitBackground background = relightBackground(exposureView(), light);
  cv::Mat image = backgroundAt(exposureView(), background, light, 0.0);
  paintPeopleThroughShutter(exposureView(), people, {{&light, 0.0}, &background}, shutter, image);
  return image;
}

/// The same without a shutter.
cv::Mat momentaryImage(const PeopleAt& people, const Illumination& light) {
  const RelitBackground background = relightBackground(exposureView(), light);
  cv::Mat image = backgroundAt(exposureView(), background, light, 0.0);
  paintPeople(exposureView(), people(0.0), {{&light, 0.0}, &background}, image);
  return image;
}

TEST(ExposureSteps, AShortExposureIsOneStep) {
  const auto steps = exposureSteps({0.01, 0.0}, 120);
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_NEAR(steps[0].centerTime, 0.0, 1e-12);
  for (const float share : steps[0].rowShares) {
    EXPECT_NEAR(share, 1.0F, 1e-5F);
  }
}

TEST(ExposureSteps, EachRowHasItsOwnTime) {
  const Shutter shutter{0.033, 0.030};
  const int rows = 120;
  const auto steps = exposureSteps(shutter, rows);
  EXPECT_GE(steps.size(), 3U);
  for (int row = 0; row < rows; ++row) {
    double sum = 0.0;
    double mean = 0.0;
    for (const ExposureStep& step : steps) {
      const double share = step.rowShares[static_cast<std::size_t>(row)];
      sum += share;
      mean += share * step.centerTime;
    }
    EXPECT_NEAR(sum, 1.0, 1e-5) << row;
    EXPECT_NEAR(mean, rowTime(shutter, row, rows), 0.004) << row; // a quarter of a step
  }
}

TEST(PeopleExposure, WhoStandsStillIsNotBlurred) {
  const Illumination light = withLampFromTheLeft();
  const cv::Mat still = momentaryImage(passingAt(0.0), light);
  const cv::Mat exposed = exposedImage(passingAt(0.0), light, {0.033, 0.030});
  EXPECT_LT(cv::norm(still, exposed, cv::NORM_INF), 0.01);
}

TEST(PeopleExposure, WhoWalksIs) {
  const Illumination light = withLampFromTheLeft();
  const cv::Mat sharp = momentaryImage(passingAt(2.0), light);
  const cv::Mat exposed = exposedImage(passingAt(2.0), light, {0.033, 0.0});
  EXPECT_GT(cv::norm(sharp, exposed, cv::NORM_INF), 10.0);
  // What the room alone shows stays.
  EXPECT_LT(cv::norm(sharp.col(0), exposed.col(0), cv::NORM_INF), 0.01);
}

TEST(PeopleLight, IsTheLampAloneWhereThereIsNoOther) {
  Illumination light;
  light.lampPosition = kOfficeLampPosition;
  const RelitBackground background = relightBackground(exposureView(), light);
  cv::Mat room = backgroundAt(exposureView(), background, light, 0.0);
  cv::Mat same = room.clone();
  const auto people = passingAt(0.0)(0.0);
  paintPeople(exposureView(), people, kOfficeLampPosition, same);
  paintPeople(exposureView(), people, {{&light, 0.0}, &background}, room);
  EXPECT_LT(cv::norm(room, same, cv::NORM_INF), 0.1);
}

TEST(PeopleLight, AFurtherLampLightsPeople) {
  Illumination plain;
  plain.lampPosition = kOfficeLampPosition;
  const PeopleAt people = passingAt(0.0);
  const cv::Mat before = momentaryImage(people, plain);
  const cv::Mat after = momentaryImage(people, withLampFromTheLeft());
  cv::Mat who;
  cv::Mat unused = before.clone();
  paintPeople(exposureView(), people(0.0), kOfficeLampPosition, unused, &who);
  const cv::Scalar gain = cv::mean(after - before, who == 1);
  EXPECT_GT(gain[2], 2.0); // red, which it has most of
}

} // namespace
} // namespace dewpoint::tests
