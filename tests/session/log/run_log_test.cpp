// SPDX-License-Identifier: GPL-3.0-or-later
// What the record of a run says after a target got another name.
#include "core/session/log/run_log.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

Project namedTargets(const std::vector<std::string>& names) {
  Project project;
  for (const std::string& name : names) {
    project.targets.emplace_back().name = name;
  }
  return project;
}

/// A log of two frames, in which the targets have these names.
void fill(RunLog& log, const std::vector<std::string>& names) {
  log.restart(namedTargets(names));
  for (int frame = 1; frame <= 2; ++frame) {
    std::vector<TrajectorySample> samples(names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
      samples[k].frame = frame;
      samples[k].target = names[k];
    }
    log.append(samples);
  }
}

std::vector<std::string> namesIn(const RunLog& log) {
  std::vector<std::string> names;
  for (const TrajectorySample& sample : log.trajectory().samples) {
    names.push_back(sample.target);
  }
  return names;
}

TEST(RunLog, ANewNameCountsForAllFrames) {
  RunLog log;
  fill(log, {"target 1", "target 2"});
  std::uint64_t generation = 0;
  std::size_t position = 0;
  log.samplesSince(generation, position);
  log.updateProject(namedTargets({"pink", "target 2"}));
  EXPECT_EQ(namesIn(log), (std::vector<std::string>{"pink", "target 2", "pink", "target 2"}));
  const auto again = log.samplesSince(generation, position);
  EXPECT_TRUE(again.restarted);
  EXPECT_EQ(again.records.size(), 4U);
}

TEST(RunLog, ExchangedNamesAreExchanged) {
  RunLog log;
  fill(log, {"left", "right"});
  log.updateProject(namedTargets({"right", "left"}));
  EXPECT_EQ(namesIn(log), (std::vector<std::string>{"right", "left", "right", "left"}));
}

TEST(RunLog, AnotherTargetLeavesTheNamesOfEarlierFrames) {
  RunLog log;
  fill(log, {"ball"});
  Project other = namedTargets({"hand"});
  other.targets[0].radius = 0.08;
  std::uint64_t generation = 0;
  std::size_t position = 0;
  log.samplesSince(generation, position);
  log.updateProject(other);
  EXPECT_EQ(namesIn(log), (std::vector<std::string>{"ball", "ball"}));
  EXPECT_FALSE(log.samplesSince(generation, position).restarted);
}

} // namespace
} // namespace dewpoint::tests
