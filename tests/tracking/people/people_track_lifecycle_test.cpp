// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_parameters.h"
#include "core/tracking/people/people_track_lifecycle.h"
#include "tests/tracking/people/people_room.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>

namespace dewpoint::tests {
namespace {

using bodies::kHeight;
using bodies::kPlace;

/// People who stand where they were put: what is left is who comes and who goes.
class StandingPeople : public PeopleTrackLifecycle {
public:
  using PeopleTrackLifecycle::PeopleTrackLifecycle;

  BodyCloud bodyOf(int) const override { return {}; }
  std::unique_ptr<Tracker> clone() const override { return nullptr; }
  /// Moves people_ in every frame.
  std::function<void(std::vector<PersonEstimate>&)> move = [](auto&) {};
  bool masksAreShared = true;
  std::vector<int> bornOnes;         ///< identities, in the order of their births
  std::vector<std::size_t> goneOnes; ///< indices, at the time they went

protected:
  void createBelief(const PersonEstimate& person, const RandomKey&) override {
    bornOnes.push_back(person.identity);
  }
  void removeBelief(std::size_t index) override { goneOnes.push_back(index); }
  void removeAllBeliefs() override {
    bornOnes.clear();
    goneOnes.clear();
  }
  std::size_t beliefMemoryBytes() const override { return 0; }
  void updateBeliefs(ThreadTeam&) override { move(people_); }
  bool ignoresForegroundOfKnownPeople() const override { return masksAreShared; }
};

ParameterValues lifecycleValues(bool births) {
  ParameterValues values(peopleParameters());
  EXPECT_TRUE(values.set("image_width", 0.0)); // images as they are
  EXPECT_TRUE(values.set("births", births ? 1.0 : 0.0));
  EXPECT_TRUE(values.set("survival_time", 0.6));
  EXPECT_TRUE(values.set("birth_time", 0.2));
  EXPECT_TRUE(values.set("area_half_x", 2.0));
  EXPECT_TRUE(values.set("area_half_y", 2.0));
  return values;
}

/// Existence is exact to this: time stamps are whole nanoseconds, of 0.6 s.
constexpr double kExact = 1e-8;

/// The first frame counts 1/30 s, because there is none before it, every other one 1/15 s.
class PeopleTrackLifecycleTest : public ::testing::Test {
protected:
  explicit PeopleTrackLifecycleTest(bool births = false, CameraRig rig = bodies::room())
      : rig_(std::move(rig)), life_(lifecycleValues(births), rig_) {
    life_.setBackgroundImages(bodies::backgroundImages(rig_));
    life_.restart(1);
  }
  /// The next frame; people stand on these places in the images.
  void step(const std::vector<Eigen::Vector2d>& people) {
    show(bodies::draw(rig_, frame_++, people));
  }
  void show(FrameSetPtr frames) {
    life_.beginFrame(std::move(frames));
    life_.iterate(team_);
  }
  int put(const Eigen::Vector2d& place) {
    return life_.addPerson({place.x(), place.y(), 0.5 * kHeight});
  }
  const PersonEstimate& person(std::size_t index) const { return life_.people().at(index); }
  std::size_t count() const { return life_.people().size(); }

