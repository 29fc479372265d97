// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/models.h"
#include "core/observation/sphere/sphere_evidence.h"
#include "core/observation/sphere/sphere_observation.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

static_assert(ObservationModel<SphereObservation>);

using drawn::Ball;
const Eigen::Vector3d kStill = Eigen::Vector3d::Zero();

/// Some cameras around a ball, before walls that are known.
class SphereObservationTest : public ::testing::Test {
protected:
  explicit SphereObservationTest(int cameras = 3)
      : rig_(drawn::rigAround(cameras)), backgrounds_(rig_.size()), images_(rig_.size()),
        observation_(rig_) {
    observation_.setRadius(ball_.radius);
    for (std::size_t k = 0; k < rig_.size(); ++k) {
      for (int frame = 0; frame < 20; ++frame) {
        backgrounds_[k].learn(drawn::wall(rig_[k]), {});
      }
      show(k, {ball_});
    }
  }
  void show(std::size_t camera, const std::vector<Ball>& balls, double timeOffset = 0.0) {
    images_[camera] = drawn::draw(rig_[camera], balls);
    observation_.setImage(camera, images_[camera], timeOffset, backgrounds_[camera], classifier_);
  }
  void remove(std::size_t camera) {
    observation_.setImage(camera, cv::Mat(), 0.0, backgrounds_[camera], classifier_);
  }

  Ball ball_{drawn::kMiddle, 0.035};
  CameraRig rig_;
  ColorClassifier classifier_{drawn::kRed};
  std::vector<BackgroundModel> backgrounds_;
  std::vector<cv::Mat> images_;
  SphereObservation observation_;
};

TEST_F(SphereObservationTest, SumsOverTheCameras) {
  EXPECT_EQ(observation_.cameraCount(), 3U);
  EXPECT_NEAR(observation_.logLikelihoodRatio(ball_.center, kStill),
              3.0 * SphereEvidence::maxLogLikelihoodRatio(), 1e-9);
  EXPECT_NEAR(observation_.fullyVisibleLogLikelihoodRatio(ball_.center, kStill),
              3.0 * SphereEvidence::maxLogLikelihoodRatio(), 1e-9);
  EXPECT_EQ(observation_.countSeeingCameras(ball_.center, kStill), 3);
  show(1, {});
  EXPECT_LT(observation_.logLikelihoodRatio(ball_.center, kStill),
            2.0 * SphereEvidence::maxLogLikelihoodRatio());
  EXPECT_NEAR(observation_.fullyVisibleLogLikelihoodRatio(ball_.center, kStill),
              3.0 * SphereEvidence::maxLogLikelihoodRatio(), 1e-9);
  EXPECT_EQ(observation_.countSeeingCameras(ball_.center, kStill), 2);
}

// A ball half a radius larger fills the whole ring. A neighbor whose middle lies inside its outline
// is the same ball seen crosswise and takes nothing of that away.
TEST_F(SphereObservationTest, TheSameThingSeenCrosswiseExplainsNothing) {
  for (std::size_t k = 0; k < 3; ++k) {
    show(k, {Ball{ball_.center, 1.5 * ball_.radius}});
  }
  EXPECT_LT(observation_.logLikelihoodRatio(ball_.center, kStill),
            SphereEvidence::maxLogLikelihoodRatio());
  EXPECT_EQ(observation_.explainedRingGain(ball_.center, {}), 0.0);
  const Eigen::Vector3d inside = ball_.center + Eigen::Vector3d(0.5 * ball_.radius, 0.0, 0.0);
  EXPECT_EQ(observation_.explainedRingGain(ball_.center, {{inside, 1.5 * ball_.radius}}), 0.0);
  const Eigen::Vector3d beside = ball_.center + Eigen::Vector3d(0.0, 0.0, 2.0 * ball_.radius);
  EXPECT_GT(observation_.explainedRingGain(ball_.center, {{beside, 1.5 * ball_.radius}}), 0.0);
}

TEST_F(SphereObservationTest, ACameraWithoutAUsableImageIsLeftOut) {
  remove(0);
  EXPECT_NEAR(observation_.logLikelihoodRatio(ball_.center, kStill),
              2.0 * SphereEvidence::maxLogLikelihoodRatio(), 1e-9);
  EXPECT_NEAR(observation_.fullyVisibleLogLikelihoodRatio(ball_.center, kStill),
              2.0 * SphereEvidence::maxLogLikelihoodRatio(), 1e-9);
  EXPECT_EQ(observation_.countSeeingCameras(ball_.center, kStill), 2);
  const cv::Mat gray(240, 320, CV_8UC1, cv::Scalar(80));
  observation_.setImage(1, gray, 0.0, backgrounds_[1], classifier_);
  EXPECT_NEAR(observation_.logLikelihoodRatio(ball_.center, kStill),
              SphereEvidence::maxLogLikelihoodRatio(), 1e-9);
  remove(2);
  remove(1);
  EXPECT_EQ(observation_.logLikelihoodRatio(ball_.center, kStill), 0.0);
  EXPECT_EQ(observation_.fullyVisibleLogLikelihoodRatio(ball_.center, kStill), 0.0);
}

