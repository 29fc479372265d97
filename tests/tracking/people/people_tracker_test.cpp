// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/projector.h"
#include "core/observation/people/body_silhouette.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker_capabilities.h"
#include "tests/tracking/people/people_room.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>
#include <initializer_list>
#include <map>
#include <memory>
#include <utility>

namespace dewpoint::tests {
namespace {

using bodies::kRate;
using bodies::room;

struct Person {
  Eigen::Vector2d place;
  cv::Scalar color;
};

/// A gray room in which flat bodies stand.
FrameSetPtr drawPeople(const CameraRig& rig, std::int64_t frame,
                       const std::vector<Person>& people) {
  FrameSet set{frame, timeStamp(static_cast<double>(frame) / kRate), {}};
  for (const Camera& camera : rig) {
    cv::Mat image = bodies::backgroundImage();
    const SilhouetteProjector maker(camera);
    for (const Person& person : people) {
      for (const cv::Rect& piece : maker.project(person.place, 0.0, bodies::kHeight).partRects) {
        const cv::Rect body(piece.x + piece.width / 6, piece.y, piece.width - piece.width / 3,
                            piece.height);
        image(body & cv::Rect(0, 0, 320, 240)).setTo(person.color);
      }
    }
    set.frames.push_back(std::make_shared<const Frame>(Frame{frame, set.time, image}));
  }
  return std::make_shared<const FrameSet>(std::move(set));
}

const cv::Scalar kBlue(190, 70, 40);
const cv::Scalar kRed(40, 50, 190);

/// A method at work, one frame after the other.
class PeopleRun {
public:
  PeopleRun(const std::string& method, std::initializer_list<std::pair<const char*, double>> set) {
    ParameterValues parameters(methodParameters(method));
    for (const auto& [key, value] : set) {
      EXPECT_TRUE(parameters.set(key, value)) << key;
    }
    tracker_ = makeTracker(method, parameters, room(), {}).value();
    tracker_->restart(1);
  }
  Tracker& tracker() { return *tracker_; }
  void step(FrameSetPtr frames, ThreadTeam& team) {
    tracker_->beginFrame(std::move(frames));
    tracker_->iterate(team);
  }
  const std::vector<PersonEstimate>& people() const { return found().people(); }
  const PeopleFinding& found() const {
    return *capability<PeopleFinding>(std::as_const(*tracker_));
  }

private:
  std::unique_ptr<Tracker> tracker_;
};

std::unique_ptr<PeopleRun> trackerOf(const std::string& method) {
  using Set = std::initializer_list<std::pair<const char*, double>>;
  return std::make_unique<PeopleRun>(method, Set{{"learning_time", 0.5}});
}

class PeopleMethods : public testing::TestWithParam<std::string> {};

TEST_P(PeopleMethods, SeeSomebodyComeWalkAndGo) {
  const CameraRig rig = room();
  const auto tracker = trackerOf(GetParam());
  ThreadTeam team(1);
  std::int64_t frame = 0;
  for (; frame < 12; ++frame) { // 0.8 s: longer than it learns
    tracker->step(drawPeople(rig, frame, {}), team);
    EXPECT_TRUE(tracker->people().empty());
  }
  EXPECT_EQ(tracker->found().cameraStates()[0].learningProgress, 1.0);
  for (; frame < 42; ++frame) { // 2 s at 0.6 m/s
    const Eigen::Vector2d place(-0.6 + 0.04 * static_cast<double>(frame - 12), 0.3);
    tracker->step(drawPeople(rig, frame, {{place, kBlue}}), team);
    if (frame >= 24) { // 0.8 s after it came
      ASSERT_EQ(tracker->people().size(), 1U) << frame;
      EXPECT_EQ(tracker->people()[0].identity, 1);
      EXPECT_LT((tracker->people()[0].position.head<2>() - place).norm(), 0.2) << frame;
      EXPECT_EQ(tracker->people()[0].seeingCameraCount, 4);
    }
  }
  const BodyCloud body = tracker->found().bodyOf(1);
  EXPECT_NEAR(body.weights.sum(), 1.0, 1e-9);
  EXPECT_EQ(tracker->found().bodyOf(99).points.rows(), 0);
  for (; frame < 57; ++frame) { // 1 s
    tracker->step(drawPeople(rig, frame, {}), team);
  }
  EXPECT_TRUE(tracker->people().empty());
}

TEST_P(PeopleMethods, GiveTheSameBitsForAnyNumberOfThreads) {
  const CameraRig rig = room();
  std::vector<Eigen::Vector3d> places;
  for (const int threads : {1, 3}) {
    const auto tracker = trackerOf(GetParam());
    ThreadTeam team(threads);
    for (std::int64_t frame = 0; frame < 30; ++frame) {
      const double x = 0.02 * static_cast<double>(frame);
      tracker->step(frame < 10 ? drawPeople(rig, frame, {})
                               : drawPeople(rig, frame, {{{x, -0.6}, kBlue}, {{-x, 0.7}, kRed}}),
                    team);
    }
    ASSERT_EQ(tracker->people().size(), 2U);
    if (places.empty()) {
      for (const auto& person : tracker->people()) {
        places.push_back(person.position);
      }
    } else {
      EXPECT_EQ(tracker->people()[0].position, places[0]);
      EXPECT_EQ(tracker->people()[1].position, places[1]);
    }
  }
}

TEST_P(PeopleMethods, TakeAPersonPutThereByHand) {
  const CameraRig rig = room();
  PeopleRun run(GetParam(), {{"births", 0.0}});
  PeopleRun* const tracker = &run;
  auto* const placing = capability<PersonEditing>(run.tracker());
  ASSERT_NE(placing, nullptr);
  // The background image is known: nothing is learned first.
  std::vector<cv::Mat> rooms;
  const FrameSetPtr empty = drawPeople(rig, 0, {});
  for (const auto& frame : empty->frames) {
    rooms.push_back(frame->image);
  }
  capability<BackgroundImageConfigurable>(run.tracker())->setBackgroundImages(rooms);
  run.tracker().restart(2);
  ThreadTeam team(1);
  EXPECT_EQ(placing->addPerson({0.4, 0.1, 0.85}), 1);
  for (std::int64_t frame = 0; frame < 8; ++frame) {
    tracker->step(drawPeople(rig, frame, {{{0.5, 0.1}, kRed}, {{-1.0, -1.0}, kBlue}}), team);
  }
  ASSERT_EQ(tracker->people().size(), 1U); // the other one is not born
  EXPECT_NEAR(tracker->people()[0].position.x(), 0.5, 0.15);
  placing->removePerson(1);
  EXPECT_TRUE(tracker->people().empty());
}

TEST_P(PeopleMethods, MapTheLikelihoodOfMotion) {
  const CameraRig rig = room();
  PeopleRun run(GetParam(), {{"learning_time", 0.5}, {"image_width", 0.0}});
  const auto* mapping = capability<MotionMapping>(std::as_const(run.tracker()));
  ASSERT_NE(mapping, nullptr);
  ThreadTeam team(1);
  for (std::int64_t frame = 0; frame < 13; ++frame) { // 0.8 s: longer than it learns
    run.step(
        drawPeople(rig, frame,
                   frame < 12 ? std::vector<Person>{} : std::vector<Person>{{{0.2, 0.2}, kRed}}),
        team);
  }
  const auto maps = mapping->motionLikelihoodMaps();
  ASSERT_EQ(maps.size(), rig.size());
  const auto at = Projector(rig[0]).project({0.2, 0.2, 0.9});
  ASSERT_TRUE(at);
  const LikelihoodMap& map = maps[0];
  EXPECT_EQ(map.area, cv::Rect(0, 0, 320, 240));
  EXPECT_NEAR(map.minLogLikelihood, std::log(0.2), 1e-12); // p_B
  // D is near 1 in the middle of what moves (a body is 10 px wide, sigma at most 4 px), and p_B in
  // a corner where nothing does.
  EXPECT_GT(map.logLikelihood.at<float>(cvRound(at->y()), cvRound(at->x())), std::log(0.5));
  EXPECT_NEAR(map.logLikelihood.at<float>(0, 0), std::log(0.2), 1e-6);
}

TEST_P(PeopleMethods, LiveWithoutSomeCamera) {
  const CameraRig rig = room();
  const auto tracker = trackerOf(GetParam());
  ThreadTeam team(1);
  for (std::int64_t frame = 0; frame < 40; ++frame) {
    FrameSet set = *drawPeople(
        rig, frame, frame < 12 ? std::vector<Person>{} : std::vector<Person>{{{0.2, 0.2}, kRed}});
    set.frames[1] = nullptr;
    if (frame > 30) {
      set.frames[2] = nullptr;
    }
    tracker->step(std::make_shared<const FrameSet>(std::move(set)), team);
  }
  ASSERT_EQ(tracker->people().size(), 1U);
  EXPECT_LT((tracker->people()[0].position.head<2>() - Eigen::Vector2d(0.2, 0.2)).norm(), 0.25);
  EXPECT_FALSE(tracker->found().cameraStates()[1].isUsable);
  EXPECT_TRUE(tracker->found().foregroundMask(1).empty());
}

INSTANTIATE_TEST_SUITE_P(All, PeopleMethods, testing::ValuesIn(methodNames(TargetSource::Images)),
                         [](const auto& method) {
                           std::string name = method.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(PeopleMethod, KeepsTwoInTheSameClothesApart) {
  const CameraRig rig = room();
  const auto tracker = trackerOf("people");
  ThreadTeam team(1);
  std::int64_t frame = 0;
  for (; frame < 10; ++frame) {
    tracker->step(drawPeople(rig, frame, {}), team);
  }
  // They pass each other at 0.5 m, at 0.6 m/s: one along y = -0.25 from left to right, the other
  // along y = 0.25 from right to left.
  const auto placeOf = [](bool fromTheLeft, std::int64_t at) -> Eigen::Vector2d {
    const double x = -1.3 + 0.04 * static_cast<double>(at - 10);
    return fromTheLeft ? Eigen::Vector2d(x, -0.25) : Eigen::Vector2d(-x, 0.25);
  };
  std::map<int, bool> fromTheLeft; // by identity, as it was long before they meet
  for (; frame < 75; ++frame) {
    tracker->step(
        drawPeople(rig, frame, {{placeOf(true, frame), kBlue}, {placeOf(false, frame), kBlue}}),
        team);
    if (frame == 26) { // 1.1 s after they came, 1.4 m apart
      ASSERT_EQ(tracker->people().size(), 2U);
      for (const PersonEstimate& person : tracker->people()) {
        fromTheLeft[person.identity] = person.position.x() < 0.0;
      }
    }
  }
  ASSERT_EQ(fromTheLeft.size(), 2U);
  ASSERT_EQ(tracker->people().size(), 2U);
  for (const PersonEstimate& person : tracker->people()) {
    const auto began = fromTheLeft.find(person.identity);
    ASSERT_NE(began, fromTheLeft.end()) << "person " << person.identity << " is a new one";
    // A swap would put each 2.5 m away from where its own body is.
    EXPECT_LT((person.position.head<2>() - placeOf(began->second, frame - 1)).norm(), 0.2)
        << "person " << person.identity;
  }
  EXPECT_NE(fromTheLeft.begin()->second, fromTheLeft.rbegin()->second);
}

TEST(PeopleMethodNames, HaveParametersAndSentences) {
  for (const std::string& method : methodNames(TargetSource::Images)) {
    EXPECT_FALSE(methodSummary(method).empty());
    for (const ParameterDeclaration& one : methodParameters(method)) {
      EXPECT_LE(one.minimum, one.defaultValue) << one.key;
      EXPECT_GE(one.maximum, one.defaultValue) << one.key;
      EXPECT_FALSE(one.description.empty()) << one.key;
    }
  }
  const auto missing = makeTracker("people", ParameterValues(), room(), {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::MissingKey);
}

} // namespace
} // namespace dewpoint::tests
