// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the suite that measure real clips: some frames only, in pixels, boxes of one camera.
#include "core/base/text_file.h"
#include "core/experiment/suite/image_clip_run.h"
#include "core/experiment/suite/measured_part.h"
#include "core/experiment/suite/pixel_recorder.h"
#include "core/experiment/suite/suite_report.h"
#include "core/experiment/suite/suite_runner.h"
#include "core/experiment/suite/suite_tables.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tests {
namespace {

TrajectorySample sampleAt(std::int64_t frame, double x) {
  TrajectorySample sample;
  sample.frame = frame;
  sample.target = "ball";
  sample.position = {x, 0.0, 0.0};
  return sample;
}

TEST(MeasuredPart, RenumbersTheMeasuredFrames) {
  ScenarioRun run;
  run.frameCount = 40;
  run.framesPerSecond = 30.0;
  run.measuredFrames = {3, 12, 21, 30};
  run.truth.samples = {sampleAt(3, 0.1), sampleAt(21, 0.2), sampleAt(22, 0.9), sampleAt(30, 0.3)};
  run.events.push_back({ScenarioEvent::Kind::Jump, 21, -1});
  EXPECT_TRUE(isMeasured(run, 12));
  EXPECT_FALSE(isMeasured(run, 13));
  const ScenarioRun part = measuredPart(run);
  EXPECT_EQ(part.frameCount, 4);
  EXPECT_DOUBLE_EQ(part.framesPerSecond, 3.0); // 4 of 40 frames
  EXPECT_TRUE(part.events.empty());
  ASSERT_EQ(part.truth.samples.size(), 3U) << "frame 22 is not measured";
  EXPECT_EQ(part.truth.samples[1].frame, 2);
  EXPECT_EQ(part.truth.samples[2].frame, 3);
  EXPECT_EQ(part.truth.samples[1].position.x(), 0.2);
  EXPECT_TRUE(part.extents.empty()) << "the run tells none";
}

TEST(MeasuredPart, KeepsTheExtentsOfItsSamples) {
  ScenarioRun run;
  run.frameCount = 40;
  run.measuredFrames = {3, 21};
  run.equalCandidateCount = 2;
  run.truth.samples = {sampleAt(3, 0.1), sampleAt(20, 0.9), sampleAt(21, 0.2)};
  run.extents.resize(3);
  run.extents[1].radius = 0.9;
  run.extents[2].radius = 0.2;
  const ScenarioRun part = measuredPart(run);
  ASSERT_EQ(part.extents.size(), 2U);
  EXPECT_EQ(part.extents[1].radius, 0.2);
  EXPECT_EQ(part.equalCandidateCount, 2);
}

TEST(MeasuredPart, KnowsWhetherFramesLieBetween) {
  ScenarioRun run;
  EXPECT_TRUE(measuresSuccessiveFrames(run)) << "all frames";
  run.measuredFrames = {5};
  EXPECT_TRUE(measuresSuccessiveFrames(run));
  run.measuredFrames = {5, 6, 7};
  EXPECT_TRUE(measuresSuccessiveFrames(run));
  run.measuredFrames = {5, 6, 8};
  EXPECT_FALSE(measuresSuccessiveFrames(run));
}

TEST(MeasuredPart, IsTheRunItselfWhereAllFramesAreMeasured) {
  ScenarioRun run;
  run.frameCount = 2;
  run.truth.samples = {sampleAt(0, 0.1), sampleAt(1, 0.2)};
  run.events.push_back({ScenarioEvent::Kind::Jump, 1, -1});
  EXPECT_TRUE(isMeasured(run, 1));
  const ScenarioRun part = measuredPart(run);
  EXPECT_EQ(part.frameCount, 2);
  EXPECT_EQ(part.events.size(), 1U);
  EXPECT_EQ(part.truth.samples.size(), 2U);
}

/// One camera at the world's origin, 100 px of focal length, that looks along z; frames 0 to 9 have
/// a mark at its center, (50, 40).
ScenarioRun markedRun() {
  ScenarioRun run;
  run.scenario = "R1-marks";
  run.grade = Grade::Real;
  run.rig.resize(1);
  run.rig[0].intrinsics = {100, 80, 100.0, 100.0, 50.0, 40.0};
  run.targets.resize(1);
  run.markGatePx = 10.0;
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    run.markedCenters.push_back({frame, 0, 0, {50.0, 40.0}});
  }
  return run;
}

/// An estimate 1 m before the camera that is seen so many pixels beside the mark.
SphereEstimate estimateBeside(double pixels, bool valid, double existence) {
  SphereEstimate estimate;
  estimate.mean = {0.01 * pixels, 0.0, 1.0}; // 100 px per meter
  estimate.isValid = valid;
  estimate.existenceProbability = existence;
  return estimate;
}

