// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios in which the target is not always to be seen, or moves under gravity or in a crowd: S17
// to S19.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "tests/experiment/scenarios/scenario_drafts.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

using experiment::scenarios::areSeparated;
using Kind = ScenarioEvent::Kind;

/// Pixels in a camera's image that match the first target's color.
int matching(const ScenarioRun& run, std::size_t camera, std::int64_t frame) {
  const ColorClassifier classifier(run.targets.front().color);
  const ImageDisc all{Eigen::Vector2d::Zero(), 1e6};
  return countIn(run.frames(frame)->frames[camera]->image, all, [&](const cv::Vec3b& pixel) {
    return classifier.matches(pixel[0], pixel[1], pixel[2]);
  });
}

std::optional<std::int64_t> frameOf(const ScenarioRun& run, Kind kind, int camera) {
  for (const ScenarioEvent& event : run.events) {
    if (event.kind == kind && event.camera == camera) {
      return event.frame;
    }
  }
  return std::nullopt;
}

/// 1.2 s aside are 36 frames, and some of the way there and back.
void expectGone(const ScenarioRun& run, std::size_t camera, int eventCamera) {
  const auto begin = frameOf(run, Kind::UnseenBegin, eventCamera);
  const auto end = frameOf(run, Kind::UnseenEnd, eventCamera);
  ASSERT_TRUE(begin && end) << run.scenario;
  EXPECT_GE(*end - *begin, 36) << run.scenario;
  EXPECT_GT(matching(run, camera, 0), 300) << run.scenario;
  EXPECT_LT(matching(run, camera, (*begin + *end) / 2), 10) << run.scenario;
  EXPECT_GT(matching(run, camera, run.frameCount - 1), 300) << run.scenario;
}

TEST(ScenarioOutOfView, TheBallIsNotInTheImagesThatItLeaves) {
  const ScenarioRun one = scenarioRun("S17-leaves-one");
  const int left = frameOf(one, Kind::UnseenBegin, 0) ? 0 : 1;
  expectGone(one, static_cast<std::size_t>(left), left);
  EXPECT_FALSE(frameOf(one, Kind::UnseenBegin, -1)) << "the other camera sees it";
  EXPECT_FALSE(frameOf(one, Kind::UnseenBegin, 1 - left));
  for (const char* name : {"S17-leaves-all", "S17-returns-elsewhere"}) {
    const ScenarioRun all = scenarioRun(name);
    expectGone(all, 0, -1);
    expectGone(all, 1, -1);
    for (const TrajectorySample& sample : all.truth.samples) {
      EXPECT_TRUE(sample.isValid) << "it is still in the room";
    }
  }
}

TEST(ScenarioOutOfView, FurnitureHidesAllOfTheBall) {
  const ScenarioRun run = scenarioRun("S17-furniture");
  // At 1.1 m the ball has 389 pixels, of which 0.7 or more match.
  for (const std::size_t camera : {std::size_t{0}, std::size_t{1}}) {
    const auto begin = frameOf(run, Kind::UnseenBegin, -1);
    const auto end = frameOf(run, Kind::UnseenEnd, -1);
    ASSERT_TRUE(begin && end);
    EXPECT_GE(*end - *begin, 36);
    EXPECT_GT(matching(run, camera, 0), 150);
    EXPECT_LT(matching(run, camera, (*begin + *end) / 2), 10);
    EXPECT_GT(matching(run, camera, run.frameCount - 1), 150);
  }
}

TEST(ScenarioOutOfView, AnImageBorderCutsTheBall) {
  const ScenarioRun run = scenarioRun("S17-border");
  EXPECT_TRUE(run.events.empty()) << "some of it is always seen";
  int cut = 0;
  for (std::int64_t frame = 45; frame < 120; ++frame) { // it hovers from 1.4 to 4.4 s
    for (const Camera& camera : run.trueRig) {
      const ImageDisc disc = discOf(camera, truthAt(run, frame).front(), 0.035);
      const double beside = std::min({disc.center.x(), disc.center.y(),
                                      camera.intrinsics.width - 1.0 - disc.center.x(),
                                      camera.intrinsics.height - 1.0 - disc.center.y()});
      cut += beside < 0.9 * disc.radius ? 1 : 0;
    }
  }
  EXPECT_GE(cut, 50) << "of 75 frames";
}

