// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/filter/block_weights.h"
#include "core/filter/cumulative.h"
#include "core/filter/estimate.h"
#include "core/filter/multinomial_resampling.h"
#include "core/filter/sorted_draws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace dewpoint::tests {
namespace {

/// Weights of many kinds: equal, a few heavy ones among light ones, rising over 200 decades, mostly
/// zero with zeros at both ends, far from summing to 1.
std::vector<Eigen::ArrayXd> weightsOfManyKinds(Eigen::Index count) {
  const RandomStream stream(99, 0, 0, RandomPurpose::Noise);
  const auto fill = [&](const std::function<double(Eigen::Index, double)>& weight) {
    Eigen::ArrayXd weights(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      weights[i] = weight(i, stream.uniform(static_cast<std::uint32_t>(i)));
    }
    return weights;
  };
  const double all = double(count);
  return {fill([&](Eigen::Index, double) { return 1.0 / all; }),
          fill([&](Eigen::Index, double unit) { return unit < 0.01 ? 1.0 : 1e-9 * unit; }),
          fill([&](Eigen::Index i, double unit) {
            return unit * std::pow(10.0, 200.0 * double(i) / all - 200.0);
          }),
          fill([&](Eigen::Index i, double unit) {
            return i > count / 3 && i < count / 2 && unit < 0.3 ? unit : 0.0;
          }),
          fill([&](Eigen::Index, double unit) { return 1e-300 * unit; })};
}

/// In order within each stretch, then moved by the sum of the stretches before.
std::vector<double> cumulativeByDefinition(const Eigen::ArrayXd& weights) {
  std::vector<double> result;
  double before = 0.0;
  for (Eigen::Index begin = 0; begin < weights.size(); begin += kStretch) {
    const Eigen::Index end = std::min(weights.size(), begin + kStretch);
    double sum = 0.0;
    for (Eigen::Index i = begin; i < end; ++i) {
      sum += weights[i];
      result.push_back(before + sum);
    }
    before += sum;
  }
  return result;
}

/// Draws by their definition, one after the other.
std::vector<double> drawsByDefinition(Eigen::Index count, double total,
                                      const RandomStream& stream) {
  const SortedDraws draws(stream, count, total);
  std::vector<double> result;
  std::vector<double> block(std::size_t{SortedDraws::kBlockSize});
  for (std::int64_t b = 0; b < draws.blockCount(); ++b) {
    const std::int64_t length = draws.writeBlock(b, block.data());
    result.insert(result.end(), block.begin(), block.begin() + length);
  }
  return result;
}

/// The slow way: a binary search in all cumulative weights for each draw.
Ancestors ancestorsByDefinition(const std::vector<double>& cumulative, Eigen::Index count,
                                const RandomStream& stream) {
  Ancestors picked;
  for (const double draw : drawsByDefinition(count, cumulative.back(), stream)) {
    picked.push_back(static_cast<std::int32_t>(
        std::upper_bound(cumulative.begin(), cumulative.end(), draw) - cumulative.begin()));
  }
  return picked;
}

std::vector<double> written(const CumulativeWeights& cumulative) {
  std::vector<double> all;
  std::vector<double> block(std::size_t{kPrefixBlock});
  for (std::int64_t begin = 0; begin < cumulative.particleCount(); begin += kPrefixBlock) {
    const std::int64_t length = cumulative.writeBlock(begin / kPrefixBlock, block.data());
    all.insert(all.end(), block.begin(), block.begin() + length);
  }
  return all;
}

/// As an iteration makes them, from the logarithms of weights.
BlockWeights inBlocks(const Eigen::ArrayXd& weights) {
  const Eigen::ArrayXd logWeights = weights.log();
  BlockWeights blocks;
  blocks.resize(weights.size());
  for (std::int64_t begin = 0; begin < weights.size(); begin += kSumBlock) {
    blocks.setBlock(begin, std::min(kSumBlock, weights.size() - begin), logWeights.data() + begin);
  }
  EXPECT_EQ(blocks.normalize(), (weights > 0.0).any());
  return blocks;
}

TEST(CumulativeWeights, AreThoseOfTheDefinition) {
  for (const Eigen::Index count : {1, 200, 700, 1000, 1023, 1024, 1025, 4096, 4097, 50000}) {
    for (const Eigen::ArrayXd& weights : weightsOfManyKinds(count)) {
      const std::vector<double> expected = cumulativeByDefinition(weights);
      CumulativeWeights cumulative;
      cumulative.compute(weights);
      EXPECT_EQ(written(cumulative), expected) << count;
      EXPECT_EQ(cumulative.total(), expected.back());
      EXPECT_TRUE(std::is_sorted(expected.begin(), expected.end()));
      for (const double share : {0.0, 0.1, 0.5, 0.999999}) {
        const double draw = share * expected.back();
        const auto found = std::upper_bound(expected.begin(), expected.end(), draw);
        if (expected.back() > 0.0) {
          EXPECT_EQ(cumulative.blockOfDraw(draw), (found - expected.begin()) / kPrefixBlock);
        }
      }
    }
  }
}

TEST(BlockWeights, AreTheNormalizedWeights) {
  ThreadTeam team;
  for (const Eigen::Index count : {1, 200, 1023, 1024, 1025, 5000}) {
    for (const Eigen::ArrayXd& weights : weightsOfManyKinds(count)) {
      Eigen::ArrayXd expected;
      normalize(weights.log(), expected, team);
      const BlockWeights blocks = inBlocks(weights);
      CumulativeWeights cumulative;
      cumulative.compute(blocks);
      const std::vector<double> sums = written(cumulative);
      EXPECT_TRUE(std::is_sorted(sums.begin(), sums.end()));
      EXPECT_EQ(sums.back(), cumulative.total());
      double sum = 0.0;
      for (Eigen::Index i = 0; i < count; ++i) {
        sum += blocks[i];
        ASSERT_NEAR(blocks[i], expected[i], 1e-14 * expected[i] + 1e-280) << i << " of " << count;
        ASSERT_NEAR(sums[std::size_t(i)], sum, 1e-12) << i << " of " << count;
      }
      EXPECT_NEAR(sum, 1.0, 1e-12);
      EXPECT_TRUE((blocks.linearWeights() >= 0.0).all());
    }
  }
}

// Log weights of any size, some useless: those of a block decide about the block only.
TEST(BlockWeights, KeepWhatMattersOfEveryBlock) {
  Eigen::ArrayXd logWeights = Eigen::ArrayXd::Constant(3000, -std::nan(""));
  logWeights[10] = -1e5;
  logWeights[2000] = -10.0 + std::log(3.0);
  logWeights[2999] = -10.0;
  BlockWeights blocks;
  blocks.resize(3000);
  for (const std::int64_t begin : {2048, 0, 1024}) {
    blocks.setBlock(begin, std::min<std::int64_t>(1024, 3000 - begin), logWeights.data() + begin);
  }
  EXPECT_TRUE(blocks.normalize());
  EXPECT_NEAR(blocks[2000], 0.75, 1e-14); // 3 : 1
  EXPECT_NEAR(blocks[2999], 0.25, 1e-14);
  EXPECT_EQ((blocks.linearWeights() > 0.0).count(), 2);
}

// One block, straight from the definition: partial sums of the spacings over their sum.
TEST(SortedDraws, ArePartialSumsOfSpacings) {
  const RandomStream stream(17, 4, 2, RandomPurpose::Resampling);
  for (const Eigen::Index count : {1, 200, 700, 1023}) {
    const auto spacing = [&](Eigen::Index i) {
      return double{stream.exponential4(std::uint32_t(i % kStretch))[std::size_t(i / kStretch)]};
    };
    double sum = 0.0;
    for (Eigen::Index i = 0; i <= count; ++i) {
      sum += spacing(i);
    }
    const std::vector<double> draws = drawsByDefinition(count, 5.0, stream);
    double partial = 0.0;
    for (Eigen::Index i = 0; i < count; ++i) {
      partial += spacing(i);
      ASSERT_NEAR(draws[std::size_t(i)], 5.0 * partial / sum, 1e-13) << i << " of " << count;
    }
  }
}

TEST(SortedDraws, RiseAndStayBelowTheTotal) {
  for (const Eigen::Index count : {1, 255, 256, 1023, 1024, 1025, 2047, 2048, 50000}) {
    for (const double total : {1.0, 1e-300, 3e200}) {
      const auto draws =
          drawsByDefinition(count, total, RandomStream(2, 0, 0, RandomPurpose::Resampling));
      ASSERT_EQ(Eigen::Index(draws.size()), count);
      EXPECT_TRUE(std::is_sorted(draws.begin(), draws.end()));
      EXPECT_GE(draws.front(), 0.0);
      EXPECT_LT(draws.back(), total);
    }
  }
}

// Of n uniform draws, n p fall below p, with standard deviation sqrt(n p (1 - p)); those of two
// separate parts have covariance - n p q. Five blocks, so the sums of blocks matter.
TEST(SortedDraws, FallIntoPartsLikeIndependentUniformDraws) {
  constexpr Eigen::Index kCount = 4200;
  constexpr int kTrials = 4000;
  const std::vector<double> ends{0.001, 0.2, 0.25, 0.7};
  std::vector<double> sum(ends.size());
  std::vector<double> squares(ends.size());
  double product = 0.0; // of what is below 0.2 and above 0.7
  for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
    const auto draws =
        drawsByDefinition(kCount, 1.0, RandomStream(8, trial, 0, RandomPurpose::Resampling));
    std::vector<double> surplus;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const auto end = std::lower_bound(draws.begin(), draws.end(), ends[i]);
      surplus.push_back(double(end - draws.begin()) - kCount * ends[i]);
      sum[i] += surplus[i];
      squares[i] += surplus[i] * surplus[i];
    }
    product -= surplus[1] * surplus[3];
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double variance = kCount * ends[i] * (1.0 - ends[i]);
    EXPECT_NEAR(sum[i] / kTrials, 0.0, 5.0 * std::sqrt(variance / kTrials)) << ends[i];
    // The fourth moment of a binomial: 3 v² + v at most; of the square then 2 v² + v.
    EXPECT_NEAR(squares[i] / kTrials, variance,
                5.0 * std::sqrt((2.0 * variance * variance + variance) / kTrials))
        << ends[i];
  }
  const double covariance = -kCount * 0.2 * 0.3;
  EXPECT_NEAR(product / kTrials, covariance,
              5.0 * std::sqrt((covariance * covariance + kCount * 0.16 * kCount * 0.21) / kTrials));
}