TEST(PixelRecorder, MeasuresInTheImages) {
  const ScenarioRun run = markedRun();
  PixelRecorder recorder(run);
  recorder.add(0, {estimateBeside(40.0, true, 0.9)}); // not on the target yet
  for (std::int64_t frame = 1; frame < 8; ++frame) {
    recorder.add(frame, {estimateBeside(3.0, true, 0.9)});
  }
  recorder.add(8, {estimateBeside(25.0, true, 0.9)});   // beside it
  recorder.add(9, {estimateBeside(1.0, false, 0.1)});   // not declared
  recorder.add(10, {estimateBeside(500.0, true, 0.9)}); // no mark: not measured
  const SuiteResult result = recorder.result({"R1-marks", Grade::Real, "dewpoint", 1}, 12.0);
  EXPECT_EQ(result.row.framesToConverge, 1.0);
  // From frame 1 on, declared: seven times 3 px and once 25 px.
  EXPECT_NEAR(*result.row.rmsePx, std::sqrt((7.0 * 9.0 + 625.0) / 8.0), 1e-9);
  EXPECT_NEAR(*result.row.lostPercent, 100.0 * 2.0 / 9.0, 1e-9); // frames 8 and 9 of 1 to 9
  // P = 0.9 in nine frames, seven of which are on the mark; P = 0.1 in one, which is: the mean gap
  // is 0.9 * (0.9 - 7/9) + 0.1 * (1 - 0.1).
  EXPECT_NEAR(*result.row.existenceEce, 0.9 * (0.9 - 7.0 / 9.0) + 0.1 * 0.9, 1e-9);
  EXPECT_FALSE(result.row.rmseMm.has_value());
  EXPECT_EQ(result.row.frameCount, 10.0);
  EXPECT_EQ(result.row.usPerFrame, 12.0);
  EXPECT_TRUE(parseTrace(traceText(result.trace)).has_value());
  EXPECT_TRUE(parseRow(rowText(result.row)).has_value());
}

TEST(PixelRecorder, TakesTheWorstOfTheCameras) {
  ScenarioRun run = markedRun();
  run.rig.push_back(run.rig[0]);
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    run.markedCenters.push_back({frame, 0, 1, {62.0, 40.0}}); // 12 px from a mean at the center
  }
  PixelRecorder recorder(run);
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    recorder.add(frame, {estimateBeside(0.0, true, 1.0)});
  }
  const SuiteResult result = recorder.result({"R1-marks", Grade::Real, "dewpoint", 1}, 0.0);
  EXPECT_TRUE(std::isinf(*result.row.framesToConverge)) << "one camera's 12 px are beyond the gate";
  EXPECT_EQ(result.row.lostPercent, 100.0);
  EXPECT_NEAR(*result.row.rmsePx, std::sqrt(144.0 / 2.0), 1e-9) << "0 and 12 px";
}

TEST(PixelRecorder, SaysNothingWithoutMarks) {
  ScenarioRun run = markedRun();
  run.markedCenters.clear();
  PixelRecorder recorder(run);
  recorder.add(0, {estimateBeside(0.0, true, 1.0)});
  EXPECT_FALSE(recorder.rmsePx().has_value());
}

/// A red disk on gray that moves by 2 px from image to image.
BoxClip diskClip() {
  BoxClip clip;
  clip.name = "disk";
  clip.hitRadiusPx = 8.0;
  const auto centerOf = [](std::int64_t frame) { return cv::Point(30 + 2 * int(frame), 40); };
  for (std::int64_t frame = 0; frame < 8; ++frame) {
    clip.truth.push_back(ImageBox::around(
        Eigen::Vector2d(centerOf(frame).x + 0.5, centerOf(frame).y + 0.5), 17.0, 17.0));
  }
  clip.image = [centerOf](std::int64_t frame) -> Result<cv::Mat> {
    cv::Mat image(80, 120, CV_8UC3, cv::Scalar::all(90));
    cv::circle(image, centerOf(frame), 8, {40, 40, 220}, cv::FILLED);
    return image;
  };
  return clip;
}

const auto kGoOnWithIt = [] { return false; };

TEST(ImageClipRun, FollowsAndMeasures) {
  const BoxClip clip = diskClip();
  const auto images = imagesOf(clip);
  ASSERT_TRUE(images);
  const RunKey key{"R2-disk", Grade::Real, "histogram", 1};
  const auto result = followClip(clip, *images, key, kGoOnWithIt);
  ASSERT_TRUE(result) << errorSentence(result.error());
  ASSERT_TRUE(result->has_value());
  const SuiteRow& row = (*result)->row;
  EXPECT_EQ(row.key, key);
  EXPECT_EQ(row.frameCount, 7.0) << "the first box is given";
  EXPECT_LT(*row.rmsePx, 8.0) << "within the disk";
  EXPECT_EQ(row.lostPercent, 0.0);
  EXPECT_EQ(row.framesToConverge, 0.0);
  EXPECT_GT(*row.boxSuccess, 0.3);
  EXPECT_FALSE(row.rmseMm.has_value());
  const auto trace = parseTrace(traceText((*result)->trace));
  ASSERT_TRUE(trace.has_value());
  EXPECT_EQ(trace->errorsMm.front().size(), 7U);
}

