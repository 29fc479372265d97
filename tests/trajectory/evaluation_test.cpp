// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/evaluation.h"
#include "core/trajectory/evaluation_text.h"
#include "core/trajectory/trajectory_reader.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

TrajectorySample at(std::int64_t frame, const Eigen::Vector3d& position,
                    const std::string& target = "ball") {
  TrajectorySample sample;
  sample.frame = frame;
  sample.time = static_cast<double>(frame) / 10.0;
  sample.target = target;
  sample.position = position;
  return sample;
}

/// Truth: a ball that rests at (1, 2, 3) for `count` frames.
Trajectory restingTruth(std::int64_t count) {
  Trajectory truth;
  for (std::int64_t frame = 0; frame < count; ++frame)
    truth.samples.push_back(at(frame, {1, 2, 3}));
  return truth;
}

/// Estimates off by `errors` in x.
Trajectory estimateWith(const std::vector<double>& errors) {
  Trajectory estimate;
  for (std::size_t i = 0; i < errors.size(); ++i)
    estimate.samples.push_back(at(static_cast<std::int64_t>(i), {1 + errors[i], 2, 3}));
  return estimate;
}

TEST(Evaluation, HandWorkedStatistics) {
  // Two frames outside the gate of 30 mm, then five within: 0, 10, 10, 20, 20 mm.
  const auto result =
      evaluate(estimateWith({0.3, 0.1, 0.0, 0.01, 0.01, 0.02, 0.02}), restingTruth(7));
  ASSERT_TRUE(result);
  ASSERT_EQ(result->size(), 1u);
  const Evaluation& e = result->front();
  EXPECT_EQ(e.target, "ball");
  EXPECT_EQ(e.comparedFrameCount, 7);
  EXPECT_EQ(e.convergenceFrameCount, 2);
  EXPECT_EQ(e.lostFrameCount, 0);
  EXPECT_EQ(e.missingFrameCount, 0);
  // (0 + 1 + 1 + 4 + 4) cm² / 5 = 2 cm²
  EXPECT_NEAR(e.rmse, std::sqrt(2e-4), 1e-12);
  // + (30² + 10²) cm² : 1010 cm² / 7
  EXPECT_NEAR(e.rmseOfAllFrames, std::sqrt(0.101 / 7.0), 1e-12);
  EXPECT_NEAR(e.medianError, 0.01, 1e-12);
  EXPECT_NEAR(e.p95, 0.02, 1e-12); // place 3.8 of 0..4 lies between 20 and 20 mm
  EXPECT_NEAR(e.maxError, 0.02, 1e-12);
  EXPECT_NEAR(e.bias.x(), 0.012, 1e-12); // 60 mm / 5
  EXPECT_NEAR(e.bias.y(), 0.0, 1e-12);
}

TEST(Evaluation, SplitsErrorsAlongAndAcrossTheOpticalAxis) {
  Trajectory estimate = estimateWith({0, 0, 0, 0, 0});
  // Errors: x always 3 mm; z alternates +4, -4, +4, -4, 0 mm, so that it cancels.
  const double dz[] = {0.004, -0.004, 0.004, -0.004, 0.0};
  for (std::size_t i = 0; i < 5; ++i)
    estimate.samples[i].position += Eigen::Vector3d(0.003, 0, dz[i]);
  // The second axis is not of unit length on purpose.
  estimate.header.cameras = {{"down", {1, 2, 9}, {0, 0, -1}}, {"side", {9, 2, 3}, {-2, 0, 0}}};
  const auto result = evaluate(estimate, restingTruth(5));
  ASSERT_TRUE(result);
  const auto& cameras = result->front().cameraBiases;
  ASSERT_EQ(cameras.size(), 2u);
  const double zRms = std::sqrt(4 * 16e-6 / 5); // four of five are 4 mm
  EXPECT_NEAR(cameras[0].alongAxisBias, 0.0, 1e-12);
  EXPECT_NEAR(cameras[0].acrossAxisBias, 0.003, 1e-12);
  EXPECT_NEAR(cameras[0].alongAxisRms, zRms, 1e-12);
  EXPECT_NEAR(cameras[0].acrossAxisRms, 0.003, 1e-12);
  EXPECT_NEAR(cameras[1].alongAxisBias, -0.003, 1e-12); // nearer to the camera than the truth
  EXPECT_NEAR(cameras[1].acrossAxisBias, 0.0, 1e-12);
  EXPECT_NEAR(cameras[1].alongAxisRms, 0.003, 1e-12);
  EXPECT_NEAR(cameras[1].acrossAxisRms, zRms, 1e-12);
}

TEST(Evaluation, CountsLostAndMissingFramesAfterConvergence) {
  Trajectory estimate = estimateWith({0, 0, 0, 0, 0, 0.5, 0, 0, 0, 0});
  estimate.samples[6].isValid = false;
  estimate.samples[7].position.x() = std::numeric_limits<double>::quiet_NaN();
  estimate.samples.erase(estimate.samples.begin() + 8);
  const auto result = evaluate(estimate, restingTruth(12)); // frames 10, 11 were not run
  ASSERT_TRUE(result);
  EXPECT_EQ(result->front().convergenceFrameCount, 0);
  EXPECT_EQ(result->front().lostFrameCount, 4); // 5 far, 6 not valid, 7 not a number, 8 absent
  EXPECT_EQ(result->front().missingFrameCount, 2);
  EXPECT_EQ(result->front().comparedFrameCount, 8);
}

