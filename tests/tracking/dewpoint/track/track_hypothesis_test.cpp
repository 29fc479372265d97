// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/estimate.h"
#include "core/observation/sphere/sphere_evidence.h"
#include "core/tracking/dewpoint/track/track_hypothesis.h"
#include "tests/observation/drawn_spheres.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

using drawn::Ball;

/// Two cameras and a hypothesis about a ball near the middle of the desk: 1 cm and 0.5 m/s
/// uncertain, position and velocity correlated.
class TrackHypothesisTest : public ::testing::Test {
protected:
  TrackHypothesisTest()
      : rig_(drawn::rigAround(2, 2)), backgrounds_(2), images_(2), observation_(rig_) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      for (int frame = 0; frame < 20; ++frame) {
        backgrounds_[k].learn(drawn::wall(rig_[k]), {});
      }
    }
    hypothesis_.radius = 0.035;
    hypothesis_.streamNumber = 3;
    hypothesis_.probability = 0.5;
    hypothesis_.gaussian.mean << drawn::kMiddle, 0.2, -0.1, 0.05;
    hypothesis_.gaussian.covariance.setZero();
    for (int axis = 0; axis < 3; ++axis) {
      hypothesis_.gaussian.covariance(axis, axis) = 1e-4;
      hypothesis_.gaussian.covariance(axis + 3, axis + 3) = 0.25;
      hypothesis_.gaussian.covariance(axis, axis + 3) = 3e-3;
      hypothesis_.gaussian.covariance(axis + 3, axis) = 3e-3;
    }
  }
  void show(const std::vector<Ball>& balls) {
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      images_[k] = drawn::draw(rig_[k], balls);
      observation_.setImage(k, images_[k], 0.0, backgrounds_[k], classifier_);
    }
  }

  CameraRig rig_;
  ColorClassifier classifier_{drawn::kRed};
  std::vector<BackgroundModel> backgrounds_;
  std::vector<cv::Mat> images_;
  SphereObservation observation_;
  TrackHypothesis hypothesis_;
  ThreadTeam team_;
  RandomKey key_{11, 4, 0};
};

// Without images the evidence is flat: what the wider proposal draws, weighted, has the moments of
// the Gaussian. Five standard errors with the effective number of particles.
TEST_F(TrackHypothesisTest, ParticlesRepresentTheGaussian) {
  constexpr Eigen::Index kCount = 50000;
  sampleWeightedParticles(hypothesis_, observation_, kCount, key_, team_);
  ASSERT_EQ(hypothesis_.states.rows(), kCount);
  ASSERT_EQ(hypothesis_.states.cols(), 6);
  EXPECT_NEAR(hypothesis_.weights.sum(), 1.0, 1e-9);
  const StateEstimate moments = estimate(hypothesis_.states, hypothesis_.weights);
  EXPECT_GT(moments.effectiveSampleSize, 0.5 * kCount);
  const auto& covariance = hypothesis_.gaussian.covariance;
  for (int row = 0; row < 6; ++row) {
    const double variance = covariance(row, row);
    const double count = moments.effectiveSampleSize;
    EXPECT_NEAR(moments.mean[row], hypothesis_.gaussian.mean[row],
                5.0 * std::sqrt(variance / count));
    for (int column = 0; column < 6; ++column) {
      EXPECT_NEAR(moments.covariance(row, column), covariance(row, column),
                  5.0 * std::sqrt(2.0 * variance * covariance(column, column) / count))
          << row << ", " << column;
    }
  }
}

TEST_F(TrackHypothesisTest, ParticlesDoNotDependOnThreadsButOnTheStream) {
  show({Ball{drawn::kMiddle}});
  sampleWeightedParticles(hypothesis_, observation_, 1000, key_, team_);
  TrackHypothesis other = hypothesis_;
  ThreadTeam three(3);
  sampleWeightedParticles(other, observation_, 1000, key_, three);
  EXPECT_TRUE((other.states == hypothesis_.states).all());
  EXPECT_TRUE((other.weights == hypothesis_.weights).all());
  other.streamNumber = 4;
  sampleWeightedParticles(other, observation_, 1000, key_, team_);
  EXPECT_FALSE((other.states == hypothesis_.states).all());
}

