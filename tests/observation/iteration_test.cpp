// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/filter/isotropic_motion.h"
#include "core/filter/models.h"
#include "core/filter/multinomial_resampling.h"
#include "core/filter/particle_filter.h"
#include "core/observation/sphere/color_window.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <vector>

namespace dewpoint::tests {
namespace {

const Eigen::Vector3d kTarget(0.0, 0.0, 0.3);

Camera cameraAt(const Eigen::Vector3d& position) {
  Camera camera;
  camera.intrinsics = {160, 120, 200.0, 200.0, 79.5, 59.5};
  camera.distortion = {-0.1, 0.02, 1e-3, -1e-3, 0.0};
  camera.cameraFromWorld = lookAt(position, kTarget);
  return camera;
}

struct Outcome {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
  double effectiveSampleSize;
  Eigen::Index bestIndex;
  Eigen::ArrayXXd next;
  Eigen::ArrayXd weights;
};

/// Five iterations of the whole filter on two images with a red patch in the middle.
Outcome track(Eigen::Index particles, int threads, InstructionSet limit) {
  const InstructionSetLimit limited(limit);
  const CameraRig rig{cameraAt({1.0, 0.0, 0.5}), cameraAt({0.1, -1.1, 0.4})};
  cv::Mat image(120, 160, CV_8UC3, cv::Scalar(40, 60, 50));
  image(cv::Rect(73, 52, 15, 15)) = cv::Scalar(20, 10, 200);
  ColorWindow window(rig, ColorClassifier(ColorRange{340.0, 20.0, 0.5, 1.0, 0.1, 0.9}));
  window.setImage(0, image);
  window.setImage(1, image);
  window.prepare(particles);
  ThreadTeam team(threads);
  ParticleFilter filter;
  filter.start(kTarget.transpose().array().replicate(particles, 1));
  const MotionProposal<IsotropicMotion> proposal{{0.03}};
  StateEstimate state;
  for (std::uint32_t i = 0; i < 5; ++i) {
    state = filter.iterate(proposal, window, MultinomialResampling{}, particles, {7, i, 0}, team);
  }
  return {state.mean,      state.covariance, state.effectiveSampleSize,
          state.bestIndex, filter.next(),    filter.weights().linearWeights()};
}

// One seed, the same bits: for any number of threads and for any processor.
TEST(WholeIteration, HasTheSameBitsForThreadsAndInstructionSets) {
  for (const Eigen::Index particles : {200, 3001, 20000}) {
    const Outcome plain = track(particles, 1, InstructionSet::Baseline);
    EXPECT_LT((plain.mean - kTarget).norm(), 0.1) << particles; // it does follow the patch
    for (const int threads : {1, 2, 4}) {
      for (const InstructionSet limit :
           {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
        const Outcome other = track(particles, threads, limit);
        EXPECT_EQ(other.mean, plain.mean) << particles << ' ' << threads << ' ' << int(limit);
        EXPECT_EQ(other.covariance, plain.covariance);
        EXPECT_EQ(other.effectiveSampleSize, plain.effectiveSampleSize);
        EXPECT_EQ(other.bestIndex, plain.bestIndex);
        EXPECT_TRUE((other.next == plain.next).all());
        EXPECT_TRUE((other.weights == plain.weights).all());
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
