// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios whose ball is not a whole ball of one color before a room of other colors: S11 to S13.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/targets/hidden_share.h"
#include "core/geometry/ray.h"
#include "tests/experiment/scenarios/scenario_drafts.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

/// Shares of the first target's disc that match its color, one per camera.
std::vector<double> sharesAt(const ScenarioRun& run, std::int64_t frame) {
  const FrameSetPtr set = run.frames(frame);
  std::vector<double> shares;
  for (std::size_t camera = 0; camera < run.trueRig.size(); ++camera) {
    const ImageDisc disc =
        discOf(run.trueRig[camera], truthAt(run, frame).front(), run.targets.front().radius);
    shares.push_back(matchingShare(set->frames[camera]->image, run.targets.front().color, disc));
  }
  return shares;
}

/// The parts of the target's body at a frame, in the world.
std::vector<simulation::MovingPart> partsAt(const ScenarioDraft& draft, std::int64_t frame) {
  auto parts = draft.stage.bodies.front().partsAt(draft.timeOf(frame));
  for (simulation::MovingPart& part : parts) {
    part.center += centerAt(draft, frame).cast<float>();
  }
  return parts;
}

/// The draft with its target's parts changed, and without noise.
template <class Change> ScenarioDraft changed(ScenarioDraft draft, const Change& change) {
  simulation::StageBody& body = draft.stage.bodies.front();
  body.parts = [parts = body.parts, change](double time) { return change(parts(time)); };
  draft.stage.noiseSigma = 0.0;
  return draft;
}

ImageDisc discAt(const ScenarioDraft& draft, std::size_t camera, std::int64_t frame) {
  return discOf(draft.rig[camera], centerAt(draft, frame), draft.stage.bodies.front().radius);
}

/// Share of the pixels of the target's disc for which `counts` in one image that are another thing
/// in the other image.
template <class Counts>
double lostShare(const cv::Mat& before, const cv::Mat& after, const ImageDisc& disc,
                 const Counts& counts) {
  int all = 0;
  int lost = 0;
  for (int row = 0; row < before.rows; ++row) {
    for (int column = 0; column < before.cols; ++column) {
      const bool inside = (Eigen::Vector2d(column, row) - disc.center).norm() < disc.radius;
      if (inside && counts(before.at<cv::Vec3b>(row, column))) {
        ++all;
        lost += counts(after.at<cv::Vec3b>(row, column)) ? 0 : 1;
      }
    }
  }
  EXPECT_GT(all, 300);
  return static_cast<double>(lost) / std::max(1, all);
}

/// Green is 0.35 of red on the ball and 0.76 on skin, however light they are.
bool isBall(const cv::Vec3b& pixel) {
  return pixel[1] < 0.55 * pixel[2];
}

/// How much of the disc the hand hides: by rays, and in the image of the run.
std::pair<double, double> hiddenByHand(const ScenarioDraft& draft, const ScenarioRun& run,
                                       std::size_t camera, std::int64_t frame) {
  auto hand = partsAt(draft, frame);
  hand.pop_back(); // the ball
  const double byRays = experiment::scenarios::hiddenShare(
      draft.rig[camera].center(), centerAt(draft, frame), draft.stage.bodies.front().radius, hand);
  const ScenarioDraft bare = changed(
      draft, [](const auto& parts) { return std::vector<simulation::MovingPart>{parts.back()}; });
  return {byRays,
          lostShare(imageOf(bare, camera, frame), run.frames(frame)->frames.at(camera)->image,
                    discAt(draft, camera, frame), isBall)};
}

TEST(ScenarioHeld, ThirtyToSixtyPercentAreHiddenInEveryCamera) {
  for (const auto& [name, frames] :
       {std::pair("S11-held", std::vector<std::int64_t>{0, 60, 120, 177}),
        std::pair("S11-grasped", std::vector<std::int64_t>{60, 120, 177})}) {
    const ScenarioDraft draft = draftOf(experiment::scenarios::handHeldTargetScenarios(), name);
    const ScenarioRun run = scenarioRun(name);
    for (const std::int64_t frame : frames) { // of those at which the scenario itself looks
      for (const std::size_t camera : {0U, 1U}) {
        const auto [byRays, inImage] = hiddenByHand(draft, run, camera, frame);
        EXPECT_GE(byRays, 0.30) << name << " " << frame;
        EXPECT_LE(byRays, 0.60) << name << " " << frame;
        // Fingers have up to 200 px of outline on a disc of 1900, which is half of a blur of 2 px
        // off at most; 150 rays are good for 0.01 to 0.04.
        EXPECT_NEAR(inImage, byRays, 0.1) << name << " " << frame;
      }
    }
  }
}