TEST(MultinomialResampling, IsABinarySearchAncestorByAncestor) {
  const RandomStream stream(17, 4, 2, RandomPurpose::Resampling);
  for (const Eigen::Index particles : {1, 7, 200, 4096, 4097, 60000}) {
    for (const Eigen::ArrayXd& weights : weightsOfManyKinds(particles)) {
      if (!(weights.sum() > 0.0)) {
        continue;
      }
      const BlockWeights blocks = inBlocks(weights);
      CumulativeWeights cumulative;
      cumulative.compute(blocks);
      for (const Eigen::Index count : {1, 200, 1000, 4096, 40001}) {
        Ancestors picked;
        MultinomialResampling{}.drawAncestors(weights, count, stream, picked);
        ASSERT_EQ(picked, ancestorsByDefinition(cumulativeByDefinition(weights), count, stream))
            << particles << " particles, " << count << " drawn";
        const Ancestors expected = ancestorsByDefinition(written(cumulative), count, stream);
        for (const int threads : {1, 2, 3}) {
          ThreadTeam team(threads);
          MultinomialResampling{}.drawAncestors(blocks, count, stream, team, picked);
          ASSERT_EQ(picked, expected) << particles << " particles, " << count << " drawn";
        }
      }
    }
  }
}

// All weights 1: the draw itself, rounded down, is the index.
TEST(MultinomialResampling, LooksUpTheSortedDraws) {
  const RandomStream stream(1, 0, 0, RandomPurpose::Resampling);
  const Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(200, 1.0);
  Ancestors picked;
  MultinomialResampling{}.drawAncestors(weights, 300, stream, picked);
  const std::vector<double> draws = drawsByDefinition(300, 200.0, stream);
  for (std::size_t i = 0; i < picked.size(); ++i) {
    EXPECT_EQ(picked[i], static_cast<Eigen::Index>(draws[i]));
  }
}

} // namespace
} // namespace dewpoint::tests
