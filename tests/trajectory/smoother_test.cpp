// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/trajectory/smoother.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace dewpoint::tests {
namespace {

PositionMeasurement seenAt(const Eigen::Vector3d& place, double sigma) {
  return {place, sigma * sigma * Eigen::Matrix3d::Identity()};
}

TEST(SmoothPath, IsTheStraightLineThroughThreePlaces) {
  // Almost no acceleration: the line of least squares. Through 0, 3, 0 cm at 0, 1, 2 s it is 1 cm;
  // its variance is a third of a place's in the middle, and 1/3 + 1/2 at the ends (x² / sum of x²).
  constexpr double kSigma = 0.001;
  std::vector<PathPoint> path;
  for (const double x : {0.0, 0.03, 0.0}) {
    path.push_back({static_cast<double>(path.size()), seenAt({x, 0, 0}, kSigma)});
  }
  const auto smooth = smoothPath(path, {2, 1e-14, 1.0});
  const double variances[] = {5.0 / 6.0, 1.0 / 3.0, 5.0 / 6.0};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(smooth[k].position.x(), 0.01, 1e-8);
    EXPECT_NEAR(smooth[k].covariance(0, 0) / (kSigma * kSigma), variances[k], 1e-6);
    EXPECT_NEAR(smooth[k].covariance(0, 1), 0.0, 1e-15);
  }
}

/// A path of six instants at uneven times, seen in four of them with different ellipsoids.
std::vector<PathPoint> unevenPath() {
  std::vector<PathPoint> path;
  const double times[] = {0.0, 0.1, 0.25, 0.3, 0.7, 0.8};
  for (int k = 0; k < 6; ++k) {
    path.push_back({times[k], std::nullopt});
    if (k != 2 && k != 3) {
      PositionMeasurement seen = seenAt({0.1 * k, std::sin(k), 0.02 * k * k}, 0.01 * (k + 1));
      seen.covariance(0, 1) = seen.covariance(1, 0) = 0.5e-4 * (k + 1);
      path.back().measurement = seen;
    }
  }
  return path;
}

/// The same by one dense least-squares problem over all states at once: prior, motion and looks are
/// its blocks. Written from the model, not from the recursion.
std::vector<PathEstimate> atOnce(const std::vector<PathPoint>& path, double strength) {
  const auto count = static_cast<Eigen::Index>(path.size());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(6 * count, 6 * count);
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(6 * count);
  const Eigen::Vector3d first = path[0].measurement->position;
  information.topLeftCorner(6, 6).diagonal().setConstant(1.0 / 100.0); // 10 m, 10 m/s
  vector.head(3) = first / 100.0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const PathPoint& point = path[static_cast<std::size_t>(k)];
    if (point.measurement) {
      const Eigen::Matrix3d inverse = point.measurement->covariance.inverse();
      information.block<3, 3>(6 * k, 6 * k) += inverse;
      vector.segment<3>(6 * k) += inverse * point.measurement->position;
    }
    if (k == 0) {
      continue;
    }
    const double t = point.time - path[static_cast<std::size_t>(k - 1)].time;
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, 12);
    jacobian.leftCols(6) = -Eigen::MatrixXd::Identity(6, 6);
    jacobian.block<3, 3>(0, 3).diagonal().setConstant(-t);
    jacobian.rightCols(6).setIdentity();
    Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(6, 6);
    for (int axis = 0; axis < 3; ++axis) {
      noise(axis, axis) = strength * t * t * t / 3.0;
      noise(axis, axis + 3) = noise(axis + 3, axis) = strength * t * t / 2.0;
      noise(axis + 3, axis + 3) = strength * t;
    }
    information.block(6 * (k - 1), 6 * (k - 1), 12, 12) +=
        jacobian.transpose() * noise.inverse() * jacobian;
  }
  const Eigen::MatrixXd covariance = information.inverse();
  const Eigen::VectorXd mean = covariance * vector;
  std::vector<PathEstimate> result;
  for (Eigen::Index k = 0; k < count; ++k) {
    result.push_back({mean.segment<3>(6 * k), covariance.block<3, 3>(6 * k, 6 * k)});
  }
  return result;
}

