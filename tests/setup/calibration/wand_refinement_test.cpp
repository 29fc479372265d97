// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_refinement.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// Cameras that were said to be off by 0.12 m at most, and are known to so many meters now.
WandRefinement refinedTo(double cameras95) {
  WandRefinement refinement;
  refinement.options.initialPositionError = 0.12;
  refinement.accuracy->cameras95 = cameras95;
  return refinement;
}

TEST(WandRefinement, LessAccurateThanBeforeSaysTooLittle) {
  EXPECT_FALSE(isInaccurate(refinedTo(0.003)));
  EXPECT_FALSE(isInaccurate(refinedTo(0.12))); // as well known as before
  EXPECT_TRUE(isInaccurate(refinedTo(0.13)));
}

TEST(WandRefinement, WithoutAnAssessmentNothingIsSaidAgainstIt) {
  WandRefinement refinement = refinedTo(0.13);
  refinement.accuracy = failure(ErrorCode::Undetermined, "", "accuracy", "");
  EXPECT_FALSE(isInaccurate(refinement));
  EXPECT_FALSE(isDoubtful(refinement));
}

TEST(WandRefinement, AFaultOrTooLittleMakesItDoubtful) {
  EXPECT_FALSE(isDoubtful(refinedTo(0.003)));
  EXPECT_TRUE(isDoubtful(refinedTo(0.13)));
  WandRefinement faulty = refinedTo(0.003);
  faulty.result.faults = {{.fault = CalibrationFault::CamerasSwapped, .cameras = {0, 1}}};
  EXPECT_FALSE(isInaccurate(faulty));
  EXPECT_TRUE(isDoubtful(faulty));
}

} // namespace
} // namespace dewpoint::tests
