// SPDX-License-Identifier: GPL-3.0-or-later
// What the grades do to scenes of people.
#include "core/experiment/scenarios/people/people_recording.h"
#include "core/experiment/scenarios/people/people_scenario.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <array>
#include <cmath>

namespace dewpoint::tests {
namespace {

/// A scene of two people, its cameras reduced to a few pixels: quick to render.
OfficeScene smallOffice(std::uint64_t seed) {
  OfficeScene scene = makePeopleScenario("crossing", PeopleClothes::Different, seed)->scene;
  for (Camera& camera : scene.cameras) {
    camera.intrinsics = {80, 60, 57.5, 57.5, 39.5, 29.5};
  }
  return scene;
}

PeopleRecording recordedOffice(Grade grade, std::uint64_t seed) {
  static simulation::ViewCache views;
  return recordPeople("crossing", smallOffice(seed), grade, views);
}

double largestDifference(const FramePtr& one, const FramePtr& other) {
  return cv::norm(one->image, other->image, cv::NORM_INF);
}

TEST(PeopleRecording, IdealIsTheSceneItself) {
  const PeopleRecording recording = recordedOffice(Grade::Ideal, 3);
  simulation::ViewCache views;
  const OfficeRenderer renderer(smallOffice(3), views);
  for (const std::int64_t frame : {0, 20, 45}) {
    const FrameSetPtr set = recording.frames(frame);
    EXPECT_EQ(set->index, frame);
    ASSERT_EQ(set->frames.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      ASSERT_TRUE(set->frames[k]);
      EXPECT_EQ(set->frames[k]->captureTime, set->time);
      EXPECT_EQ(cv::norm(set->frames[k]->image, renderer.render(k, frame), cv::NORM_INF), 0.0);
    }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_TRUE(
        recording.rig[k].cameraFromWorld.isApprox(recording.scene.cameras[k].cameraFromWorld, 0.0));
    EXPECT_EQ(recording.rig[k].intrinsics.focalX, recording.scene.cameras[k].intrinsics.focalX);
    EXPECT_EQ(recording.rig[k].distortion, recording.scene.cameras[k].distortion);
  }
}

TEST(PeopleRecording, ARoomIsNotIdeal) {
  const FrameSetPtr ideal = recordedOffice(Grade::Ideal, 3).frames(0);
  const FrameSetPtr room = recordedOffice(Grade::Room, 3).frames(0);
  const FrameSetPtr wild = recordedOffice(Grade::Wild, 3).frames(0);
  for (std::size_t k = 0; k < 4; ++k) { // frame 0 always comes
    EXPECT_GT(largestDifference(ideal->frames[k], room->frames[k]), 20.0);
    EXPECT_GT(largestDifference(room->frames[k], wild->frames[k]), 20.0);
  }
}

TEST(PeopleRecording, ASeedGivesTheSameBitsTwice) {
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    const PeopleRecording one = recordedOffice(grade, 5);
    const PeopleRecording again = recordedOffice(grade, 5);
    const PeopleRecording other = recordedOffice(grade, 6);
    for (const std::int64_t frame : {0, 30}) {
      const FrameSetPtr first = one.frames(frame);
      const FrameSetPtr second = again.frames(frame);
      for (std::size_t k = 0; k < 4; ++k) {
        ASSERT_EQ(first->frames[k] == nullptr, second->frames[k] == nullptr);
        if (first->frames[k]) {
          EXPECT_EQ(largestDifference(first->frames[k], second->frames[k]), 0.0);
          EXPECT_EQ(first->frames[k]->captureTime, second->frames[k]->captureTime);
        }
      }
    }
    EXPECT_TRUE(one.rig[0].cameraFromWorld.isApprox(again.rig[0].cameraFromWorld, 0.0));
    EXPECT_GT(largestDifference(one.frames(0)->frames[0], other.frames(0)->frames[0]), 0.0);
    EXPECT_FALSE(one.rig[0].cameraFromWorld.isApprox(other.rig[0].cameraFromWorld, 1e-9));
  }
}

// The clothes and the way of a seed are the same in all grades, and so is when people are there.
TEST(PeopleRecording, WhoIsThereDoesNotDependOnTheGrade) {
  const PeopleRecording ideal = recordedOffice(Grade::Ideal, 4);
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    const PeopleRecording recording = recordedOffice(grade, 4);
    ASSERT_EQ(recording.scene.people.size(), ideal.scene.people.size());
    EXPECT_EQ(recording.scene.people[0].positionAt(3.0), ideal.scene.people[0].positionAt(3.0));
    EXPECT_EQ(recording.scene.people[1].clothes.shirt, ideal.scene.people[1].clothes.shirt);
    EXPECT_EQ(recording.scene.frameCount, ideal.scene.frameCount);
  }
}

