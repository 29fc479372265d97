// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_classifier.h"
#include "core/color/match_image.h"
#include "core/experiment/clips/calibrated_clip.h"
#include "core/experiment/suite/suite_runner.h"
#include "tests/experiment/clips/small_clip.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

const auto kNeverStop = [] { return false; };

TEST(CalibratedClip, BecomesARunWithTheTruthOfItsInstants) {
  const test::TemporaryFolder folder;
  const auto run = makeClipRun(test::makeSmallClip(folder), 7);
  ASSERT_TRUE(run) << errorSentence(run.error());
  EXPECT_EQ(run->grade, Grade::Real);
  EXPECT_EQ(run->frameCount, 10); // frames 2 to 11
  EXPECT_EQ(run->measuredFrames, (std::vector<std::int64_t>{0, 2, 4, 6, 8}));
  ASSERT_EQ(run->truth.samples.size(), 5U);
  EXPECT_EQ(run->truth.samples[1].target, "disk");
  EXPECT_NEAR(run->truth.samples[1].time, 2.0 / 30.0, 1e-12) << "from the first instant on";
  ASSERT_EQ(run->markedCenters.size(), 10U) << "the projections into both cameras";
  // x = -0.03 m, 1 m away: 200 * (-0.03 + 0.1) + 80 = 94, and 40 pixels less in the other camera.
  EXPECT_NEAR(run->markedCenters[0].pixel.x(), 94.0, 1e-9);
  EXPECT_NEAR(run->markedCenters[0].pixel.y(), 64.0, 1e-9);
  EXPECT_NEAR(run->markedCenters[5].pixel.x(), 54.0, 1e-9);
  const auto frames = run->frames(3);
  EXPECT_EQ(frames->index, 3);
  EXPECT_EQ(frames->time, timeStamp(5.0 / 30.0 - 2.0 / 30.0));
  ASSERT_EQ(frames->frames.size(), 2U);
  // Frame 5 of the images: x = 0, 100 px in the first camera.
  EXPECT_EQ(frames->frames[0]->image.at<cv::Vec3b>(64, 100), cv::Vec3b(145, 85, 245));
}

TEST(CalibratedClip, LearnsTheColorOfTheClick) {
  const test::TemporaryFolder folder;
  const auto run = makeClipRun(test::makeSmallClip(folder), 1);
  ASSERT_TRUE(run) << errorSentence(run.error());
  ASSERT_EQ(run->targets.size(), 1U);
  ASSERT_EQ(run->targets[0].samples.size(), 2U); // what was clicked, and what was found
  EXPECT_TRUE(!run->targets[0].samples[0].isFoundByGeometry &&
              run->targets[0].samples[1].isFoundByGeometry);
  const ColorClassifier classifier(run->targets[0].color);
  const cv::Mat mask = matchImage(run->frames(0)->frames[1]->image, classifier);
  EXPECT_NE(mask.at<std::uint8_t>(64, 54), 0) << "the disk in the other camera";
  EXPECT_EQ(mask.at<std::uint8_t>(10, 10), 0) << "the gray around it";
}

TEST(CalibratedClip, StartsAroundTheFirstPositionAsTheSeedDraws) {
  const test::TemporaryFolder folder;
  const auto clip = test::makeSmallClip(folder);
  const auto one = makeClipRun(clip, 1);
  const auto again = makeClipRun(clip, 1);
  const auto other = makeClipRun(clip, 2);
  ASSERT_TRUE(one && again && other);
  EXPECT_EQ(one->startCenter, again->startCenter);
  EXPECT_NE(one->startCenter, other->startCenter);
  const Eigen::Vector3d first = test::smallClipPosition(2);
  EXPECT_LE((one->startCenter - first).cwiseAbs().maxCoeff(), 0.5 * kClipStartHalfSize);
  EXPECT_TRUE(one->startHalfSize.isApprox(Eigen::Vector3d::Constant(kClipStartHalfSize)));
}

TEST(CalibratedClip, RefusesFilesThatDoNotFit) {
  const test::TemporaryFolder folder;
  auto clip = test::makeSmallClip(folder);
  clip.rig[1].intrinsics.width = 320;
  EXPECT_EQ(makeClipRun(clip, 1).error().code, ErrorCode::Mismatch);
  clip = test::makeSmallClip(folder);
  clip.instants = simultaneousInstants(0, test::kSmallClipFrames + 1, 2, 30.0);
  EXPECT_EQ(makeClipRun(clip, 1).error().code, ErrorCode::EndedEarly);
  clip.cameraPaths[0] = folder / "none.mp4";
  EXPECT_EQ(makeClipRun(clip, 1).error().code, ErrorCode::FileMissing);
}