TEST_F(TrackHypothesisTest, AnUpdateFindsTheBallAndConditionsTheGaussian) {
  const Eigen::Vector3d truth = drawn::kMiddle + Eigen::Vector3d(0.008, -0.006, 0.004);
  show({Ball{truth}});
  const Gaussian6 before = hypothesis_.gaussian;
  const double factor = applyMeasurementUpdate(hypothesis_, observation_, 500, key_, team_);
  EXPECT_TRUE(hypothesis_.wasOutlineFound);
  EXPECT_GT(factor, 3.0); // 20 times likelier at least
  EXPECT_LT((hypothesis_.position() - truth).norm(), 1e-3);
  EXPECT_EQ(hypothesis_.states.rows(), 500);
  EXPECT_NEAR(hypothesis_.fullyVisibleLogLikelihoodRatio,
              2.0 * SphereEvidence::maxLogLikelihoodRatio(), 1e-9);
  EXPECT_GT(hypothesis_.logLikelihoodRatio, 0.9 * hypothesis_.fullyVisibleLogLikelihoodRatio);
  // The velocity follows the position by the covariance 3e-3 over the variance 1e-4.
  const Eigen::Vector3d expected =
      before.mean.tail<3>() + 30.0 * (hypothesis_.position() - before.mean.head<3>());
  EXPECT_LT((hypothesis_.velocity() - expected).norm(), 1e-9);
  const Eigen::SelfAdjointEigenSolver<Gaussian6::Matrix> eigen(hypothesis_.gaussian.covariance);
  EXPECT_GT(eigen.eigenvalues()[0], 0.0);
  EXPECT_LT((hypothesis_.gaussian.covariance.topLeftCorner<3, 3>()).trace(), 1e-5);
}

TEST_F(TrackHypothesisTest, AnUpdateWithoutTheBallSpeaksAgainst) {
  sampleWeightedParticles(hypothesis_, observation_, 500, key_, team_);
  show({});
  const double factor = applyMeasurementUpdate(hypothesis_, observation_, 500, key_, team_);
  EXPECT_FALSE(hypothesis_.wasOutlineFound);
  EXPECT_LT(factor, -3.0);
  EXPECT_NEAR(hypothesis_.weights.sum(), 1.0, 1e-9);
}

TEST_F(TrackHypothesisTest, WithoutImagesAnUpdateChangesNothing) {
  sampleWeightedParticles(hypothesis_, observation_, 500, key_, team_);
  const TrackHypothesis before = hypothesis_;
  EXPECT_NEAR(applyMeasurementUpdate(hypothesis_, observation_, 500, key_, team_), 0.0, 1e-9);
  EXPECT_FALSE(hypothesis_.wasOutlineFound);
  EXPECT_EQ(hypothesis_.gaussian.mean, before.gaussian.mean);
  EXPECT_EQ(hypothesis_.gaussian.covariance, before.gaussian.covariance);
  EXPECT_TRUE((hypothesis_.states == before.states).all());
}

// An outline ten centimeters off, ten standard deviations, is another thing's.
TEST_F(TrackHypothesisTest, AnOutlineFarAwayIsAnotherThings) {
  sampleWeightedParticles(hypothesis_, observation_, 500, key_, team_);
  show({Ball{drawn::kMiddle + Eigen::Vector3d(0.1, 0.0, 0.0)}});
  EXPECT_LT(applyMeasurementUpdate(hypothesis_, observation_, 500, key_, team_), 0.0);
  EXPECT_FALSE(hypothesis_.wasOutlineFound);
  EXPECT_LT((hypothesis_.position() - drawn::kMiddle).norm(), 0.05); // nearer to where it was
}

