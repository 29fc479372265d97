// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/snapshot_state.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A tracked moment of two cameras with one target per status, near the ball.
TrackSnapshot snapshotOf(const std::vector<TargetStatus>& statuses) {
  TrackSnapshot snapshot;
  snapshot.rig = std::make_shared<const CameraRig>(test::twoCameras());
  snapshot.frames = std::make_shared<const FrameSet>();
  snapshot.isTracked = true;
  for (const TargetStatus status : statuses) {
    TargetSnapshot& target = snapshot.targets.emplace_back();
    target.target.name = std::to_string(snapshot.targets.size());
    target.status = status;
    SphereEstimate sphere;
    sphere.mean = test::kBall;
    target.estimate = sphere;
  }
  return snapshot;
}

/// Somebody whose hull is a cube of 10 cm around `center`.
void addPerson(TrackSnapshot& snapshot, const Eigen::Vector3d& center) {
  std::vector<Eigen::Vector3d> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(center + 0.05 * Eigen::Vector3d((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1,
                                                      (k & 4) != 0 ? 1 : -1));
  }
  TargetSnapshot& target = snapshot.targets.emplace_back();
  PersonEstimate person;
  person.position = center;
  target.estimate = person;
  PersonShape shape;
  shape.hull = convexHull(corners);
  target.shape = std::make_shared<const PersonShape>(std::move(shape));
}

TEST(SnapshotState, WithoutImagesTargetsOrTrackingThereIsNothingToJudge) {
  TrackSnapshot snapshot = snapshotOf({TargetStatus::Held});
  snapshot.frames = nullptr;
  EXPECT_EQ(trackingState(snapshot), TrackingState::NoImages);
  EXPECT_EQ(trackingState(snapshotOf({})), TrackingState::NoTarget);
  TrackSnapshot past = snapshotOf({TargetStatus::Held});
  past.isPast = true;
  past.isTracked = false;
  EXPECT_EQ(trackingState(past), TrackingState::NotTracked);
}

TEST(SnapshotState, TheWorstTargetSpeaksForAll) {
  using enum TargetStatus;
  EXPECT_EQ(trackingState(snapshotOf({Held, Held})), TrackingState::Held);
  EXPECT_EQ(trackingState(snapshotOf({Held, Searching})), TrackingState::Searching);
  EXPECT_EQ(trackingState(snapshotOf({Searching, Lost, Held})), TrackingState::Lost);
  EXPECT_EQ(trackingState(snapshotOf({Held, Ambiguous})), TrackingState::Ambiguous);
  EXPECT_EQ(trackingState(snapshotOf({Ambiguous, Searching})), TrackingState::Searching);
}

TEST(SnapshotState, ABoxIsHiddenOrMissingAndOfOneCamera) {
  TrackSnapshot snapshot = snapshotOf({TargetStatus::Held, TargetStatus::Searching});
  snapshot.family.targetSource = TargetSource::Box;
  for (TargetSnapshot& target : snapshot.targets) {
    target.estimate = AbsentEstimate{};
    target.stateWhileAbsent = TrackingState::NoBox;
  }
  EXPECT_EQ(trackingState(snapshot.targets[0]), TrackingState::NoBox);
  EXPECT_EQ(trackingState(snapshot), TrackingState::NoBox);
  for (int k = 0; k < 2; ++k) {
    BoxEstimate box;
    box.camera = k;
    snapshot.targets[static_cast<std::size_t>(k)].estimate = box;
  }
  EXPECT_EQ(trackingState(snapshot.targets[1]), TrackingState::Hidden);
  EXPECT_EQ(trackingState(snapshot), TrackingState::Hidden);
  EXPECT_EQ(trackingState(snapshot, 0), TrackingState::Held);
  EXPECT_EQ(trackingState(snapshot, 1), TrackingState::Hidden);
  EXPECT_EQ(trackingState(snapshot, 2), TrackingState::NoBox);
}

TEST(SnapshotState, PeopleAreLearnedFirst) {
  TrackSnapshot snapshot = snapshotOf({});
  snapshot.family.targetSource = TargetSource::Images;
  snapshot.peopleCameras.resize(2);
  snapshot.peopleCameras[0].learningProgress = 1.0;
  snapshot.peopleCameras[1].learningProgress = 0.5;
  EXPECT_EQ(trackingState(snapshot), TrackingState::Learning);
  snapshot.peopleCameras[1].learningProgress = 1.0;
  EXPECT_EQ(trackingState(snapshot), TrackingState::Nobody);
  snapshot.targets = snapshotOf({TargetStatus::Gone, TargetStatus::Held}).targets;
  EXPECT_EQ(trackingState(snapshot), TrackingState::Held);
  snapshot.targets[0].status = TargetStatus::Searching;
  EXPECT_EQ(trackingState(snapshot), TrackingState::Searching);
}

TEST(SnapshotState, TheTargetToExplainIsTheChosenOneOrTheFirstInTrouble) {
  using enum TargetStatus;
  EXPECT_EQ(targetToExplain(snapshotOf({}), 0), nullptr);
  const auto nameOf = [](const TrackSnapshot& snapshot, int preferred) {
    return targetToExplain(snapshot, preferred)->target.name;
  };
  const TrackSnapshot mixed = snapshotOf({Gone, Held, Lost, Searching});
  EXPECT_EQ(nameOf(mixed, 1), "2");
  EXPECT_EQ(nameOf(mixed, -1), "3");
  EXPECT_EQ(nameOf(mixed, 9), "3"); // chosen in another project
  EXPECT_EQ(nameOf(snapshotOf({Gone, Held}), -1), "2");
  EXPECT_EQ(nameOf(snapshotOf({Gone}), -1), "1");
}