TEST(Evaluation, NeverConvergedUsesAllFrames) {
  const auto result = evaluate(estimateWith({0, 0, 0, 0, 0.1, 0, 0, 0, 0}), restingTruth(9));
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->front().convergenceFrameCount);
  EXPECT_EQ(result->front().lostFrameCount, 0);
  EXPECT_NEAR(result->front().rmse, 0.1 / 3.0, 1e-12); // sqrt(0.01 / 9)
  EXPECT_EQ(result->front().rmse, result->front().rmseOfAllFrames);
  // A wider gate takes the outlier in.
  EXPECT_EQ(evaluate(estimateWith({0, 0, 0, 0, 0.1}), restingTruth(5), 0.2)
                ->front()
                .convergenceFrameCount,
            0);
}

TEST(Evaluation, MatchesByTimeWithinHalfAFrame) {
  Trajectory truth = restingTruth(6);
  for (TrajectorySample& sample : truth.samples)
    sample.frame = kNoFrame;
  Trajectory estimate = estimateWith({0.001, 0.001, 0.001, 0.001, 0.001, 0.001});
  for (TrajectorySample& sample : estimate.samples) {
    sample.frame += 100; // must not matter
    sample.time += 0.04; // frames are 0.1 s apart
  }
  auto result = evaluate(estimate, truth);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_EQ(result->front().comparedFrameCount, 6);
  estimate.samples[3].time += 0.03; // 0.37: nearer to frame 4 (0.4) than to frame 3 (0.3)
  result = evaluate(estimate, truth);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->front().missingFrameCount, 1);
}

TEST(Evaluation, FindsTheTruthOfATarget) {
  Trajectory truth = restingTruth(5);
  Trajectory estimate = estimateWith({0, 0, 0, 0, 0});
  for (TrajectorySample& sample : truth.samples)
    sample.target = "";
  EXPECT_TRUE(evaluate(estimate, truth)); // the only one
  for (std::int64_t frame = 0; frame < 5; ++frame)
    truth.samples.push_back(at(frame, {1, 2, 3.01}, "ball"));
  EXPECT_NEAR(evaluate(estimate, truth)->front().rmse, 0.01, 1e-12); // the one of its name
  for (TrajectorySample& sample : estimate.samples)
    sample.target = "other";
  EXPECT_EQ(evaluate(estimate, truth).error().code, ErrorCode::NotFound);
  EXPECT_EQ(evaluate(estimate, {}).error().code, ErrorCode::NotFound);
  EXPECT_EQ(evaluate(estimate, truth, 0.0).error().code, ErrorCode::BadValue);
}

TEST(Evaluation, NoCommonFrameIsAMismatch) {
  Trajectory estimate = estimateWith({0, 0});
  for (TrajectorySample& sample : estimate.samples)
    sample.frame += 100;
  EXPECT_EQ(evaluate(estimate, restingTruth(5)).error().code, ErrorCode::Mismatch);
  for (TrajectorySample& sample : estimate.samples) {
    sample.frame = kNoFrame;
    sample.time = std::numeric_limits<double>::quiet_NaN();
  }
  EXPECT_EQ(evaluate(estimate, restingTruth(5)).error().code, ErrorCode::Mismatch);
}

TEST(Evaluation, CountsTruthInsideTheStatedEllipsoid) {
  // With a variance of 1e-4 m² along x, 10 mm are one sigma; the ellipsoid of 95 % ends at
  // sqrt(7.81) = 2.8 sigma, 28 mm. The gate is wider, so that all five frames count.
  Trajectory estimate = estimateWith({0.0, 0.027, 0.029, 0.01, 0.01});
  for (TrajectorySample& sample : estimate.samples)
    sample.covariance = Eigen::Vector3d(1e-4, 1e-6, 1e-6).asDiagonal();
  estimate.samples.back().covariance.setZero(); // no ellipsoid: outside
  const auto result = evaluate(estimate, restingTruth(5), 0.1);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->front().fractionInside95Ellipsoid, 3.0 / 5.0, 1e-12);
}

TEST(Evaluation, TextIsInMillimetersAndJsonInMeters) {
  Trajectory estimate = estimateWith({0.01, 0.01, 0.01, 0.01, 0.01});
  estimate.header.cameras = {{"side", {9, 2, 3}, {-1, 0, 0}}};
  const auto result = evaluate(estimate, restingTruth(5));
  ASSERT_TRUE(result);
  const std::string text = evaluationText(*result);
  EXPECT_NE(text.find("RMSE 10.0 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("along axis -10.0 mm"), std::string::npos) << text;
  EXPECT_NE(text.find("after 0 frames"), std::string::npos) << text;
  const nlohmann::json json = evaluationJson(*result);
  EXPECT_EQ(json["unit"], "m");
  EXPECT_NEAR(json["targets"][0]["rmse"].get<double>(), 0.01, 1e-12);
  EXPECT_NEAR(json["targets"][0]["cameras"][0]["along_bias"].get<double>(), -0.01, 1e-12);
  EXPECT_EQ(json["targets"][0]["frames_to_converge"], 0);
}

} // namespace
} // namespace dewpoint::tests
