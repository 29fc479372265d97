// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/isotropic_motion.h"
#include "core/filter/multinomial_resampling.h"
#include "core/filter/particle_filter.h"
#include "tests/base/not_a_number.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace dewpoint::tests {
namespace {

struct GaussianAt {
  Eigen::Vector3d center;
  double sigma = 0.1;
  void addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      double squares = 0.0;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        squares += (rows(i, axis) - center[axis]) * (rows(i, axis) - center[axis]);
      }
      logLikelihood[i] -= squares / (2.0 * sigma * sigma);
    }
  }
};

struct Constant {
  double value = 0.0;
  void addLogLikelihood(ConstStateRows /*rows*/, LogWeightSegment logLikelihood) const {
    logLikelihood += value;
  }
};

/// Leaves the states alone and prefers the particle whose x is 1.
struct WeightedProposal {
  void propose(StateRows rows, LogWeightSegment logWeights, std::uint32_t /*firstIndex*/,
               const RandomStream& /*stream*/) const {
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      logWeights[i] += rows(i, 0) == 1.0 ? std::log(3.0) : 0.0;
    }
  }
};

static_assert(MotionModel<IsotropicMotion>);
static_assert(Proposal<MotionProposal<IsotropicMotion>>);
static_assert(Proposal<WeightedProposal>);
static_assert(ObservationModel<GaussianAt>);
static_assert(Resampler<MultinomialResampling>);
static_assert(!MotionModel<GaussianAt>);

using RandomWalk = MotionProposal<IsotropicMotion>;

TEST(IsotropicMotion, StepsHaveSigmaInEveryDirection) {
  constexpr Eigen::Index kCount = 40000;
  Eigen::ArrayXXd states = Eigen::ArrayXXd::Constant(kCount, 3, 2.0);
  IsotropicMotion{0.03}.predict(states, 0, RandomStream(3, 0, 0, RandomPurpose::Motion));
  const StateEstimate result = estimate(states, Eigen::ArrayXd::Constant(kCount, 1.0 / kCount));
  for (Eigen::Index a = 0; a < 3; ++a) {
    EXPECT_NEAR(result.mean[a], 2.0, 5.0 * 0.03 / std::sqrt(double(kCount)));
    for (Eigen::Index b = 0; b < 3; ++b) {
      // Variance sigma², independent axes; standard error of a variance sigma² sqrt(2 / n).
      EXPECT_NEAR(result.covariance(a, b), a == b ? 0.0009 : 0.0,
                  5.0 * 0.0009 * std::sqrt(2.0 / kCount));
    }
  }
}

TEST(IsotropicMotion, AWindowOfTheSetGetsTheNumbersOfItsParticles) {
  const RandomStream stream(3, 1, 2, RandomPurpose::Motion);
  Eigen::ArrayXXd whole = Eigen::ArrayXXd::Zero(10, 3);
  Eigen::ArrayXXd cut = whole;
  IsotropicMotion{}.predict(whole, 0, stream);
  IsotropicMotion{}.predict(cut.topRows(4), 0, stream);
  IsotropicMotion{}.predict(cut.bottomRows(6), 4, stream);
  EXPECT_TRUE((whole == cut).all());
}

std::vector<StateEstimate> runFilter(int threads, Eigen::ArrayXXd& lastStates) {
  ThreadTeam team(threads);
  ParticleFilter filter;
  filter.start(Eigen::ArrayXXd::Zero(5000, 3)); // above the count a ThreadTeam starts to share
  std::vector<StateEstimate> results;
  for (std::uint32_t iteration = 0; iteration < 10; ++iteration) {
    const Eigen::Index next = iteration < 5 ? 5000 : 7001;
    results.push_back(filter.iterate(RandomWalk{}, GaussianAt{{0.3, -0.2, 0.1}},
                                     MultinomialResampling{}, next, {9, 4, iteration}, team));
  }
  lastStates = filter.next();
  return results;
}

TEST(ParticleFilter, SameBitsForAnyNumberOfThreads) {
  Eigen::ArrayXXd expectedStates;
  const auto expected = runFilter(1, expectedStates);
  for (const int threads : {2, 4}) {
    Eigen::ArrayXXd states;
    const auto results = runFilter(threads, states);
    ASSERT_EQ(states.rows(), expectedStates.rows());
    EXPECT_TRUE((states == expectedStates).all());
    for (std::size_t i = 0; i < results.size(); ++i) {
      EXPECT_EQ(results[i].mean, expected[i].mean);
      EXPECT_EQ(results[i].covariance, expected[i].covariance);
      EXPECT_EQ(results[i].bestIndex, expected[i].bestIndex);
      EXPECT_EQ(results[i].effectiveSampleSize, expected[i].effectiveSampleSize);
    }
  }
}