TEST(ScenarioHeld, TheHandThatComesIsThereFromFrame60) {
  const ScenarioRun grasped = scenarioRun("S11-grasped");
  const std::vector<double> before = sharesAt(grasped, 20);
  const std::vector<double> after = sharesAt(grasped, 60);
  for (std::size_t camera = 0; camera < before.size(); ++camera) {
    EXPECT_GT(before[camera], 0.7);
    EXPECT_LT(after[camera], 0.75);
    EXPECT_LT(after[camera], before[camera] - 0.1) << "30 % of the disc is hidden at least";
  }
}

/// The painted ball of a scenario at time 0.
simulation::MovingPart paintedBall(const std::string& name, std::uint64_t seed) {
  const auto draft = draftOf(experiment::scenarios::patternedBallScenarios(), name, seed);
  const auto parts = partsAt(draft, 0);
  EXPECT_EQ(parts.size(), 1U);
  EXPECT_NE(parts.front().pattern, nullptr);
  return parts.front();
}

void expectHalfAngles(const simulation::SurfacePattern& pattern, std::size_t count, double least,
                      double most) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  ASSERT_EQ(pattern.patches.size(), count);
  EXPECT_TRUE(pattern.seams.empty());
  for (const simulation::SurfacePatch& patch : pattern.patches) {
    EXPECT_GE(std::acos(patch.maxAngleCosine), least * kDegree - 1e-3);
    EXPECT_LE(std::acos(patch.maxAngleCosine), most * kDegree + 1e-3);
  }
}

TEST(ScenarioPatterned, PaintIsAsLargeAsTheTableSays) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    // 22 to 32 mm on a ball of 70 mm: half angles asin(11 / 35) to asin(16 / 35).
    expectHalfAngles(*paintedBall("S12-one-patch", seed).pattern, 1, 18.32, 27.20);
    const auto two = paintedBall("S12-two-patches", seed).pattern;
    expectHalfAngles(*two, 2, 35.0, 45.0);
    EXPECT_NEAR(two->patches[0].axis.dot(two->patches[1].axis), -1.0F, 1e-5F);
    const auto three = paintedBall("S12-three-patches", seed).pattern;
    expectHalfAngles(*three, 3, 35.0, 45.0);
    EXPECT_NEAR(three->patches[0].axis.dot(three->patches[1].axis), -0.5F, 1e-5F);
    const auto six = paintedBall("S12-six-spots", seed).pattern;
    expectHalfAngles(*six, 6, 14.0, 18.0);
    EXPECT_NEAR(six->patches[0].axis.dot(six->patches[2].axis), 0.0F, 1e-5F);
    expectHalfAngles(*paintedBall("S12-two-colors", seed).pattern, 1, 90.0, 90.0);
    const auto seams = paintedBall("S12-seams", seed).pattern;
    EXPECT_TRUE(seams->patches.empty());
    ASSERT_EQ(seams->seams.size(), 2U);
    EXPECT_NEAR(seams->seams[0].axis.dot(seams->seams[1].axis), 0.0F, 1e-5F);
    EXPECT_GE(seams->seams[0].maxAngleSine, 2.5 / 35.0 - 1e-5); // 5 to 7 mm
    EXPECT_LE(seams->seams[0].maxAngleSine, 3.5 / 35.0 + 1e-5);
    const simulation::MovingPart shiny = paintedBall("S12-highlight", seed);
    EXPECT_TRUE(shiny.pattern->patches.empty() && shiny.pattern->seams.empty());
    EXPECT_GE(shiny.gloss.peakLevel, 400.0F);
    EXPECT_LE(shiny.gloss.peakLevel, 600.0F);
    EXPECT_GE(shiny.gloss.exponent, 20.0F);
    EXPECT_LE(shiny.gloss.exponent, 60.0F);
  }
}