TEST(ScenarioThrown, TheFlightIsThatOfGravity) {
  const ScenarioRun run = scenarioRun("S18-thrown");
  // Second differences over 1/30 s: where three frames are in free flight they are -9.81 m/s².
  int falling = 0;
  for (std::int64_t frame = 1; frame + 1 < run.frameCount; ++frame) {
    const Eigen::Vector3d acceleration =
        900.0 *
        (truthAt(run, frame + 1)[0] - 2.0 * truthAt(run, frame)[0] + truthAt(run, frame - 1)[0]);
    falling += (acceleration - Eigen::Vector3d(0.0, 0.0, -9.81)).norm() < 1e-6 ? 1 : 0;
  }
  // Throws take 0.24 to 0.32 s: 5 to 8 frames whose neighbors are in flight too. One throw with its
  // pause takes at most 0.84 s.
  EXPECT_GE(falling, 5 * 5);
}

TEST(ScenarioThrown, ABounceEndsOnTheDesk) {
  const ScenarioRun run = scenarioRun("S18-bouncing");
  double lowest = HUGE_VAL;
  double highest = 0.0;
  for (const TrajectorySample& sample : run.truth.samples) {
    lowest = std::min(lowest, sample.position.z());
    highest = std::max(highest, sample.position.z());
  }
  EXPECT_NEAR(lowest, 0.035, 1e-9);
  EXPECT_GT(highest, 0.134);
}

TEST(ScenarioCrowd, OnlyTheTargetIsInTheStartBox) {
  for (const char* name : {"S19-crowd-5", "S19-crowd-8", "S19-crowd-12"}) {
    const ScenarioRun run = scenarioRun(name);
    EXPECT_EQ(run.targets.size(), 1U);
    EXPECT_EQ(run.equalCandidateCount, 1);
    EXPECT_TRUE(((truthAt(run, 0)[0] - run.startCenter).array().abs() <= 0.02).all());
    EXPECT_EQ(run.startHalfSize, Eigen::Vector3d::Constant(0.05));
    // Six balls or more of 389 pixels at the middle's distance, some before others.
    EXPECT_GT(matching(run, 0, 0), 2 * 389) << name;
  }
}

/// Where all balls of a crowd are, meters; the first one is the target.
std::vector<Eigen::Vector3d> ballsAt(const ScenarioDraft& draft, double time) {
  std::vector<Eigen::Vector3d> balls;
  for (const simulation::StageBody& body : draft.stage.bodies) {
    balls.push_back(body.path(time));
  }
  return balls;
}

/// Whether a point is behind a ball or something of the room as a camera sees it.
bool isHidden(const ScenarioDraft& draft, std::size_t camera,
              const std::vector<Eigen::Vector3d>& balls, const Eigen::Vector3d& point) {
  const simulation::RoomView& view = *draft.stage.views[camera];
  const Eigen::Vector3d eye = draft.rig[camera].center();
  const auto pixel = view.projector.project(point);
  EXPECT_TRUE(pixel);
  const auto column = static_cast<int>(std::lround(pixel->x()));
  const auto row = static_cast<int>(std::lround(pixel->y()));
  return view.distances[view.pixelIndex(column, row)] < (point - eye).norm() ||
         std::ranges::any_of(balls, [&](const Eigen::Vector3d& other) {
           return (other - eye).norm() < (point - eye).norm() - 1e-9 &&
                  !areSeparated(view, other, 0.035, point, 1e-6);
         });
}