// One iteration is a linear Gaussian model: prior N(0, s²) times likelihood N(0.1, s²) with
// s = 0.1 gives mean 0.05 and variance s²/2 = 0.005 on x, mean 0 on y and z.
TEST(ParticleFilter, AgreesWithTheGaussianPosterior) {
  ThreadTeam team(2);
  ParticleFilter filter;
  filter.start(Eigen::ArrayXXd::Zero(200000, 3));
  const auto result = filter.iterate(RandomWalk{{0.1}}, GaussianAt{{0.1, 0.0, 0.0}, 0.1},
                                     MultinomialResampling{}, 200000, {}, team);
  // Standard error about sqrt(0.005 / effective size), which is above 50000 here: 0.0003.
  ASSERT_GT(result.effectiveSampleSize, 50000.0);
  EXPECT_NEAR(result.mean[0], 0.05, 0.0015);
  EXPECT_NEAR(result.mean[1], 0.0, 0.0015);
  EXPECT_NEAR(result.covariance(0, 0), 0.005, 0.0003);
  EXPECT_NEAR(result.covariance(2, 2), 0.005, 0.0003);
}

TEST(ParticleFilter, ProposalWeightsCount) {
  ThreadTeam team;
  ParticleFilter filter;
  Eigen::ArrayXXd states(2, 1);
  states << 0.0, 1.0;
  filter.start(states);
  const auto result =
      filter.iterate(WeightedProposal{}, Constant{-5.0}, MultinomialResampling{}, 2, {}, team);
  EXPECT_NEAR(result.mean[0], 0.75, 1e-12); // weights 1 : 3 on x = 0 and 1
  EXPECT_NEAR(filter.weights()[1], 0.75, 1e-12);
  EXPECT_TRUE((filter.states() == states).all());
}

TEST(ParticleFilter, DegenerateWeightsKeepAllAndAreFlagged) {
  ThreadTeam team;
  ParticleFilter filter;
  filter.start(Eigen::ArrayXXd::Constant(50, 3, 1.0));
  const auto lost = filter.iterate(RandomWalk{}, Constant{kNotANumber}, MultinomialResampling{}, 50,
                                   {1, 0, 0}, team);
  EXPECT_TRUE(lost.isDegenerate);
  EXPECT_NEAR(lost.effectiveSampleSize, 50.0, 1e-9);
  EXPECT_TRUE(lost.mean.allFinite());
  const auto found =
      filter.iterate(RandomWalk{}, Constant{}, MultinomialResampling{}, 50, {1, 0, 1}, team);
  EXPECT_FALSE(found.isDegenerate);
}

TEST(ParticleFilter, CountChangesAtResamplingOrAtOnce) {
  ThreadTeam team;
  ParticleFilter filter;
  filter.start(Eigen::ArrayXXd::Zero(20, 3));
  filter.iterate(RandomWalk{}, Constant{}, MultinomialResampling{}, 30, {1, 0, 0}, team);
  EXPECT_EQ(filter.states().rows(), 20);
  EXPECT_EQ(filter.nextParticleCount(), 30);
  filter.resize(MultinomialResampling{}, 10, {1, 0, 1}, team);
  EXPECT_EQ(filter.states().rows(), 20);
  ASSERT_EQ(filter.nextParticleCount(), 10);
  for (Eigen::Index i = 0; i < 10; ++i) { // each is one of the weighted ones
    bool found = false;
    for (Eigen::Index j = 0; j < 20; ++j) {
      found = found || (filter.next().row(i) == filter.states().row(j)).all();
    }
    EXPECT_TRUE(found);
  }
  filter.iterate(RandomWalk{}, Constant{}, MultinomialResampling{}, 10, {1, 0, 1}, team);
  EXPECT_EQ(filter.weights().particleCount(), 10);
  EXPECT_NEAR(filter.weights().linearWeights().sum(), 1.0, 1e-12);
}

// A frame may have 500 iterations; with 8 bits for them, iteration 256 of one part was iteration 0
// of the next.
TEST(RandomKey, PartsNeverShareAStream) {
  std::set<std::array<std::uint32_t, 4>> seen;
  for (std::uint32_t iteration = 0; iteration < 500; ++iteration) {
    for (const std::uint32_t part : {0U, 1U, 2U, 3U, 4094U, 4095U}) {
      const RandomKey key{7, 3, iteration};
      const auto words = key.streamOfPart(RandomPurpose::Resampling, part).randomWords(0);
      EXPECT_TRUE(seen.insert(words).second) << "part " << part << ", iteration " << iteration;
    }
  }
}

TEST(RandomKey, TheFirstPartIsTheIterationItself) {
  const RandomKey key{7, 3, 255};
  EXPECT_EQ(key.streamOfPart(RandomPurpose::Resampling, 0).randomWords(5),
            key.stream(RandomPurpose::Resampling).randomWords(5));
}

} // namespace
} // namespace dewpoint::tests