TEST(SmoothPath, IsTheLeastSquaresSolutionOverAllStates) {
  const auto path = unevenPath();
  const auto smooth = smoothPath(path, {2, 3.0, 1.0});
  const auto expected = atOnce(path, 3.0);
  for (std::size_t k = 0; k < path.size(); ++k) {
    EXPECT_LT((smooth[k].position - expected[k].position).norm(), 1e-9) << k;
    EXPECT_LT((smooth[k].covariance - expected[k].covariance).norm(),
              1e-7 * expected[k].covariance.norm())
        << k;
  }
}

/// A path drawn from the model: white acceleration, looks with errors of the stated size.
struct Drawn {
  std::vector<PathPoint> path;
  std::vector<Eigen::Vector3d> truth;
};

Drawn draw(std::uint64_t seed, int count, double strength, double sigma) {
  constexpr double kStep = 1.0 / 30.0;
  const RandomStream stream(seed, 0, 0, RandomPurpose::Motion);
  Drawn drawn;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity = {0.2, -0.1, 0.3};
  for (int k = 0; k < count; ++k) {
    const auto index = static_cast<std::uint32_t>(3 * k);
    const auto a = stream.normal4(index);
    const auto b = stream.normal4(index + 1);
    const auto c = stream.normal4(index + 2);
    drawn.truth.push_back(place);
    drawn.path.push_back(
        {k * kStep, seenAt(place + sigma * Eigen::Vector3d(c[0], c[1], c[2]), sigma)});
    for (int axis = 0; axis < 3; ++axis) {
      // Cholesky factor of [t³/3 t²/2; t²/2 t].
      const auto i = static_cast<std::size_t>(axis);
      const double along = std::sqrt(strength * kStep * kStep * kStep / 3.0) * a[i];
      const double faster =
          std::sqrt(strength * kStep) * (std::sqrt(3.0) / 2.0 * a[i] + 0.5 * b[i]);
      place[axis] += kStep * velocity[axis] + along;
      velocity[axis] += faster;
    }
  }
  return drawn;
}

TEST(SmoothPath, StatesWhatItsErrorsAre) {
  // 40 runs of 100 looks, of which 15 in the middle are taken away: normalized squared errors have
  // the mean 3. Within a gap those of a run are one draw or two, so 40 runs say it to about 0.5.
  double inGap = 0.0;
  double elsewhere = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Drawn drawn = draw(seed, 100, 0.5, 0.002);
    for (std::size_t k = 40; k < 55; ++k) {
      drawn.path[k].measurement.reset();
    }
    const auto smooth = smoothPath(drawn.path, {2, 0.5, 1.0});
    const auto normalized = [&](std::size_t k) {
      const Eigen::Vector3d off = smooth[k].position - drawn.truth[k];
      return off.dot(smooth[k].covariance.inverse() * off);
    };
    inGap += normalized(47) / 40.0;
    elsewhere += (normalized(20) + normalized(80)) / 80.0;
  }
  EXPECT_NEAR(inGap, 3.0, 1.0);
  EXPECT_NEAR(elsewhere, 3.0, 0.8);
}

TEST(SmoothPath, EllipsoidsGrowTowardsTheMiddleOfAGap) {
  Drawn drawn = draw(3, 60, 0.5, 0.002);
  for (std::size_t k = 20; k < 41; ++k) {
    drawn.path[k].measurement.reset();
  }
  const auto smooth = smoothPath(drawn.path, {2, 0.5, 1.0});
  for (std::size_t k = 20; k < 30; ++k) {
    EXPECT_GT(smooth[k + 1].covariance.trace(), smooth[k].covariance.trace()) << k;
    EXPECT_GT(smooth[60 - k - 1].covariance.trace(), smooth[60 - k].covariance.trace()) << k;
  }
}

TEST(FitPathModel, FindsStrengthAndNoise) {
  Drawn drawn = draw(5, 2000, 0.5, 0.004);
  for (PathPoint& point : drawn.path) {
    point.measurement->covariance *= 4.0; // stated twice as large as they are
  }
  const PathModel model = fitPathModel(std::vector<std::vector<PathPoint>>{drawn.path});
  EXPECT_EQ(model.derivativeOrder, 2);
  EXPECT_NEAR(std::log(model.spectralDensity / 0.5), 0.0, 0.3);
  EXPECT_NEAR(model.noiseFactor, 0.25, 0.03);
}