  const CameraRig rig_;
  StandingPeople life_;
  ThreadTeam team_;
  std::int64_t frame_ = 0;
};

const Eigen::Vector2d kOther(-0.8, 0.6);

// Unseen for 1/30 + (n - 1) / 15 s after n frames; existence is what that leaves of 0.6 s. After
// nine frames it is 1 - (17/30) / 0.6 = 1/18, in the tenth nothing is left.
TEST_F(PeopleTrackLifecycleTest, WhomNobodySeesFadesEvenlyAndGoes) {
  put(kPlace);
  for (int n = 1; n <= 9; ++n) {
    step({});
    ASSERT_EQ(count(), 1U) << n;
    EXPECT_NEAR(person(0).existenceProbability, 1.0 - (1.0 / 30.0 + (n - 1) / 15.0) / 0.6, kExact)
        << n;
    EXPECT_EQ(person(0).seeingCameraCount, 0);
  }
  EXPECT_TRUE(life_.goneOnes.empty());
  step({});
  EXPECT_EQ(count(), 0U);
  EXPECT_EQ(life_.goneOnes, (std::vector<std::size_t>{0}));
}

// Four frames unseen are 7/30 s; one with sight takes back 2/15 s and leaves 3/30, the next one
// all.
TEST_F(PeopleTrackLifecycleTest, WhoIsSeenAgainWinsBackTwiceAsFast) {
  put(kPlace);
  for (int n = 0; n < 4; ++n) {
    step({});
  }
  EXPECT_NEAR(person(0).existenceProbability, 1.0 - (7.0 / 30.0) / 0.6, kExact);
  step({kPlace});
  EXPECT_NEAR(person(0).existenceProbability, 1.0 - (3.0 / 30.0) / 0.6, kExact);
  EXPECT_EQ(person(0).seeingCameraCount, 4);
  step({kPlace});
  EXPECT_EQ(person(0).existenceProbability, 1.0);
  EXPECT_NEAR(person(0).ageSeconds, 1.0 / 30.0 + 5.0 / 15.0, kExact);
}

TEST_F(PeopleTrackLifecycleTest, WithoutAnyImageNothingChanges) {
  put(kPlace);
  step({});
  const double before = person(0).existenceProbability;
  FrameSet blind = *bodies::draw(rig_, frame_++, {});
  blind.frames.assign(4, nullptr);
  show(std::make_shared<const FrameSet>(blind));
  EXPECT_EQ(person(0).existenceProbability, before);
  life_.iterate(team_); // nor does another iteration on the same frame
  EXPECT_EQ(person(0).existenceProbability, before);
}

TEST_F(PeopleTrackLifecycleTest, WhoCrossesTheBorderHasLeft) {
  put(kPlace);
  life_.move = [](std::vector<PersonEstimate>& people) {
    people[0].position.x() = 1.99; // of 2 m
  };
  step({{1.99, kPlace.y()}});
  EXPECT_EQ(count(), 1U);
  life_.move = [](std::vector<PersonEstimate>& people) { people[0].position.x() = 2.01; };
  step({{2.01, kPlace.y()}});
  EXPECT_EQ(count(), 0U);
}

// An identity is never given twice, and how long each was unseen stays with them.
TEST_F(PeopleTrackLifecycleTest, WhoIsRemovedTakesNothingFromTheOthers) {
  EXPECT_EQ(put(kPlace), 1);
  EXPECT_EQ(put({1.2, 1.2}), 2);
  EXPECT_EQ(put(kOther), 3);
  step({kPlace});
  life_.removePerson(2);
  EXPECT_EQ(life_.goneOnes, (std::vector<std::size_t>{1}));
  ASSERT_EQ(count(), 2U);
  EXPECT_EQ(person(1).identity, 3);
  EXPECT_EQ(put({1.2, 1.2}), 4);
  EXPECT_EQ(life_.bornOnes, (std::vector<int>{1, 2, 3, 4}));
  step({kPlace});
  EXPECT_EQ(person(0).existenceProbability, 1.0);
  EXPECT_NEAR(person(1).existenceProbability, 1.0 - (3.0 / 30.0) / 0.6, kExact); // both frames
  EXPECT_NEAR(person(2).existenceProbability, 1.0 - (2.0 / 30.0) / 0.6, kExact); // the second only
  life_.removePerson(99);                                                        // nobody
  EXPECT_EQ(count(), 3U);
  life_.restart(1);
  EXPECT_EQ(count(), 0U);
  EXPECT_EQ(put(kPlace), 1);
}

TEST_F(PeopleTrackLifecycleTest, PeopleWithinAMeterInteract) {
  put({0.0, 0.0});
  put({0.9, 0.0});
  put({0.0, -1.1});
  step({});
  EXPECT_TRUE(person(0).isInteracting);
  EXPECT_TRUE(person(1).isInteracting);
  EXPECT_FALSE(person(2).isInteracting);
}

/// Two cameras as high as the middle of a body, looking along y and along -x.
CameraRig crosswise() {
  CameraRig rig = bodies::room();
  rig.resize(2);
  rig[0].cameraFromWorld = lookAt({0.0, -3.0, 0.5 * kHeight}, {0.0, 0.0, 0.5 * kHeight});
  rig[1].cameraFromWorld = lookAt({2.25, 0.0, 0.5 * kHeight}, {0.0, 0.0, 0.5 * kHeight});
  return rig;
}

/// Beside each other for the first camera; for the second one stands 1.5 m behind the other, at
/// twice the distance, and is half as large in the image: covered all over.
class OneBehindTheOther : public PeopleTrackLifecycleTest {
protected:
  OneBehindTheOther() : PeopleTrackLifecycleTest(false, crosswise()) {
    put(kFront);
    put(kBehind);
  }
  const Eigen::Vector2d kFront{0.75, 0.0};
  const Eigen::Vector2d kBehind{-0.75, 0.0};
};

// Two cameras are needed. One sees the one behind, the other cannot judge: a hidden person fades
// four times as slowly, 1/30 s count 1/120.
TEST_F(OneBehindTheOther, WhoIsHiddenFadesSlowly) {
  step({kFront, kBehind});
  EXPECT_EQ(person(0).seeingCameraCount, 2);
  EXPECT_EQ(person(0).existenceProbability, 1.0);
  EXPECT_EQ(person(1).seeingCameraCount, 1);
  EXPECT_NEAR(person(1).existenceProbability, 1.0 - (1.0 / 120.0) / 0.6, kExact);
}

TEST_F(OneBehindTheOther, AMethodThatSharesNoMasksSeesBoth) {
  life_.masksAreShared = false;
  step({kFront, kBehind});
  EXPECT_EQ(person(1).seeingCameraCount, 2);
  EXPECT_EQ(person(1).existenceProbability, 1.0);
}

// Where the one behind is not at all, no camera sees anything of them: nothing is forgiven.
TEST_F(OneBehindTheOther, WhoIsSeenNowhereFadesAsFastAsAnybody) {
  step({kFront});
  EXPECT_EQ(person(1).seeingCameraCount, 0);
  EXPECT_NEAR(person(1).existenceProbability, 1.0 - (1.0 / 30.0) / 0.6, kExact);
}

class PeopleTrackLifecycleWithBirths : public PeopleTrackLifecycleTest {
protected:
  PeopleTrackLifecycleWithBirths() : PeopleTrackLifecycleTest(true) {}
};

// Seen for 3/15 s in the fourth frame, see PeopleTrackInitiationTest.
TEST_F(PeopleTrackLifecycleWithBirths, SomebodyWhoComesIsBornOnce) {
  for (int frame = 0; frame < 3; ++frame) {
    step({kPlace});
    EXPECT_EQ(count(), 0U);
  }
  step({kPlace});
  ASSERT_EQ(count(), 1U);
  EXPECT_EQ(person(0).identity, 1);
  // The middle of a body of the usual height on the floor.
  EXPECT_LT((person(0).position - Eigen::Vector3d(kPlace.x(), kPlace.y(), 0.86)).norm(), 1e-9);
  EXPECT_EQ(person(0).existenceProbability, 1.0);
  for (int frame = 0; frame < 10; ++frame) {
    step({kPlace});
  }
  EXPECT_EQ(count(), 1U);
  EXPECT_EQ(life_.bornOnes, (std::vector<int>{1}));
}

TEST_F(PeopleTrackLifecycleWithBirths, NobodyIsBornOnTheBorder) {
  for (int frame = 0; frame < 10; ++frame) {
    step({{2.0, 0.0}});
  }
  EXPECT_EQ(count(), 0U);
  for (int frame = 0; frame < 10; ++frame) {
    step({{1.8, 0.0}});
  }
  EXPECT_EQ(count(), 1U);
}

} // namespace
} // namespace dewpoint::tests
