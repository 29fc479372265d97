// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/codec_check.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(CodecCheck, WhatRecordingsNeedIsWrittenAndReadBack) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "codec-check";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const auto codecs = checkCodecs(folder);
  ASSERT_EQ(codecs.size(), 4U);
  for (const CodecOutcome& codec : codecs) {
    EXPECT_EQ(codec.problem, "") << codec.name;
    EXPECT_FALSE(codec.isNeeded && codec.isMissing) << codec.name;
    if (codec.isLossless) {
      EXPECT_EQ(codec.difference, 0.0) << codec.name;
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(CodecCheck, AFolderThatCannotBeWrittenToIsReported) {
  for (const CodecOutcome& codec : checkCodecs("/proc/nowhere")) {
    EXPECT_TRUE(codec.isMissing || !codec.problem.empty()) << codec.name;
  }
}

} // namespace
} // namespace dewpoint::tests
