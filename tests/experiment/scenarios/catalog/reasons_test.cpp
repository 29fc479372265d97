// SPDX-License-Identifier: GPL-3.0-or-later
// What method dewpoint says of why a target is not held, in scenarios of the suite.
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/session/run/tracking_run.h"
#include "core/tracking/catalog/method_catalog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

ScenarioRun scenario(const std::string& name, std::uint64_t seed) {
  for (const ScenarioDeclaration& declaration : scenarioCatalog()) {
    if (declaration.name == name) {
      auto run = declaration.make(seed, Grade::Ideal);
      EXPECT_TRUE(run);
      return std::move(*run);
    }
  }
  ADD_FAILURE() << name;
  return {};
}

/// Tracks a scenario and hands out every moment.
void track(const ScenarioRun& run, std::int64_t frames,
           const std::function<void(const TrackedFrame&)>& look) {
  Project project;
  project.method = "dewpoint";
  project.parameters = ParameterValues(methodParameters("dewpoint"));
  const char* axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_TRUE(project.parameters.set(std::string("start_") + axes[axis], run.startCenter[axis]));
    ASSERT_TRUE(
        project.parameters.set(std::string("start_half_") + axes[axis], run.startHalfSize[axis]));
  }
  project.seed = run.seed;
  project.targets = run.targets;
  for (const Camera& camera : run.rig) {
    project.cameras.push_back({camera, SourceKind::Simulation, "", 0});
  }
  auto tracking = TrackingRun::create(project, 1);
  ASSERT_TRUE(tracking);
  std::optional<TrackedFrame> previous;
  for (std::int64_t frame = 0; frame < frames; ++frame) {
    tracking->beginFrame(run.frames(frame));
    tracking->iterateTimed();
    previous = tracking->trackedFrame(10, previous ? &*previous : nullptr);
    look(*previous);
  }
}

/// Trouble of each camera with the first target, by frame.
using Troubles = std::vector<std::vector<CameraStatus>>;
Troubles troublesOf(const ScenarioRun& run, std::int64_t frames) {
  Troubles troubles;
  track(run, frames, [&](const TrackedFrame& moment) {
    std::vector<CameraStatus>& all = troubles.emplace_back();
    for (const CameraReport& report : moment.targets[0].cameraReports) {
      all.push_back(report.status);
    }
  });
  return troubles;
}

std::int64_t eventFrame(const ScenarioRun& run, ScenarioEvent::Kind kind) {
  const auto event = std::ranges::find(run.events, kind, &ScenarioEvent::kind);
  EXPECT_NE(event, run.events.end());
  return event != run.events.end() ? event->frame : 0;
}

TEST(Reasons, ABlindCameraIsTooDarkAndTheOtherHasNoTrouble) {
  const ScenarioRun run = scenario("S3-one-blind", 3);
  const std::int64_t begin = eventFrame(run, ScenarioEvent::Kind::BlackoutBegin);
  const std::int64_t end = eventFrame(run, ScenarioEvent::Kind::BlackoutEnd);
  const int blind = std::ranges::find(run.events, begin, &ScenarioEvent::frame)->camera;
  const Troubles troubles = troublesOf(run, end + 5);
  for (std::int64_t frame = 10; frame < end + 5; ++frame) {
    for (int camera = 0; camera < 2; ++camera) {
      const bool dark = camera == blind && frame >= begin && frame < end;
      EXPECT_EQ(troubles[std::size_t(frame)][std::size_t(camera)],
                dark ? CameraStatus::Dark : CameraStatus::None)
          << "frame " << frame << " camera " << camera;
    }
  }
}

TEST(Reasons, WhenAllAreBlindAllAreTooDark) {
  const ScenarioRun run = scenario("S3-all-blind", 4);
  const std::int64_t begin = eventFrame(run, ScenarioEvent::Kind::BlackoutBegin);
  const Troubles troubles = troublesOf(run, begin + 10);
  for (std::int64_t frame = begin; frame < begin + 10; ++frame) {
    EXPECT_EQ(troubles[std::size_t(frame)],
              (std::vector<CameraStatus>{CameraStatus::Dark, CameraStatus::Dark}));
  }
}

TEST(Reasons, ATargetTakenAwayIsNotHeldAndEveryCameraSaysSo) {
  const ScenarioRun run = scenario("S3-vanish", 5);
  const std::int64_t gone = eventFrame(run, ScenarioEvent::Kind::Vanish);
  const std::int64_t back = eventFrame(run, ScenarioEvent::Kind::Return);
  ASSERT_GT(back, gone + 30); // it stays away for more than a second
  std::vector<TrackedFrame> moments;
  track(run, back, [&](const TrackedFrame& moment) { moments.push_back(moment); });
  EXPECT_EQ(moments[std::size_t(gone) - 1].targets[0].status, TargetStatus::Held);
  const TrackedTarget& late = moments.back().targets[0];
  EXPECT_EQ(late.status, TargetStatus::Lost);
  for (const CameraReport& report : late.cameraReports) {
    EXPECT_NE(report.status, CameraStatus::None);
    EXPECT_NE(report.status, CameraStatus::Dark);
    EXPECT_NE(report.status, CameraStatus::NoImage);
  }
  EXPECT_FALSE(describeUnconfirmedCameras(late.cameraReports, {"left", "right"}).empty());
}

TEST(Reasons, APlateInFrontOfOneCameraHidesAPart) {
  const ScenarioRun run = scenario("S2-moving", 6);
  const Troubles troubles = troublesOf(run, run.frameCount);
  int hidden[2] = {0, 0};
  const std::size_t begin = troubles.size() / 2; // the plate has arrived
  for (std::size_t frame = begin; frame < troubles.size(); ++frame) {
    for (std::size_t camera = 0; camera < 2; ++camera) {
      const CameraStatus trouble = troubles[frame][camera];
      hidden[camera] +=
          trouble == CameraStatus::PartlyHidden || trouble == CameraStatus::Hidden ? 1 : 0;
    }
  }
  const int frames = static_cast<int>(troubles.size() - begin);
  // One camera of the two has the plate before it; the other sees the ball.
  EXPECT_GT(std::max(hidden[0], hidden[1]), frames * 8 / 10);
  EXPECT_LT(std::min(hidden[0], hidden[1]), frames / 10);
}

} // namespace
} // namespace dewpoint::tests