// Half of the ball is behind something that looks like the wall: at a position away from it more
// samples show the color, but the outline knows better.
TEST_F(TrackHypothesisTest, AFewSamplesLessDoNotRefuseAnOutline) {
  show({Ball{drawn::kMiddle}});
  const int middle = images_[1].cols / 2; // where both cameras see the middle
  const int edge = middle - 2;            // so that one line of samples lies behind it
  images_[1](cv::Rect(edge, 0, images_[1].cols - edge, images_[1].rows)) =
      cv::Scalar::all(drawn::kWall);
  observation_.setImage(1, images_[1], 0.0, backgrounds_[1], classifier_);
  const Eigen::Vector3d left =
      rig_[1].cameraFromWorld.linear().transpose() * Eigen::Vector3d(-1.0, 0.0, 0.0);
  hypothesis_.gaussian.mean.head<3>() = drawn::kMiddle + 0.006 * left;
  observation_.setRadius(0.035);
  const Eigen::Vector3d rest = Eigen::Vector3d::Zero();
  ASSERT_GT(observation_.logLikelihoodRatio(hypothesis_.position(), rest),
            observation_.logLikelihoodRatio(drawn::kMiddle, rest) + 4.0);
  applyMeasurementUpdate(hypothesis_, observation_, 500, key_, team_);
  EXPECT_TRUE(hypothesis_.wasOutlineFound);
  EXPECT_LT((hypothesis_.position() - drawn::kMiddle).norm(), 4e-3);
}

TEST_F(TrackHypothesisTest, AnUnknownRadiusIsLearnedLookByLook) {
  const Eigen::Vector3d truth = drawn::kMiddle;
  show({Ball{truth}});
  hypothesis_.radius = 0.031;
  hypothesis_.logRadiusVariance = 0.04;
  applyMeasurementUpdate(hypothesis_, observation_, 500, key_, team_);
  EXPECT_NEAR(hypothesis_.radius, 0.035, 0.03 * 0.035);
  EXPECT_LT(hypothesis_.logRadiusVariance, 0.04);
  EXPECT_GT(hypothesis_.logRadiusVariance, 0.0);
}

// A camera that shows the wall alone sees no outline: the other one does not tell a ball of 33 mm
// from one of 35 mm that is farther away.
TEST_F(TrackHypothesisTest, ARadiusThatIsKnownStaysWhereOneCameraAloneSeesTheOutline) {
  show({Ball{drawn::kMiddle}});
  images_[1] = drawn::wall(rig_[1]);
  observation_.setImage(1, images_[1], 0.0, backgrounds_[1], classifier_);
  hypothesis_.radius = 0.033;
  hypothesis_.logRadiusVariance = 0.0004; // a fiftieth
  applyMeasurementUpdate(hypothesis_, observation_, 500, key_, team_);
  ASSERT_TRUE(hypothesis_.wasOutlineFound);
  EXPECT_EQ(hypothesis_.radius, 0.033);
  EXPECT_EQ(hypothesis_.logRadiusVariance, 0.0004);
}

TEST_F(TrackHypothesisTest, AMeasuredRadiusBecomesLessCertainUnlessOneCameraAloneCanSeeIt) {
  const ConstantVelocity motion{1.0 / 30.0, 8.0};
  hypothesis_.logRadiusVariance = 0.0004;
  hypothesis_.onlyOneCameraSees = true;
  predict(hypothesis_, motion, key_);
  EXPECT_EQ(hypothesis_.logRadiusVariance, 0.0004);
  hypothesis_.onlyOneCameraSees = false;
  predict(hypothesis_, motion, key_);
  EXPECT_GT(hypothesis_.logRadiusVariance, 0.0004);
  hypothesis_.logRadiusVariance = 0.0; // known
  predict(hypothesis_, motion, key_);
  EXPECT_EQ(hypothesis_.logRadiusVariance, 0.0);
}

TEST(EvidenceVolume, GrowsWithTheCubeOfTheRadius) {
  EXPECT_GT(constantLikelihoodVolume(0.035), 0.0);
  EXPECT_NEAR(constantLikelihoodVolume(0.07) / constantLikelihoodVolume(0.035), 8.0, 1e-9);
  EXPECT_LT(constantLikelihoodVolume(0.035), std::pow(0.035, 3)); // less than the ball's own size
}

} // namespace
} // namespace dewpoint::tests
