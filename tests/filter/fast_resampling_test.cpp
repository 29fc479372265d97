// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/filter/cumulative.h"
#include "core/filter/multinomial_resampling.h"
#include "core/filter/sorted_lookup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace dewpoint {
namespace {

constexpr std::int64_t kBlock = MultinomialResampling::kBlock;

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
  for (Eigen::Index begin = 0; begin < weights.size(); begin += CumulativeWeights::kStretch) {
    const Eigen::Index end = std::min(weights.size(), begin + CumulativeWeights::kStretch);
    double sum = 0.0;
    for (Eigen::Index i = begin; i < end; ++i) {
      sum += weights[i];
      result.push_back(before + sum);
    }
    before += sum;
  }
  return result;
}

/// The slow way: a binary search in all cumulative weights for each draw, then listed by blocks.
std::vector<Eigen::Index> ancestorsByDefinition(const Eigen::ArrayXd& weights, Eigen::Index count,
                                                const RandomStream& stream) {
  const std::vector<double> cumulative = cumulativeByDefinition(weights);
  const double total = cumulative.back();
  const auto last = std::lower_bound(cumulative.begin(), cumulative.end(), total);
  std::vector<Eigen::Index> picked;
  for (Eigen::Index i = 0; i < count; ++i) {
    const double draw = stream.uniform(static_cast<std::uint32_t>(i)) * total;
    picked.push_back(std::upper_bound(cumulative.begin(), last, draw) - cumulative.begin());
  }
  std::stable_sort(picked.begin(), picked.end(),
                   [](Eigen::Index a, Eigen::Index b) { return a / kBlock < b / kBlock; });
  return picked;
}

TEST(CumulativeWeights, AreThoseOfTheDefinition) {
  for (const Eigen::Index count : {1, 200, 1023, 1024, 1025, 4096, 4097, 50000}) {
    for (const Eigen::ArrayXd& weights : weightsOfManyKinds(count)) {
      const std::vector<double> expected = cumulativeByDefinition(weights);
      for (const int threads : {1, 3}) {
        ThreadTeam team(threads);
        CumulativeWeights cumulative;
        cumulative.build(weights, team);
        std::vector<double> written(expected.size());
        cumulative.write(0, count, written.data());
        EXPECT_EQ(written, expected) << count;
        EXPECT_EQ(cumulative.total(), expected.back());
        EXPECT_TRUE(std::is_sorted(written.begin(), written.end()));
        for (std::int64_t begin = 1024; begin < count; begin += 1024) {
          ASSERT_EQ(cumulative.before(begin), expected[std::size_t(begin - 1)]);
        }
      }
    }
  }
}

TEST(SortedLookup, IsABinarySearch) {
  const RandomStream stream(3, 0, 0, RandomPurpose::Noise);
  for (const Eigen::Index count : {1, 2, 200, 4096}) {
    for (const Eigen::ArrayXd& weights : weightsOfManyKinds(count)) {
      const std::vector<double> sequence = cumulativeByDefinition(weights);
      if (!(sequence.back() > 0.0)) {
        continue;
      }
      std::vector<double> values{0.0};
      for (std::uint32_t i = 0; i < 3000; ++i) {
        values.push_back(stream.uniform(i) * sequence.back());
      }
      for (const double element : sequence) { // the hard cases: right on an element, and beside it
        values.insert(values.end(),
                      {element, std::nextafter(element, 0.0), std::nextafter(element, 1e9)});
      }
      const auto greatest = std::lower_bound(sequence.begin(), sequence.end(), sequence.back());
      for (const std::int32_t cellsPerElement : {1, 2, 16}) {
        SortedLookup lookup;
        lookup.build(sequence.data(), static_cast<std::int32_t>(count), 0.0, cellsPerElement);
        std::vector<std::int32_t> found(values.size());
        lookup.find(values.data(), static_cast<std::int64_t>(values.size()), found.data());
        for (std::size_t i = 0; i < values.size(); ++i) {
          ASSERT_EQ(found[i],
                    std::upper_bound(sequence.begin(), greatest, values[i]) - sequence.begin())
              << values[i] << " of " << sequence.back();
        }
      }
    }
  }
}

TEST(MultinomialResampling, IsABinarySearchAncestorByAncestor) {
  const RandomStream stream(17, 4, 2, RandomPurpose::Resampling);
  for (const Eigen::Index particles : {1, 7, 200, 4096, 4097, 60000}) {
    for (const Eigen::ArrayXd& weights : weightsOfManyKinds(particles)) {
      if (!(weights.sum() > 0.0)) {
        continue;
      }
      for (const Eigen::Index count : {1, 200, 4096, 40001}) {
        const auto expected = ancestorsByDefinition(weights, count, stream);
        for (const int threads : {1, 2, 3}) {
          ThreadTeam team(threads);
          std::vector<Eigen::Index> picked;
          MultinomialResampling{}.ancestors(weights, count, stream, team, picked);
          ASSERT_EQ(picked, expected) << particles << " particles, " << count << " drawn";
        }
        std::vector<Eigen::Index> picked;
        MultinomialResampling{}.ancestors(weights, count, stream, picked);
        ASSERT_EQ(picked, expected);
      }
    }
  }
}

// What the paper's filter has always been: up to a block, ancestors come in the order of the draws.
TEST(MultinomialResampling, KeepsTheOrderOfTheDrawsWithinABlock) {
  const RandomStream stream(1, 0, 0, RandomPurpose::Resampling);
  const Eigen::ArrayXd weights = Eigen::ArrayXd::Constant(200, 1.0);
  std::vector<Eigen::Index> picked;
  MultinomialResampling{}.ancestors(weights, 200, stream, picked);
  for (std::uint32_t i = 0; i < 200; ++i) { // all weights 1: the draw itself is the index
    EXPECT_EQ(picked[i], static_cast<Eigen::Index>(stream.uniform(i) * 200.0));
  }
}

} // namespace
} // namespace dewpoint
