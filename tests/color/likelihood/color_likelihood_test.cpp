// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/color/likelihood/color_likelihood.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace dewpoint::tests {
namespace {

constexpr std::array<InstructionSet, 3> kInstructionSets{
    InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512};

/// A log ratio between -6 and 6 nats for each cell.
ColorLikelihood anyTable() {
  const RandomStream stream(3, 0, 0, RandomPurpose::Noise);
  std::vector<double> logRatios;
  for (std::uint32_t cell = 0; cell < kColorCellCount; ++cell) {
    logRatios.push_back(12.0 * stream.uniform3(cell, 1)[0] - 6.0);
  }
  return ColorLikelihood(logRatios);
}

/// The lowest everywhere but for colors of much red and hardly any green.
ColorLikelihood redTable() {
  std::vector<double> logRatios(kColorCellCount, -100.0);
  for (std::uint8_t b = 0; b < 100; b += 8) {
    for (std::uint8_t r = 150; r < 250; r += 8) {
      logRatios[colorCell(b, 20, r)] = r > 200 ? 3.0 : -1.0;
    }
  }
  return ColorLikelihood(logRatios);
}

/// Pixels of any color.
std::vector<std::uint8_t> anyPixels(std::uint32_t count) {
  const RandomStream stream(4, 0, 0, RandomPurpose::Noise);
  std::vector<std::uint8_t> pixels;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto word = stream.randomWords(i, 1);
    for (std::size_t k = 0; k < 3; ++k) {
      pixels.push_back(static_cast<std::uint8_t>(word[k]));
    }
  }
  return pixels;
}

TEST(ColorLikelihood, StepsAreRoundedAndBounded) {
  std::vector<double> logRatios(kColorCellCount, 0.0);
  logRatios[colorCell(8, 0, 0)] = 1.0;
  logRatios[colorCell(0, 8, 0)] = -0.04; // 0.64 of a step
  logRatios[colorCell(0, 0, 8)] = 0.03;  // 0.48 of a step
  logRatios[colorCell(80, 80, 80)] = 100.0;
  logRatios[colorCell(88, 80, 80)] = -100.0;
  const ColorLikelihood table(logRatios);
  EXPECT_EQ(table.logRatioSteps(0, 0, 0), 0);
  EXPECT_EQ(table.logRatioSteps(8, 0, 0), 16);
  EXPECT_EQ(table.logRatioSteps(15, 7, 7), 16); // the same cell
  EXPECT_EQ(table.logRatioSteps(0, 8, 0), -1);
  EXPECT_EQ(table.logRatioSteps(0, 0, 8), 0);
  EXPECT_EQ(table.logRatioSteps(80, 80, 80), 72);
  EXPECT_EQ(table.logRatioSteps(88, 80, 80), -72);
  EXPECT_EQ(table.logRatio(8, 0, 0), 1.0);
  EXPECT_EQ(table.logRatio(80, 80, 80), 4.5);
}

TEST(ColorLikelihood, CopiesAreEqual) {
  const ColorLikelihood table = redTable();
  ColorLikelihood copy = anyTable();
  EXPECT_FALSE(copy == table);
  copy = table;
  EXPECT_TRUE(copy == table);
  EXPECT_TRUE(redTable() == table);
}

// Rows of every length up to several runs and leftovers, nothing written beyond the end. Colors
// beside the red ones make runs of which nothing, one pixel or all is in reach.
TEST(ColorLikelihood, RowsAreTheSameForEveryInstructionSetAndLength) {
  std::vector<std::uint8_t> mostlyGray(3 * std::size_t{1100}, 120);
  for (const std::size_t i :
       {std::size_t{0}, std::size_t{127}, std::size_t{400}, std::size_t{1099}}) {
    mostlyGray[3 * i] = 30;
    mostlyGray[3 * i + 1] = 20;
    mostlyGray[3 * i + 2] = 220;
  }
  const ColorLikelihood nowhere(std::vector<double>(kColorCellCount, -100.0));
  for (const ColorLikelihood& table : {anyTable(), redTable(), nowhere}) {
    for (const auto& pixels : {anyPixels(1100), mostlyGray}) {
      for (const InstructionSet limit : kInstructionSets) {
        const InstructionSetLimit limited(limit);
        for (const int count : {0, 1, 2, 31, 33, 127, 128, 129, 255, 256, 400, 401, 1023, 1100}) {
          std::vector<std::int8_t> out(static_cast<std::size_t>(count) + 1, 7);
          std::vector<std::uint8_t> match(static_cast<std::size_t>(count) + 1, 7);
          table.computeLogRatioRow(pixels.data(), count, out.data());
          table.matchRow(pixels.data(), count, match.data());
          ASSERT_EQ(out.back(), 7);
          ASSERT_EQ(match.back(), 7);
          for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const auto alone =
                table.logRatioSteps(pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]);
            ASSERT_EQ(out[i], alone) << i << " of " << count;
            ASSERT_EQ(match[i], alone > 0 ? 255 : 0) << i << " of " << count;
          }
        }
      }
    }
  }
}

TEST(ColorLikelihood, AMatchExceedsTheThreshold) {
  std::vector<double> logRatios(kColorCellCount, 0.0);
  logRatios[colorCell(0, 0, 0)] = 2.0;
  const ColorLikelihood table(logRatios);
  const auto isBlackMatching = [&](double threshold) {
    const std::array<std::uint8_t, 3> black{0, 0, 0};
    std::uint8_t match = 7;
    table.matchRow(black.data(), 1, &match, threshold);
    return match == 255;
  };
  EXPECT_TRUE(isBlackMatching(0.0));
  EXPECT_TRUE(isBlackMatching(1.99));
  EXPECT_FALSE(isBlackMatching(2.0));
  EXPECT_FALSE(isBlackMatching(2.01));
  EXPECT_TRUE(isBlackMatching(-4.5));
  EXPECT_TRUE(isBlackMatching(-1e9));
  EXPECT_FALSE(isBlackMatching(1e9));
}

} // namespace
} // namespace dewpoint::tests