/// Share of the pixels for which `counts` in the plain ball's image at which a ray meets paint; all
/// of the disc's pixels count without that image.
template <class Counts>
double paintedShare(const ScenarioDraft& draft, std::size_t camera, std::int64_t frame,
                    const cv::Mat& plain, const Counts& counts) {
  const simulation::MovingPart ball = partsAt(draft, frame).front();
  const Unprojector unprojector(draft.rig[camera]);
  const Eigen::Vector3f eye = draft.rig[camera].center().cast<float>();
  const ImageDisc disc = discAt(draft, camera, frame);
  int all = 0;
  int painted = 0;
  for (double row = std::ceil(disc.center.y() - disc.radius); row < disc.center.y() + disc.radius;
       ++row) {
    for (double column = std::ceil(disc.center.x() - disc.radius);
         column < disc.center.x() + disc.radius; ++column) {
      const auto direction = unprojector.worldDirection({column, row});
      simulation::PartHit hit;
      intersectPart(ball, eye, direction->cast<float>(), hit);
      const cv::Point pixel(static_cast<int>(column), static_cast<int>(row));
      if (hit.part != nullptr && (plain.empty() || counts(plain.at<cv::Vec3b>(pixel)))) {
        ++all;
        painted += ball.colorAt(hit.normal) != ball.color ? 1 : 0;
      }
    }
  }
  return static_cast<double>(painted) / std::max(1, all);
}

/// Expects in the camera and frame that show most paint that what does not match the target's color
/// is what is painted. Returns its share.
double mostPaint(const std::string& name, std::uint64_t seed) {
  const ScenarioDraft draft = draftOf(experiment::scenarios::patternedBallScenarios(), name, seed);
  const ScenarioRun run = scenarioRun(name, seed);
  const ColorClassifier classifier(run.targets.front().color);
  const auto matches = [&](const cv::Vec3b& pixel) {
    return classifier.matches(pixel[0], pixel[1], pixel[2]);
  };
  std::size_t camera = 0;
  std::int64_t frame = 0;
  double most = -1.0;
  for (std::int64_t at = 0; at < draft.frameCount; at += 10) {
    for (const std::size_t one : {0U, 1U}) {
      const double share = paintedShare(draft, one, at, {}, matches);
      if (share > most) {
        most = share;
        camera = one;
        frame = at;
      }
    }
  }
  const ScenarioDraft unpainted = changed(draft, [](std::vector<simulation::MovingPart> parts) {
    parts.front().pattern = nullptr;
    return parts;
  });
  const cv::Mat plain = imageOf(unpainted, camera, frame);
  const double expected = paintedShare(draft, camera, frame, plain, matches);
  const double found = lostShare(plain, run.frames(frame)->frames.at(camera)->image,
                                 discAt(draft, camera, frame), matches);
  // Of blurred borders, 200 px of 1900 for the seams, half a pixel more matches beside dark paint,
  // and less beside white.
  EXPECT_NEAR(found, expected, 0.1) << name << " " << seed;
  EXPECT_GT(found, 0.3 * expected) << name << " " << seed;
  return found;
}

TEST(ScenarioPatterned, PaintDoesNotMatchTheTargetsColor) {
  // What is least seen of it in the best of 36 views, of two seeds. A cap of half angle a that
  // faces the camera takes sin(a)² of the disc: 0.1 of it for the smallest patch, 0.33 for a large
  // one; it may be 60 degrees off. Six spots are 0.09 and seams 0.14 of the ball, from all sides
  // alike.
  for (const auto& [name, least] :
       {std::pair("S12-one-patch", 0.03), std::pair("S12-two-patches", 0.1),
        std::pair("S12-three-patches", 0.15), std::pair("S12-six-spots", 0.04),
        std::pair("S12-seams", 0.05), std::pair("S12-two-colors", 0.3)}) {
    EXPECT_GT(std::max(mostPaint(name, 1), mostPaint(name, 2)), least) << name;
  }
}

