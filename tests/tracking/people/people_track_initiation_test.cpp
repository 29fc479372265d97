// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/people/people_track_initiation.h"
#include "tests/tracking/people/people_room.h"

#include <gtest/gtest.h>

#include <optional>

namespace dewpoint::tests {
namespace {

using bodies::kHeight;
using bodies::kPlace;
using bodies::kRate;

constexpr double kBirthTime = 0.2; ///< seconds: three intervals of 1/15 s

/// Frames of the room, looked at one after the other.
class PeopleTrackInitiationTest : public ::testing::Test {
protected:
  PeopleTrackInitiationTest() : cameras_(rig_, settings()) {
    cameras_.setBackgroundImages(bodies::backgroundImages(rig_));
    cameras_.restart();
    births_.setCameras(cameras_, settings().area, kHeight);
  }
  static PeopleSettings settings() {
    PeopleSettings settings;
    settings.learningSeconds = 0.0;
    settings.area.halfSize = {2.0, 2.0};
    return settings;
  }

  using Places = std::vector<Eigen::Vector2d>;
  /// Who is born in the next frame. Cameras in `blind` have no image.
  Places look(const Places& people, const Places& taken = {},
              const std::vector<std::size_t>& blind = {}) {
    FrameSet frames = *bodies::draw(rig_, frame_++, people);
    for (const std::size_t camera : blind) {
      frames.frames[camera] = nullptr;
    }
    cameras_.computeForegroundMasks(frames, {}, team_);
    return births_.update(cameras_, explained_, taken, kBirthTime);
  }
  /// After how many frames with these people, the next one is 1, the first is born.
  std::optional<int> framesToBirth(const Places& people, const Places& taken = {},
                                   const std::vector<std::size_t>& blind = {}) {
    for (int frame = 1; frame <= 10; ++frame) {
      if (!look(people, taken, blind).empty()) {
        return frame;
      }
    }
    return std::nullopt;
  }

  const CameraRig rig_ = bodies::room();
  PeopleCameras cameras_;
  PeopleTrackInitiation births_;
  std::vector<cv::Mat> explained_;
  ThreadTeam team_;
  std::int64_t frame_ = 0;
};

// Seen for 0 s in the first frame, for 1/15, 2/15 and 3/15 s in the next: 0.2 s in the fourth.
TEST_F(PeopleTrackInitiationTest, SomebodyIsBornWhoIsSeenForTheBirthTime) {
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_TRUE(look({kPlace}).empty()) << frame;
  }
  const auto born = look({kPlace});
  ASSERT_EQ(born.size(), 1U);
  // There all four cameras show a whole body, nowhere else do they show more of one.
  EXPECT_LT((born[0] - kPlace).norm(), 1e-9);
  // Who was born is no candidate any more: the time begins again.
  EXPECT_EQ(framesToBirth({kPlace}), 4);
}

// A frame without sight takes back what the one before it gave: after 0, 1/15 and 0 s the time goes
// on with 1/15, 2/15, 3/15 s.
TEST_F(PeopleTrackInitiationTest, AFrameWithoutSightCostsAsMuchAsOneGains) {
  look({kPlace});
  look({kPlace});
  look({});
  EXPECT_EQ(framesToBirth({kPlace}), 3);
}

// A candidate is forgotten 0.15 s after it had nothing more to lose: -2/15 s are borne, -3/15 not.
// Who is remembered begins with 1/15 s, who is new with 0.
TEST_F(PeopleTrackInitiationTest, ACandidateIsRememberedForAWhile) {
  look({kPlace});
  look({});
  look({});
  EXPECT_EQ(framesToBirth({kPlace}), 3);
  look({kPlace});
  look({});
  look({});
  look({});
  EXPECT_EQ(framesToBirth({kPlace}), 4);
}

TEST_F(PeopleTrackInitiationTest, ARestartForgetsWhoIsUnderWay) {
  look({kPlace});
  look({kPlace});
  look({kPlace});
  births_.restart();
  EXPECT_EQ(framesToBirth({kPlace}), 4);
}

// Half a meter around people nobody is born, whatever the masks say.
TEST_F(PeopleTrackInitiationTest, NobodyIsBornWhereSomebodyStands) {
  const Eigen::Vector2d stands = kPlace + Eigen::Vector2d(0.3, 0.0);
  for (int frame = 0; frame < 10; ++frame) {
    for (const Eigen::Vector2d& born : look({kPlace}, {stands})) {
      EXPECT_GE((born - stands).norm(), 0.5);
    }
  }
  births_.restart();
  EXPECT_EQ(framesToBirth({kPlace}, {kPlace + Eigen::Vector2d(0.0, 0.51)}), 4);
}

TEST_F(PeopleTrackInitiationTest, ForegroundThatIsExplainedGivesBirthToNobody) {
  explained_.assign(4, cv::Mat(240, 320, CV_8UC1, cv::Scalar(255)));
  EXPECT_FALSE(framesToBirth({kPlace}));
}

TEST_F(PeopleTrackInitiationTest, TwoCamerasAreEnoughAndOneIsNot) {
  EXPECT_EQ(framesToBirth({kPlace}, {}, {2, 3}), 4);
  births_.restart();
  EXPECT_FALSE(framesToBirth({kPlace}, {}, {0, 1, 2}));
}

TEST_F(PeopleTrackInitiationTest, OneIsBornPerFrame) {
  const Eigen::Vector2d other(-1.0, 0.6);
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_TRUE(look({kPlace, other}).empty());
  }
  const auto first = look({kPlace, other});
  const auto second = look({kPlace, other}, first);
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_NEAR((first[0] - second[0]).norm(), (kPlace - other).norm(), 1e-9);
}

} // namespace
} // namespace dewpoint::tests