TEST(ImageClipRun, StopsAndRefuses) {
  const BoxClip clip = diskClip();
  const auto images = imagesOf(clip);
  ASSERT_TRUE(images);
  const auto stopped =
      followClip(clip, *images, {"R2-disk", Grade::Real, "camshift-box", 1}, [] { return true; });
  ASSERT_TRUE(stopped);
  EXPECT_FALSE(stopped->has_value());
  EXPECT_EQ(
      followClip(clip, *images, {"R2-disk", Grade::Real, "dewpoint", 1}, kGoOnWithIt).error().code,
      ErrorCode::NotFound);
}

TEST(SuiteRunner, RunsRealClipsInTheirGradeByTheMethodsThatCan) {
  std::vector<ScenarioDeclaration> catalog(3);
  catalog[0].name = "S0-slow";
  catalog[1].name = "R1-hand";
  catalog[1].isRecorded = true;
  catalog[2].name = "R2-disk";
  catalog[2].isRecorded = true;
  catalog[2].clip = [] { return Result<BoxClip>(diskClip()); };
  SuiteRequest request;
  request.scenarios = *selectScenarios(catalog, {});
  request.grades = {Grade::Ideal, Grade::Real};
  request.methods =
      *selectMethods({"triangulation", "camshift", "histogram", "camshift-box"}, allSuiteMethods());
  request.seedCount = 1;
  const auto jobs = planSuite(request, {});
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_EQ(jobs[0].grade, Grade::Ideal);
  EXPECT_EQ(jobs[0].methods, (std::vector<std::string>{"triangulation", "camshift"}));
  EXPECT_EQ(jobs[1].grade, Grade::Real);
  EXPECT_EQ(jobs[1].methods, (std::vector<std::string>{"triangulation", "camshift"}));
  EXPECT_EQ(jobs[2].grade, Grade::Real);
  EXPECT_EQ(jobs[2].methods, (std::vector<std::string>{"histogram", "camshift-box"}));

  std::vector<std::string> done;
  const auto sink = [&](const SuiteResult& result) -> Status {
    done.push_back(rowText(result.row));
    return {};
  };
  ASSERT_TRUE(runSuite({jobs[2]}, 1, sink, kGoOnWithIt));
  ASSERT_EQ(done.size(), 2U);
  EXPECT_TRUE(done[0].starts_with("R2-disk,real,histogram,")) << done[0];
  EXPECT_TRUE(done[1].starts_with("R2-disk,real,camshift-box,")) << done[1];
}

TEST(SuiteReport, ShowsClipsInPixelsAndNamesThoseThatAreMissing) {
  std::vector<ScenarioDeclaration> catalog(1);
  catalog[0].name = "R2-disk";
  catalog[0].family = "R2";
  catalog[0].description = "A disk. Tuned on: no.";
  catalog[0].isRecorded = true;
  catalog[0].clip = [] { return Result<BoxClip>(diskClip()); };
  SuiteRequest request;
  request.scenarios = *selectScenarios(catalog, {});
  request.grades = {Grade::Real};
  request.methods = *selectMethods({"histogram"}, imageClipMethods());
  request.seedCount = 1;
  SuiteResults results;
  const auto sink = [&](const SuiteResult& result) -> Status {
    results[result.row.key] = result;
    return {};
  };
  ASSERT_TRUE(runSuite(planSuite(request, {}), 1, sink, kGoOnWithIt));
  ASSERT_EQ(results.size(), 1U);
  const test::TemporaryFolder folder;
  const auto written = writeSuiteReport(folder / "", results, reportOrder(results, catalog),
                                        catalog, {"R1-hand is skipped: for a test."});
  ASSERT_TRUE(written) << errorSentence(written.error());
  const std::string page = *readTextFile(folder / "report.html");
  const auto has = [&](const char* text) { return page.find(text) != std::string::npos; };
  EXPECT_TRUE(has("R1-hand is skipped: for a test."));
  EXPECT_TRUE(has("Real clips of one camera"));
  EXPECT_TRUE(has("Tuned on: no."));
  const std::string inPixels = formatValue(*results.begin()->second.row.rmsePx) + " px</td>";
  EXPECT_TRUE(has(inPixels.c_str())) << "the overview is in pixels where there are no lengths";
  EXPECT_TRUE(has("success<br>of boxes"));
  EXPECT_FALSE(has("Error over time: median")) << "no plot of millimeters";
  EXPECT_FALSE(has("Does P(exists)")) << "no P(exists)";
  EXPECT_NE(readTextFile(folder / "report.json")->find("R1-hand is skipped"), std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