TEST(PeopleRecording, MethodsGetACalibrationByHand) {
  double farthest = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const PeopleRecording recording = recordedOffice(Grade::Room, seed);
    ASSERT_EQ(recording.rig.size(), recording.scene.cameras.size());
    for (std::size_t k = 0; k < recording.rig.size(); ++k) {
      const Camera& believed = recording.rig[k];
      const Camera& real = recording.scene.cameras[k];
      const double off = (believed.center() - real.center()).norm();
      EXPECT_GT(off, 0.0);
      EXPECT_LT(off, 0.06); // 9 mm per axis, standard deviation
      farthest = std::max(farthest, off);
      const double focal = believed.intrinsics.focalX / real.intrinsics.focalX;
      EXPECT_NE(focal, 1.0);
      EXPECT_NEAR(focal, 1.0, 0.025);
      const Eigen::Matrix3d turned =
          believed.cameraFromWorld.linear() * real.cameraFromWorld.linear().transpose();
      EXPECT_LT(Eigen::AngleAxisd(turned).angle(), 0.02); // 0.2 degrees
      EXPECT_NE(believed.distortion[0], real.distortion[0]);
    }
  }
  EXPECT_GT(farthest, 0.01);
}

// As in the suite: a dropped frame is missing, a doubled one shows the image before once more.
TEST(PeopleRecording, FramesAreDroppedAndDoubled) {
  const PeopleRecording recording = recordedOffice(Grade::Wild, 2);
  int dropped = 0;
  int doubled = 0;
  int offTime = 0;
  FrameSetPtr before = recording.frames(0);
  for (std::int64_t frame = 1; frame < 150; ++frame) { // of 4 % each in the mean
    const FrameSetPtr now = recording.frames(frame);
    for (std::size_t k = 0; k < now->frames.size(); ++k) {
      const FramePtr& shown = now->frames[k];
      if (!shown) {
        ++dropped;
        continue;
      }
      EXPECT_EQ(shown->index, frame);
      offTime += shown->captureTime != now->time ? 1 : 0;
      if (before->frames[k] && largestDifference(shown, before->frames[k]) == 0.0) {
        ++doubled;
      }
    }
    before = now;
  }
  EXPECT_GT(dropped, 0);
  EXPECT_GT(doubled, 0);
  EXPECT_LT(dropped + doubled, 150);
  EXPECT_GT(offTime, 400); // of about 570: time stamps jitter
}

TEST(PeopleRecording, WildCamerasStandElsewhereInTheOffice) {
  const CameraRig usual = smallOffice(7).cameras;
  const PeopleRecording recording = recordedOffice(Grade::Wild, 7);
  ASSERT_EQ(recording.scene.cameras.size(), usual.size());
  for (std::size_t k = 0; k < usual.size(); ++k) {
    const Eigen::Vector3d center = recording.scene.cameras[k].center();
    EXPECT_GT((center - usual[k].center()).norm(), 0.01);
    EXPECT_LT(center.head<2>().cwiseAbs().maxCoeff(), 3.4);
    EXPECT_GT(center.z(), 1.85);
    EXPECT_LT(center.z(), 2.6);
    EXPECT_TRUE(Projector(recording.scene.cameras[k]).project({0.0, 0.0, 0.8}).has_value());
  }
}

} // namespace
} // namespace dewpoint::tests