TEST(FitPathModel, EndsWhereALikelihoodCannotBeComputed) {
  Drawn drawn = draw(5, 40, 0.5, 0.004);
  drawn.path[20].measurement->covariance.setIdentity();
  drawn.path[20].measurement->covariance *= 1e308; // overflows with any larger noise factor
  int asked = 0;
  const PathModel model =
      fitPathModel(std::vector<std::vector<PathPoint>>{drawn.path}, [&] { return ++asked < 1000; });
  EXPECT_LT(asked, 1000);
  EXPECT_TRUE(std::isfinite(pathLogLikelihood(drawn.path, model, 25.0)));
}

Trajectory liveRun(const Drawn& drawn) {
  Trajectory live;
  live.header.hasMeasurements = true;
  for (std::size_t k = 0; k < drawn.path.size(); ++k) {
    TrajectorySample& sample = live.samples.emplace_back();
    sample.time = drawn.path[k].time;
    sample.frame = static_cast<std::int64_t>(k);
    sample.target = "ball";
    sample.position = drawn.path[k].measurement->position;
    sample.covariance = drawn.path[k].measurement->covariance;
    sample.measurement = drawn.path[k].measurement;
  }
  return live;
}

double rmse(const Trajectory& trajectory, const Drawn& drawn) {
  double sum = 0.0;
  for (std::size_t k = 0; k < drawn.truth.size(); ++k) {
    sum += (trajectory.samples[k].position - drawn.truth[k]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(drawn.truth.size()));
}

TEST(Smoothed, FillsShortGapsAndLeavesLongOnes) {
  const Drawn drawn = draw(7, 150, 0.2, 0.002);
  Trajectory live = liveRun(drawn);
  const auto hide = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      live.samples[k].isValid = false;
      live.samples[k].measurement.reset();
    }
  };
  hide(20, 30);  // a third of a second
  hide(60, 100); // longer than a second
  const Trajectory after = smoothedTrajectory(live);
  for (std::size_t k = 20; k < 30; ++k) {
    EXPECT_TRUE(after.samples[k].isValid);
    EXPECT_LT((after.samples[k].position - drawn.truth[k]).norm(), 0.05);
  }
  for (std::size_t k = 60; k < 100; ++k) {
    EXPECT_FALSE(after.samples[k].isValid);
    EXPECT_EQ(after.samples[k].position, live.samples[k].position);
  }
}

TEST(Smoothed, IsNearerToTheTruthThanTheLooks) {
  const Drawn drawn = draw(8, 300, 0.05, 0.004);
  const Trajectory live = liveRun(drawn);
  EXPECT_LT(rmse(smoothedTrajectory(live), drawn), 0.5 * rmse(live, drawn));
}

TEST(Smoothed, GivesTheSameBitsTwice) {
  const Trajectory live = liveRun(draw(9, 200, 0.3, 0.003));
  const Trajectory first = smoothedTrajectory(live);
  const Trajectory second = smoothedTrajectory(live);
  for (std::size_t k = 0; k < first.samples.size(); ++k) {
    EXPECT_EQ(std::memcmp(first.samples[k].position.data(), second.samples[k].position.data(), 24),
              0);
    EXPECT_EQ(
        std::memcmp(first.samples[k].covariance.data(), second.samples[k].covariance.data(), 72),
        0);
  }
}

TEST(Smoothed, DropsAStrayLookAndFollowsAJump) {
  Drawn drawn = draw(10, 120, 0.1, 0.002);
  for (std::size_t k = 80; k < 120; ++k) {
    drawn.truth[k] += Eigen::Vector3d(0.5, 0.0, 0.0);
    drawn.path[k].measurement->position += Eigen::Vector3d(0.5, 0.0, 0.0);
  }
  Trajectory live = liveRun(drawn);
  live.samples[40].measurement->position += Eigen::Vector3d(0.2, 0.2, 0.0); // another thing
  const Trajectory after = smoothedTrajectory(live);
  EXPECT_LT((after.samples[40].position - drawn.truth[40]).norm(), 0.01);
  for (const std::size_t k : {78U, 79U, 80U, 81U}) {
    EXPECT_LT((after.samples[k].position - drawn.truth[k]).norm(), 0.01) << k;
  }
}