TEST_F(SphereObservationTest, PlacesThatNoCameraSeesHaveNoEvidence) {
  const Eigen::Vector3d above(0.5, 0.5, 30.0);
  EXPECT_EQ(observation_.logLikelihoodRatio(above, kStill), 0.0);
  EXPECT_EQ(observation_.fullyVisibleLogLikelihoodRatio(above, kStill), 0.0);
  EXPECT_EQ(observation_.countSeeingCameras(above, kStill), 0);
}

TEST_F(SphereObservationTest, AWrongRadiusIsWorse) {
  const double right = observation_.logLikelihoodRatio(ball_.center, kStill);
  for (const double factor : {0.5, 0.7, 1.5, 2.0}) {
    observation_.setRadius(factor * ball_.radius);
    EXPECT_LT(observation_.logLikelihoodRatio(ball_.center, kStill), 0.8 * right) << factor;
  }
}

TEST_F(SphereObservationTest, ParticlesGetTheRatioOfTheirPlaces) {
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Zero(40, 6);
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    states.row(i).head(3) = drawn::placeNear(static_cast<std::uint32_t>(i), 0.08).transpose();
  }
  states.row(39) << 0.5, 0.5, 30.0, 0.0, 0.0, 0.0; // seen by none
  Eigen::ArrayXd logs = Eigen::ArrayXd::Constant(40, 2.5);
  observation_.ensureLabelsFor(states);
  observation_.addLogLikelihood(states, logs);
  Eigen::ArrayXd placesOnly = Eigen::ArrayXd::Constant(40, 2.5);
  observation_.addLogLikelihood(states.leftCols(3), placesOnly);
  for (Eigen::Index i = 0; i < states.rows(); ++i) {
    const Eigen::Vector3d place = states.row(i).head(3).transpose();
    EXPECT_NEAR(logs[i], 2.5 + observation_.logLikelihoodRatio(place, kStill), 1e-12) << i;
    EXPECT_EQ(placesOnly[i], logs[i]) << i;
  }
  EXPECT_EQ(logs[39], 2.5);
}

// Camera 1 looked 0.02 s after the common instant, when a ball of (2, -1, 0.5) m/s was 4 cm on.
TEST_F(SphereObservationTest, VelocityMovesAPlaceToWhenTheCameraLooked) {
  const Eigen::Vector3d velocity(2.0, -1.0, 0.5);
  show(1, {Ball{ball_.center + 0.02 * velocity, ball_.radius}}, 0.02);
  const double best = 3.0 * SphereEvidence::maxLogLikelihoodRatio();
  EXPECT_NEAR(observation_.logLikelihoodRatio(ball_.center, velocity), best, 0.05 * best);
  EXPECT_LT(observation_.logLikelihoodRatio(ball_.center, kStill), 0.8 * best);
  EXPECT_EQ(observation_.countSeeingCameras(ball_.center, velocity), 3);
  Eigen::ArrayXXd states(1, 6);
  states << ball_.center.x(), ball_.center.y(), ball_.center.z(), 2.0, -1.0, 0.5;
  Eigen::ArrayXd logs = Eigen::ArrayXd::Zero(1);
  observation_.ensureLabelsFor(states);
  observation_.addLogLikelihood(states, logs);
  EXPECT_NEAR(logs[0], observation_.logLikelihoodRatio(ball_.center, velocity), 1e-12);

  OutlinePrior prior;
  prior.center = ball_.center + Eigen::Vector3d(0.01, 0.0, 0.0);
  prior.radius = ball_.radius;
  const OutlineFit fit = observation_.fit(prior, velocity);
  ASSERT_TRUE(fit.isFound);
  EXPECT_LT((fit.center - ball_.center).norm(), 1e-3);
}

TEST_F(SphereObservationTest, ACameraSeesWhenAThirdIsFilled) {
  const auto outline = observation_.projector(0).project(ball_.center, ball_.radius);
  ASSERT_TRUE(outline);
  const auto cutAt = [&](double radii) {
    images_[0] = drawn::draw(rig_[0], {ball_});
    const int right = static_cast<int>(outline->center.x() + radii * outline->radius);
    images_[0](cv::Rect(0, 0, right, 240)) = cv::Scalar(200, 60, 30);
    observation_.setImage(0, images_[0], 0.0, backgrounds_[0], classifier_);
    return observation_.countSeeingCameras(ball_.center, kStill);
  };
  EXPECT_EQ(cutAt(0.0), 3);  // a half
  EXPECT_EQ(cutAt(0.75), 2); // less than a tenth
}

} // namespace
} // namespace dewpoint::tests
