// SPDX-License-Identifier: GPL-3.0-or-later
// What the status bar shows of a target that is not tracked, and of one that is.
#include "core/session/snapshot/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/mainwindow/status_bar_panel.h"
#include "ui/widgets/elided_label.h"

#include <QLabel>
#include <gtest/gtest.h>

#include <memory>

namespace dewpoint::tests {
namespace {

TrackSnapshot ofOneTarget() {
  TrackSnapshot snapshot;
  CameraRig rig(2);
  rig[0].name = "left";
  rig[1].name = "right";
  snapshot.rig = std::make_shared<const CameraRig>(rig);
  snapshot.family = methodFamily("dewpoint");
  snapshot.frame = 0;
  snapshot.isTracked = true;
  snapshot.targets.emplace_back().target.name = "ball";
  return snapshot;
}

class StatusBarPanelTest : public ::testing::Test {
protected:
  StatusBarPanelTest() { panel_.resize(1600, 30); }
  void show(const TrackSnapshot& snapshot) {
    panel_.setSnapshot(std::make_shared<const TrackSnapshot>(snapshot));
  }
  bool isShown(const char* name) const {
    return !panel_.findChild<QLabel*>(QLatin1String(name))->isHidden();
  }

  StatusBarPanel panel_;
};

TEST_F(StatusBarPanelTest, AReasonHasTheRoomOfUnknownValues) {
  TrackSnapshot snapshot = ofOneTarget();
  TargetSnapshot& target = snapshot.targets.front();
  target.status = TargetStatus::Searching;
  target.cameraReports = {{CameraStatus::Unclear, 0.0}, {CameraStatus::Unclear, 0.0}};
  show(snapshot);
  const auto* reason =
      static_cast<ElidedLabel*>(panel_.findChild<QLabel*>(QStringLiteral("statusReason")));
  EXPECT_EQ(reason->fullText(), QStringLiteral("left, right: right color, wrong shape"));
  for (const char* name : {"statusPosition", "statusSpread", "statusSpeed"}) {
    EXPECT_FALSE(isShown(name)) << name;
  }
  EXPECT_TRUE(isShown("statusFrame"));
  // Without a reason, values keep their places while they are unknown.
  target.status = TargetStatus::Held;
  target.cameraReports.clear();
  auto& sphere = std::get<SphereEstimate>(target.estimate);
  sphere.particleCount = 100;
  sphere.isValid = true;
  show(snapshot);
  for (const char* name : {"statusPosition", "statusSpread", "statusSpeed"}) {
    EXPECT_TRUE(isShown(name)) << name;
  }
}

TEST_F(StatusBarPanelTest, TheRateIsThatOfNewFrames) {
  TrackSnapshot snapshot = ofOneTarget();
  const auto rate = [this] {
    return panel_.findChild<QLabel*>(QStringLiteral("statusRate"))->text();
  };
  snapshot.state = PlayState::Playing;
  snapshot.framesPerSecond = 30.0;
  show(snapshot);
  EXPECT_EQ(rate(), QStringLiteral("30.0 fps"));
  snapshot.isPast = true; // shown again
  show(snapshot);
  EXPECT_TRUE(rate().isEmpty());
  snapshot.isPast = false;
  snapshot.framesPerSecond = 0.0; // not known yet
  show(snapshot);
  EXPECT_TRUE(rate().isEmpty());
}

} // namespace
} // namespace dewpoint::tests