TEST(SnapshotState, OnlyAHeldTargetWithinTheImageIsInView) {
  TrackSnapshot snapshot = snapshotOf({TargetStatus::Searching, TargetStatus::Held});
  ASSERT_NE(trackedTargetInView(snapshot, 0), nullptr);
  EXPECT_EQ(trackedTargetInView(snapshot, 0)->target.name, "2");
  EXPECT_EQ(trackedTargetInView(snapshot, 2), nullptr);
  SphereEstimate behind;
  behind.mean = Eigen::Vector3d(0.0, -0.8, 0.1); // of the left camera
  snapshot.targets[1].estimate = behind;
  EXPECT_EQ(trackedTargetInView(snapshot, 0), nullptr);
  BoxEstimate box;
  box.camera = 1; // a box is in its own camera only
  snapshot.targets[1].estimate = box;
  EXPECT_EQ(trackedTargetInView(snapshot, 0), nullptr);
  EXPECT_NE(trackedTargetInView(snapshot, 1), nullptr);
}

TEST(SnapshotState, AClickMeetsTheNearestPersonWhoseHullIsThere) {
  TrackSnapshot snapshot = snapshotOf({});
  snapshot.family.targetSource = TargetSource::Images;
  addPerson(snapshot, test::kBall + Eigen::Vector3d(0.0, 0.3, 0.0)); // behind, for the left camera
  addPerson(snapshot, test::kBall);
  const Eigen::Vector2d center(79.5, 59.5); // where both cameras look
  EXPECT_EQ(personIndexAt(snapshot, 0, center), 1);
  EXPECT_EQ(personIndexAt(snapshot, 1, center), 1);
  // Seen from the left side the first one stands beside the ball: 0.3 m at 0.6 m.
  EXPECT_EQ(personIndexAt(snapshot, 1, {79.5 - 75.0, 59.5}), 0);
  EXPECT_EQ(personIndexAt(snapshot, 0, {2.0, 2.0}), -1);
  EXPECT_EQ(personIndexAt(snapshot, 7, center), -1);
}

TEST(SnapshotState, ACameraIsOneOfTheRig) {
  const TrackSnapshot snapshot = snapshotOf({});
  EXPECT_EQ(cameraOf(snapshot, 1), &snapshot.rig->at(1));
  EXPECT_EQ(cameraOf(snapshot, -1), nullptr);
  EXPECT_EQ(cameraOf(snapshot, 2), nullptr);
  EXPECT_EQ(cameraOf(TrackSnapshot(), 0), nullptr);
}

/// Two targets that are believed to be at the ball and 0.1 m to the right of it for the left
/// camera, 25 pixels at 0.6 m.
TrackSnapshot twoBelieved() {
  TrackSnapshot snapshot = snapshotOf({TargetStatus::Held, TargetStatus::Held});
  for (std::size_t k = 0; k < 2; ++k) {
    auto& sphere = std::get<SphereEstimate>(snapshot.targets[k].estimate);
    sphere.mean += Eigen::Vector3d(0.1 * static_cast<double>(k), 0.0, 0.0);
    sphere.particleCount = 100;
  }
  return snapshot;
}

TEST(SnapshotState, APressIsAboutTheTargetNearestToIt) {
  TrackSnapshot snapshot = twoBelieved();
  EXPECT_EQ(targetIndexNear(snapshot, 2, 0, {79.5, 59.5}, 10.0), 0);
  EXPECT_EQ(targetIndexNear(snapshot, 2, 0, {104.5, 59.5}, 10.0), 1);
  EXPECT_EQ(targetIndexNear(snapshot, 2, 0, {94.5, 59.5}, 20.0), 1); // 15 and 10 pixels away
  EXPECT_EQ(targetIndexNear(snapshot, 2, 0, {94.5, 59.5}, 9.0), -1);
  EXPECT_EQ(targetIndexNear(snapshot, 1, 0, {104.5, 59.5}, 10.0), -1); // the project has one
  EXPECT_EQ(targetIndexNear(snapshot, 5, 0, {104.5, 59.5}, 10.0), 1);
  EXPECT_EQ(targetIndexNear(snapshot, 2, 2, {79.5, 59.5}, 10.0), -1); // no such camera
  snapshot.targets[1].target.isShown = false; // nobody means what is not seen
  EXPECT_EQ(targetIndexNear(snapshot, 2, 0, {94.5, 59.5}, 20.0), 0);
}

TEST(SnapshotState, NothingIsBelievedBeforeTheFirstParticles) {
  TrackSnapshot snapshot = twoBelieved();
  ASSERT_TRUE(positionEstimate(snapshot, 1));
  EXPECT_EQ(positionEstimate(snapshot, 0)->mean, test::kBall);
  EXPECT_FALSE(positionEstimate(snapshot, 2));
  EXPECT_FALSE(positionEstimate(snapshot, -1));
  std::get<SphereEstimate>(snapshot.targets[0].estimate).particleCount = 0;
  EXPECT_FALSE(positionEstimate(snapshot, 0));
  EXPECT_EQ(targetIndexNear(snapshot, 2, 0, {79.5, 59.5}, 10.0), -1);
}

TEST(SnapshotState, PixelsAreThoseOfTheCameraWithTheNumber) {
  const TrackSnapshot snapshot = snapshotOf({});
  ASSERT_TRUE(pixelOf(snapshot, 1, test::kBall));
  EXPECT_LT((*pixelOf(snapshot, 1, test::kBall) - Eigen::Vector2d(79.5, 59.5)).norm(), 1e-9);
  EXPECT_FALSE(pixelOf(snapshot, 0, {0.0, -0.8, 0.1})); // behind it
  EXPECT_FALSE(pixelOf(snapshot, 2, test::kBall));
}

} // namespace
} // namespace dewpoint::tests