TEST(Smoothed, DropsAMistakeBehindAGap) {
  const Drawn drawn = draw(13, 150, 0.1, 0.002);
  Trajectory live = liveRun(drawn);
  for (std::size_t k = 60; k < 80; ++k) { // two thirds of a second: nearly any place is possible
    live.samples[k].isValid = false;
    live.samples[k].measurement.reset();
  }
  Trajectory without = live;
  for (std::size_t k = 80; k < 86; ++k) { // something beside it is taken for the target
    live.samples[k].measurement->position += Eigen::Vector3d(0.08, 0.0, 0.05);
    without.samples[k].measurement.reset();
  }
  const Trajectory after = smoothedTrajectory(live);
  const Trajectory expected = smoothedTrajectory(without);
  for (std::size_t k = 0; k < 150; ++k) {
    const Eigen::Vector3d sigma = expected.samples[k].covariance.diagonal().cwiseSqrt();
    // Only the model was fitted to other looks.
    EXPECT_LT((after.samples[k].position - expected.samples[k].position).norm(), sigma.norm()) << k;
  }
}

TEST(Smoothed, CanBeEnded) {
  const Trajectory live = liveRun(draw(14, 200, 0.1, 0.002));
  double last = 0.0;
  int calls = 0;
  SmootherOptions options;
  options.progress = [&](double done) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1.0);
    last = done;
    return ++calls < 5;
  };
  const Trajectory after = smoothedTrajectory(live, options);
  EXPECT_EQ(calls, 5);
  for (std::size_t k = 0; k < live.samples.size(); ++k) {
    EXPECT_EQ(after.samples[k].position, live.samples[k].position);
  }
}

TEST(SmoothPath, AsksNowAndThenWhetherToGoOn) {
  const Drawn drawn = draw(15, 5000, 0.1, 0.002);
  int calls = 0;
  smoothPath(drawn.path, PathModel(), [&] {
    ++calls;
    return true;
  });
  EXPECT_GE(calls, 10); // each thousand instants, there and back
  calls = 0;
  smoothPath(drawn.path, PathModel(), [&] {
    ++calls;
    return false;
  });
  EXPECT_LE(calls, 2); // once on each of the two ways
}

TEST(PathSurprises, AreToldOneByOneUntilItIsEnough) {
  Drawn drawn = draw(16, 300, 0.1, 0.002);
  drawn.path[50].measurement->position += Eigen::Vector3d(5.0, 0.0, 0.0);
  const PathModel model{2, 1.0, 1.0};
  const auto all = normalizedInnovations(drawn.path, model, 40.0);
  std::size_t told = 0;
  forEachNormalizedInnovation(drawn.path, model, 40.0, [&](std::size_t k, double surprise) {
    EXPECT_EQ(k, told);
    EXPECT_EQ(surprise, all[k]);
    ++told;
    return surprise <= 40.0;
  });
  EXPECT_EQ(told, 51U);
}

TEST(Smoothed, LeavesWhatItCannotSmooth) {
  Trajectory live = liveRun(draw(11, 4, 0.1, 0.002));
  EXPECT_EQ(smoothedTrajectory(live).samples[2].position, live.samples[2].position);
  EXPECT_TRUE(smoothedTrajectory(Trajectory()).samples.empty());
}

TEST(Smoothed, TakesEstimatesWhereAFileHasNoLooks) {
  const Drawn drawn = draw(12, 300, 0.05, 0.004);
  Trajectory live = liveRun(drawn);
  for (TrajectorySample& sample : live.samples) {
    sample.measurement.reset();
  }
  EXPECT_LT(rmse(smoothedTrajectory(live), drawn), 0.6 * rmse(live, drawn));
}

} // namespace
} // namespace dewpoint::tests