TEST(ScenarioPatterned, BallsRotate) {
  for (const char* name : {"S12-one-patch", "S12-highlight"}) {
    const ScenarioDraft draft = draftOf(experiment::scenarios::patternedBallScenarios(), name);
    const Eigen::Matrix3f before = partsAt(draft, 0).front().axes;
    const Eigen::Matrix3f after = partsAt(draft, 3).front().axes;
    const double turn = Eigen::AngleAxisf(Eigen::Matrix3f(after * before.transpose())).angle();
    // 0.25 to 1 rounds per second for a tenth of one.
    EXPECT_GT(turn, 0.025 * 2.0 * std::numbers::pi - 1e-3);
    EXPECT_LT(turn, 0.1 * 2.0 * std::numbers::pi + 1e-3);
  }
}

TEST(ScenarioPatterned, LargePatchesTakeTheirShareOfTheDisc) {
  // Three caps of half angles 35 to 45 degrees are 27 to 44 % of a ball, and as much of its discs
  // on average over the directions.
  const ScenarioRun run = scenarioRun("S12-three-patches");
  double sum = 0.0;
  double least = 1.0;
  double most = 0.0;
  for (const std::int64_t frame : {0, 15, 30, 45, 60, 75, 90, 105}) {
    for (const double share : sharesAt(run, frame)) {
      sum += share / 16.0;
      least = std::min(least, share);
      most = std::max(most, share);
    }
  }
  EXPECT_GT(sum, 0.3);
  EXPECT_LT(sum, 0.8);
  EXPECT_GT(most - least, 0.1) << "it rotates";
}

TEST(ScenarioPatterned, AHighlightIsClipped) {
  const ScenarioRun run = scenarioRun("S12-highlight");
  const FrameSetPtr set = run.frames(0);
  int clipped = 0;
  for (std::size_t camera = 0; camera < run.trueRig.size(); ++camera) {
    const ImageDisc disc =
        discOf(run.trueRig[camera], truthAt(run, 0).front(), run.targets.front().radius);
    clipped += countIn(set->frames[camera]->image, disc, [](const cv::Vec3b& pixel) {
      return pixel[0] > 245 && pixel[1] > 245 && pixel[2] > 245; // noise is 3 gray levels
    });
  }
  EXPECT_GT(clipped, 20);
}

/// The most pixels beside the ball, of some frames, that match its color.
int mostBeside(const ScenarioRun& run, std::size_t camera) {
  const ColorClassifier classifier(run.targets.front().color);
  int most = 0;
  for (std::int64_t frame = 0; frame < run.frameCount; frame += 30) {
    const cv::Mat image = run.frames(frame)->frames[camera]->image;
    ImageDisc disc =
        discOf(run.trueRig[camera], truthAt(run, frame).front(), run.targets.front().radius);
    disc.radius *= 1.2; // its outline is drawn softly
    const auto matches = [&](const cv::Vec3b& pixel) {
      return classifier.matches(pixel[0], pixel[1], pixel[2]);
    };
    most =
        std::max(most, countIn(image, {disc.center, 1e6}, matches) - countIn(image, disc, matches));
  }
  return most;
}

TEST(ScenarioPoster, MoreThanTheBallMatches) {
  // A ball that crosses the border of a poster does not hide all of it. Nothing else is pink.
  EXPECT_LT(mostBeside(scenarioRun("S0-slow"), 0), 50);
  const ScenarioRun one = scenarioRun("S13-one-camera");
  EXPECT_GT(std::max(mostBeside(one, 0), mostBeside(one, 1)), 300);
  const ScenarioRun both = scenarioRun("S13-both-cameras");
  EXPECT_GT(std::min(mostBeside(both, 0), mostBeside(both, 1)), 300);
  for (const ScenarioRun* run : {&one, &both}) {
    for (const double share : sharesAt(*run, 90)) {
      EXPECT_GT(share, 0.7) << run->scenario << ": the poster does not hide the ball";
    }
  }
}

TEST(ScenarioSurfaces, SameSeedSameBits) {
  for (const char* name : {"S11-held", "S12-six-spots", "S13-one-camera"}) {
    expectSameBits(name, 100);
  }
}

} // namespace
} // namespace dewpoint::tests