TEST(CalibratedClip, FindsWhereMarksMeet) {
  const CameraRig rig = test::smallRig();
  // The projections of (0, 0.02, 1): 100 and 60 px, as in the comment of smallClipPosition().
  const std::vector<MarkedCenter> marks{
      {4, 1, 0, {100.0, 64.0}}, {4, 1, 1, {60.0, 64.0}}, {5, 1, 0, {0.0, 0.0}}};
  const auto position = triangulateMarks(rig, marks, 4, 1);
  ASSERT_TRUE(position.has_value());
  EXPECT_LT((*position - Eigen::Vector3d(0.0, 0.02, 1.0)).norm(), 1e-9);
  EXPECT_FALSE(triangulateMarks(rig, marks, 5, 1).has_value()) << "one mark alone";
  EXPECT_FALSE(triangulateMarks(rig, marks, 4, 0).has_value()) << "another target";
}

/// A clip as a scenario of the suite.
ScenarioDeclaration scenarioWith(const CalibratedClip& clip) {
  ScenarioDeclaration scenario;
  scenario.name = clip.name;
  scenario.family = "R1";
  scenario.seedCount = 1;
  scenario.isRecorded = true;
  scenario.make = [clip](std::uint64_t seed, Grade) { return makeClipRun(clip, seed); };
  return scenario;
}

SuiteRow rowOfTriangulation(const CalibratedClip& clip) {
  const std::vector<ScenarioDeclaration> catalog{scenarioWith(clip)};
  SuiteRequest request;
  request.scenarios = *selectScenarios(catalog, {});
  request.methods = {"triangulation"};
  request.grades = {Grade::Ideal, Grade::Room, Grade::Real};
  const auto jobs = planSuite(request, {});
  EXPECT_EQ(jobs.size(), 1U) << "a clip is of one grade";
  SuiteRow row;
  const auto keep = [&](const SuiteResult& result) -> Status {
    row = result.row;
    EXPECT_TRUE(parseTrace(traceText(result.trace)).has_value());
    return {};
  };
  const auto done = runSuite(jobs, 1, keep, kNeverStop);
  EXPECT_TRUE(done) << errorSentence(done.error());
  return row;
}

TEST(CalibratedClip, IsMeasuredWhereItHasATruth) {
  const test::TemporaryFolder folder;
  const SuiteRow row = rowOfTriangulation(test::makeSmallClip(folder));
  EXPECT_EQ(row.key.grade, Grade::Real);
  EXPECT_EQ(row.frameCount, 5.0) << "not the ten that were tracked";
  // The disks are whole pixels around exact projections: nothing is left but rounding.
  ASSERT_TRUE(row.rmseMm.has_value());
  EXPECT_LT(*row.rmseMm, 1.0);
  EXPECT_EQ(row.framesToConverge, 0.0);
  EXPECT_EQ(row.lostPercent, 0.0);
  EXPECT_EQ(row.falseAlarmPercent, 0.0) << "frames without a truth are no false alarms";
  ASSERT_TRUE(row.rmsePx.has_value());
  EXPECT_LT(*row.rmsePx, 0.2);
}

TEST(CalibratedClip, IsMeasuredInPixelsWithoutPositions) {
  const test::TemporaryFolder folder;
  CalibratedClip clip = test::makeSmallClip(folder);
  for (std::int64_t instant = 0; instant < 10; ++instant) { // marked 3 px beside the disk
    const double x = 94.0 + 2.0 * static_cast<double>(instant);
    clip.markedCenters.push_back({instant, 0, 0, {x, 67.0}});
  }
  clip.positions.clear();
  clip.startPositions = {test::smallClipPosition(2)};
  const SuiteRow row = rowOfTriangulation(clip);
  EXPECT_EQ(row.frameCount, 10.0);
  EXPECT_FALSE(row.rmseMm.has_value());
  ASSERT_TRUE(row.rmsePx.has_value());
  EXPECT_NEAR(*row.rmsePx, 3.0, 0.2);
  EXPECT_EQ(row.lostPercent, 0.0) << "3 px is within the gate of 10";
}

} // namespace
} // namespace dewpoint::tests