TEST(ScenarioCrowd, AsManyBallsAreInTheImagesAsTheNameSays) {
  for (const auto& [name, distractors] :
       {std::pair("S19-crowd-5", 5), std::pair("S19-crowd-8", 8), std::pair("S19-crowd-12", 12),
        std::pair("S19-crowd-8-four-cameras", 8)}) {
    const ScenarioDraft draft = draftOf(experiment::scenarios::crowdScenarios(), name);
    const auto balls = ballsAt(draft, 0.0);
    ASSERT_EQ(balls.size(), static_cast<std::size_t>(distractors) + 1) << name;
    const ScenarioRun run = scenarioRun(name);
    const FrameSetPtr set = run.frames(0);
    for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
      std::size_t seen = 0;
      for (const Eigen::Vector3d& ball : balls) {
        if (isHidden(draft, camera, balls, ball)) {
          continue;
        }
        ++seen;
        const ImageDisc middle{discOf(draft.rig[camera], ball, 0.035).center, 3.0};
        EXPECT_GT(matchingShare(set->frames[camera]->image, run.targets.front().color, middle), 0.7)
            << name << ", camera " << camera << ": not at " << ball.transpose();
      }
      EXPECT_GE(2 * seen, balls.size()) << name;
    }
  }
}

TEST(ScenarioCrowd, BallsTouchAndCoverTheTarget) {
  constexpr double kRadius = 0.035;
  int ofTarget = 0;
  for (const char* name : {"S19-crowd-5", "S19-crowd-8", "S19-crowd-12"}) {
    const ScenarioDraft draft = draftOf(experiment::scenarios::crowdScenarios(), name);
    double nearest = HUGE_VAL;
    int contacts = 0; // counted as long as they last
    for (int instant = 0; instant < 6 * 240; ++instant) {
      const auto balls = ballsAt(draft, instant / 240.0);
      for (std::size_t one = 0; one < balls.size(); ++one) {
        for (std::size_t other = one + 1; other < balls.size(); ++other) {
          const double distance = (balls[one] - balls[other]).norm();
          nearest = std::min(nearest, distance);
          contacts += distance < 2.02 * kRadius ? 1 : 0;
          ofTarget += one == 0 && distance < 2.02 * kRadius ? 1 : 0;
        }
      }
    }
    // At 0.2 m/s among 5 others in 36 x 36 x 22 cm a ball flies 0.22 m from one to the next.
    EXPECT_GT(contacts, 0) << name;
    EXPECT_GT(nearest, 1.9 * kRadius) << name << ": a step at 0.8 m/s is 3 mm";
    int covered = 0; // frames and cameras
    for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
      const auto balls = ballsAt(draft, draft.timeOf(frame));
      for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
        const Eigen::Vector3d eye = draft.rig[camera].center();
        covered += std::any_of(balls.begin() + 1, balls.end(), [&](const Eigen::Vector3d& other) {
          return (other - eye).norm() < (balls[0] - eye).norm() &&
                 !areSeparated(*draft.stage.views[camera], balls[0], kRadius, other, kRadius);
        });
      }
    }
    // Each of them covers some of it in a twelfth of the frames: 150 of 360 for five.
    EXPECT_GT(covered, 30) << name;
  }
  EXPECT_GT(ofTarget, 0);
}

TEST(ScenarioCrowd, AnEvenStartFavorsNeither) {
  const ScenarioRun run = scenarioRun("S19-even-start");
  EXPECT_EQ(run.equalCandidateCount, 2);
  // The box reaches 0.05 m beyond both balls: the target is on its border but for those.
  const Eigen::Vector3d off = (truthAt(run, 0)[0] - run.startCenter).cwiseAbs();
  EXPECT_TRUE((run.startHalfSize - off).isApprox(Eigen::Vector3d::Constant(0.05), 1e-9));
  EXPECT_EQ(scenarioRun("S0-slow").equalCandidateCount, 1);
}

TEST(ScenarioSeen, SameSeedSameBits) {
  for (const char* name : {"S17-furniture", "S18-spinning", "S19-crowd-8"}) {
    expectSameBits(name, 70);
  }
}

} // namespace
} // namespace dewpoint::tests
