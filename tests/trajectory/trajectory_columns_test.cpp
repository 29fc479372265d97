// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/trajectory_columns.h"
#include "core/trajectory/trajectory_reader.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

TrajectorySample fullSample(std::int64_t frame, const std::string& target, double x) {
  TrajectorySample sample;
  sample.frame = frame;
  sample.time = 0.5 * static_cast<double>(frame);
  sample.target = target;
  sample.position = {x, x + 1.0, x + 2.0};
  sample.covariance = Eigen::Vector3d(1.0, 2.0, 3.0).asDiagonal();
  sample.covariance(0, 1) = sample.covariance(1, 0) = 0.25;
  sample.existenceProbability = 0.75;
  sample.cameraCount = 2;
  return sample;
}

TEST(TrajectoryColumns, HasARowForEachFrame) {
  Trajectory trajectory;
  trajectory.samples = {fullSample(2, "a", 1.0), fullSample(3, "a", 2.0), fullSample(3, "b", 5.0),
                        fullSample(5, "b", 6.0)};
  trajectory.samples[1].isValid = false;
  trajectory.samples[3].isAmbiguous = true;
  trajectory.samples[3].bestParticle = Eigen::Vector3d(7.0, 8.0, 9.0);
  const TrajectoryColumns columns = columnsOf(trajectory);
  EXPECT_EQ(columns.frames, (std::vector<std::int64_t>{2, 3, 5}));
  EXPECT_EQ(columns.times, (std::vector<double>{1.0, 1.5, 2.5}));
  ASSERT_EQ(columns.targets.size(), 2U);
  const TargetColumns& a = columns.targets[0];
  const TargetColumns& b = columns.targets[1];
  EXPECT_EQ(a.target, "a");
  EXPECT_EQ((std::vector<double>(a.positions.begin(), a.positions.begin() + 6)),
            (std::vector<double>{1.0, 2.0, 3.0, 2.0, 3.0, 4.0}));
  EXPECT_TRUE(std::isnan(a.positions[6])); // frame 5
  EXPECT_TRUE(std::isnan(b.positions[0])); // frame 2
  EXPECT_EQ((std::vector<double>(b.covariances.begin() + 9, b.covariances.begin() + 18)),
            (std::vector<double>{1.0, 0.25, 0.0, 0.25, 2.0, 0.0, 0.0, 0.0, 3.0}));
  EXPECT_EQ(a.validFlags, (std::vector<std::uint8_t>{1, 0, 0}));
  EXPECT_EQ(b.ambiguousFlags, (std::vector<std::uint8_t>{0, 0, 1}));
  EXPECT_EQ(b.cameraCounts, (std::vector<std::int32_t>{0, 2, 2}));
  EXPECT_EQ(b.existenceProbabilities[1], 0.75);
  EXPECT_TRUE(std::isnan(b.bestParticles[3]));
  EXPECT_EQ(b.bestParticles[8], 9.0);
}

TEST(TrajectoryColumns, GoesByTimesWhereThereAreNoFrames) {
  Trajectory trajectory;
  trajectory.samples = {fullSample(kNoFrame, "a", 1.0), fullSample(kNoFrame, "a", 2.0)};
  trajectory.samples[0].time = 0.25;
  trajectory.samples[1].time = 0.5;
  const TrajectoryColumns columns = columnsOf(trajectory);
  EXPECT_EQ(columns.times, (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(columns.frames, (std::vector<std::int64_t>{kNoFrame, kNoFrame}));
  EXPECT_EQ(columns.targets.at(0).positions[3], 2.0);
}

TEST(TrajectoryColumns, OfNothingIsEmpty) {
  const TrajectoryColumns columns = columnsOf({});
  EXPECT_TRUE(columns.frames.empty() && columns.times.empty() && columns.targets.empty());
}

} // namespace
} // namespace dewpoint::tests
