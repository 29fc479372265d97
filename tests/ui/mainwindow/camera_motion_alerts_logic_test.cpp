// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/camera_motion_alerts.h"
#include "ui/widgets/message_bar.h"

#include <QPushButton>
#include <QSignalSpy>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A bar and what a run of two cameras tells it.
class CameraMotionAlertsTest : public testing::Test {
protected:
  /// The second camera was bumped at 10 s.
  TrackSnapshotPtr at(double time, bool solved = false, bool back = false) const {
    auto shown = std::make_shared<TrackSnapshot>();
    TrackSnapshot& snapshot = *shown;
    CameraRig rig(2);
    rig[0].name = "left";
    snapshot.rig = std::make_shared<const CameraRig>(rig);
    auto frames = std::make_shared<FrameSet>();
    frames->time = timeStamp(time);
    snapshot.frames = frames;
    CameraMotionReport report;
    report.event.camera = 1;
    report.event.frame = 300;
    report.event.time = timeStamp(10.0);
    report.isBackInPose = back;
    if (solved) {
      report.newPose.emplace();
    }
    snapshot.cameraMotions = {report};
    return shown;
  }
  QPushButton* answer() const {
    for (auto* button : bar_.findChildren<QPushButton*>()) {
      if (!button->text().isEmpty()) {
        return button;
      }
    }
    return nullptr;
  }

  QWidget window_;
  MessageBar bar_{&window_};
  CameraMotionAlerts messages_{bar_};
};

TEST_F(CameraMotionAlertsTest, APoseThatIsKnownIsOneClickAway) {
  messages_.setSnapshot(at(10.5));
  EXPECT_TRUE(bar_.text().contains(QStringLiteral("camera 2")));
  EXPECT_TRUE(bar_.text().contains(QStringLiteral("being computed")));
  messages_.setSnapshot(at(11.0, true));
  QSignalSpy newPose(&messages_, &CameraMotionAlerts::newPoseRequested);
  ASSERT_NE(answer(), nullptr);
  answer()->click();
  ASSERT_EQ(newPose.size(), 1);
  EXPECT_EQ(newPose.front().front().toInt(), 1);
}

TEST_F(CameraMotionAlertsTest, OfTwoCamerasNeitherIsForgotten) {
  auto both = std::make_shared<TrackSnapshot>(*at(11.0, true));
  CameraMotionReport left = both->cameraMotions.front();
  left.event.camera = 0;
  both->cameraMotions.push_back(left);
  messages_.setSnapshot(both);
  EXPECT_TRUE(bar_.text().contains(QStringLiteral("left")));
  bar_.dismiss();
  EXPECT_TRUE(bar_.text().contains(QStringLiteral("camera 2")));
  messages_.setSnapshot(nullptr); // the run is over: neither question has a use
  EXPECT_FALSE(bar_.isVisibleTo(&window_));
}

TEST_F(CameraMotionAlertsTest, WithoutAPoseCalibrationIsOffered) {
  messages_.setSnapshot(at(13.5));
  QSignalSpy calibrate(&messages_, &CameraMotionAlerts::calibrationRequested);
  ASSERT_NE(answer(), nullptr);
  answer()->click();
  ASSERT_EQ(calibrate.size(), 1);
  EXPECT_EQ(calibrate.front().front().toInt(), 1);
}

TEST_F(CameraMotionAlertsTest, WhoClosesTheBarIsLeftAlone) {
  messages_.setSnapshot(at(11.0, true));
  bar_.dismiss();
  messages_.setSnapshot(at(12.0, true));
  EXPECT_FALSE(bar_.isVisibleTo(&window_));
  messages_.setSnapshot(nullptr); // another run
  messages_.setSnapshot(at(11.0, true));
  EXPECT_TRUE(bar_.isVisibleTo(&window_));
}

TEST_F(CameraMotionAlertsTest, WhatIsDealtWithIsWithdrawnUnlessTheBarSaysSomethingElse) {
  messages_.setSnapshot(at(11.0, true));
  TrackSnapshot without = *at(12.0);
  without.cameraMotions.clear();
  const auto none = std::make_shared<const TrackSnapshot>(without);
  messages_.setSnapshot(none);
  EXPECT_FALSE(bar_.isVisibleTo(&window_));
  messages_.setSnapshot(at(13.0, true));
  bar_.showError(QStringLiteral("The disk is full."));
  messages_.setSnapshot(none);
  EXPECT_EQ(bar_.text(), QStringLiteral("The disk is full."));
}

} // namespace
} // namespace dewpoint::tests
