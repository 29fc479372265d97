// SPDX-License-Identifier: GPL-3.0-or-later
// Delays of cameras, estimated from a ball that moves at about 1 m/s in a rendered room, in which
// everything else is wrong as well.
#include "core/base/thread_team.h"
#include "core/experiment/scenarios/grade.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/dewpoint/dewpoint_tracker.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

/// The estimated delays after `frames` frames of the run.
std::vector<ClockEstimate> estimatedClocks(const ScenarioRun& run, std::int64_t frames) {
  ParameterValues parameters(methodParameters("dewpoint"));
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    EXPECT_TRUE(parameters.set("start_" + name, run.startCenter[axis]));
    EXPECT_TRUE(parameters.set("start_half_" + name, run.startHalfSize[axis]));
  }
  DewpointTracker tracker(parameters, run.rig, run.targets);
  tracker.restart(run.seed);
  ThreadTeam team(1);
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    tracker.beginFrame(run.frames(frame));
    tracker.iterate(team);
  }
  return tracker.clockEstimates();
}

TEST(UnknownDelays, AreFoundWithinTwoMilliseconds) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const ScenarioRun run = scenarioRun("S7-unknown", seed, Grade::Room);
    const std::vector<ClockEstimate> clocks = estimatedClocks(run, run.frameCount);
    ASSERT_EQ(clocks.size(), run.delaysAtEnd.size());
    for (std::size_t camera = 1; camera < clocks.size(); ++camera) {
      const double truth = run.delaysAtEnd[camera] - run.delaysAtEnd[0];
      EXPECT_NEAR(clocks[camera].delay, truth, 2e-3)
          << "seed " << seed << ", camera " << camera << ", said " << clocks[camera].delaySigma;
    }
  }
}

} // namespace
} // namespace dewpoint::tests
