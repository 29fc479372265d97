// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/result_settings.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

namespace dewpoint::tests {
namespace {

RunDefinition ballDefinition() {
  Project project;
  project.parameters = ParameterValues(methodParameters(project.method));
  project.targets.push_back({"ball", 0.03, ColorRange{}});
  return RunDefinition::fromProject(project);
}

RunDefinitionPtr with(const std::function<void(RunDefinition&)>& change) {
  RunDefinition changed = ballDefinition();
  change(changed);
  return std::make_shared<const RunDefinition>(std::move(changed));
}

RunDefinitionPtr particles(double count) {
  return with([count](RunDefinition& changed) {
    EXPECT_TRUE(changed.parameters.set("particles", count).has_value());
  });
}

using Ranges = std::vector<ResultRange>;

TEST(ResultSettings, WhatDecidesResults) {
  const auto now = with([](RunDefinition&) {});
  const auto isSame = [&](const std::function<void(RunDefinition&)>& change) {
    return giveSameResults(*with(change), *now);
  };
  EXPECT_TRUE(isSame([](RunDefinition&) {}));
  EXPECT_TRUE(isSame([](RunDefinition& other) { other.targets[0].name = "apple"; }));
  EXPECT_TRUE(isSame([](RunDefinition& other) { other.targets[0].samples.resize(1); }));
  EXPECT_TRUE(isSame([](RunDefinition& other) { other.targets[0].isShown = false; }));
  EXPECT_TRUE(isSame([](RunDefinition& other) { other.corrections.resize(1); }));
  EXPECT_TRUE(isSame([](RunDefinition& other) { other.personCorrections.resize(1); }));
  EXPECT_TRUE(isSame([](RunDefinition& other) { other.parameters.markAllAsGiven(); }));
  EXPECT_FALSE(isSame([](RunDefinition& other) { other.targets[0].radius = 0.04; }));
  EXPECT_FALSE(isSame([](RunDefinition& other) { other.targets.clear(); }));
  EXPECT_FALSE(isSame([](RunDefinition& other) { other.seed = 7; }));
  EXPECT_FALSE(isSame([](RunDefinition& other) { other.method = "barrera"; }));
  EXPECT_FALSE(isSame([](RunDefinition& other) { other.volumeOfInterest = WorldBox{}; }));
  EXPECT_FALSE(isSame([](RunDefinition& other) {
    EXPECT_TRUE(other.parameters.set("particles", 1234).has_value());
  }));
}

TEST(ResultSettings, FramesOfEarlierSettings) {
  ResultSettings settings;
  EXPECT_EQ(settings.newestFrame(), -1);
  const auto before = particles(300);
  const auto after = particles(400);
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    settings.recordTrackedFrame(frame, frame < 6 ? before : after);
  }
  EXPECT_EQ(settings.newestFrame(), 9);
  EXPECT_EQ(settings.framesDifferingFrom(*after), (Ranges{{0, 5}}));
  EXPECT_EQ(settings.framesDifferingFrom(*before), (Ranges{{6, 9}})); // undone
  EXPECT_EQ(settings.framesDifferingFrom(*particles(500)), (Ranges{{0, 9}}));
}

TEST(ResultSettings, TrackedAgain) {
  ResultSettings settings;
  const auto before = particles(300);
  const auto after = particles(400);
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    settings.recordTrackedFrame(frame, before);
  }
  settings.goBack(4);
  EXPECT_EQ(settings.newestFrame(), 3);
  for (std::int64_t frame = 4; frame < 8; ++frame) {
    settings.recordTrackedFrame(frame, after);
  }
  settings.recordTrackedFrame(7, after); // another iteration on it
  EXPECT_EQ(settings.framesDifferingFrom(*after), (Ranges{{0, 3}}));
  settings.goBack(0);
  EXPECT_EQ(settings.newestFrame(), -1);
  EXPECT_EQ(settings.framesDifferingFrom(*after), Ranges{});
}

TEST(ResultSettings, FramesThatWereNeverTracked) {
  ResultSettings settings;
  const auto before = particles(300);
  settings.recordTrackedFrame(0, before);
  settings.recordTrackedFrame(50, before); // the run went on from there
  settings.recordTrackedFrame(51, before);
  EXPECT_EQ(settings.framesDifferingFrom(*particles(400)), (Ranges{{0, 0}, {50, 51}}));
  settings.clear();
  EXPECT_EQ(settings.newestFrame(), -1);
}

} // namespace
} // namespace dewpoint::tests
