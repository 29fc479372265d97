// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/camera_agreement_alerts.h"
#include "ui/text/camera_agreement_text.h"
#include "ui/widgets/message_bar.h"

#include <QPushButton>
#include <QSignalSpy>
#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

CameraDisagreement swapped() {
  return {.fault = CameraFault::Swapped, .cameras = {0, 1}};
}

CameraDisagreement unit() {
  return {.fault = CameraFault::Unit, .metersPerUnit = 0.001};
}

CameraDisagreement samePose() {
  return {.fault = CameraFault::SamePose, .cameras = {0, 1}};
}

/// A bar and what a run of two cameras tells it.
class CameraAgreementAlertsTest : public testing::Test {
protected:
  static TrackSnapshotPtr with(std::vector<CameraDisagreement> found) {
    auto snapshot = std::make_shared<TrackSnapshot>();
    CameraRig rig(2);
    rig[0].name = "left";
    snapshot->rig = std::make_shared<const CameraRig>(rig);
    snapshot->disagreements = std::move(found);
    return snapshot;
  }
  std::vector<QPushButton*> answers() const {
    std::vector<QPushButton*> found;
    for (auto* button : bar_.findChildren<QPushButton*>()) {
      if (!button->text().isEmpty() && button->isVisibleTo(&bar_)) {
        found.push_back(button);
      }
    }
    return found;
  }
  bool isShown() const { return bar_.isVisibleTo(&window_); }

  QWidget window_;
  MessageBar bar_{&window_};
  CameraAgreementAlerts alerts_{bar_};
};

TEST_F(CameraAgreementAlertsTest, TheReasonIsShownWithWhatMendsIt) {
  alerts_.setSnapshot(with({swapped()}));
  EXPECT_EQ(bar_.text(), QStringLiteral("left and camera 2 seem to be swapped."));
  ASSERT_EQ(answers().size(), 1U);
  EXPECT_EQ(answers()[0]->text(), QStringLiteral("Swap left and camera 2"));
  int mended = 0;
  QObject::connect(&alerts_, &CameraAgreementAlerts::rigCorrectionRequested, &bar_,
                   [&](const CameraDisagreement& found, std::size_t choice) {
                     EXPECT_TRUE(found.isSameAs(swapped()));
                     EXPECT_EQ(choice, 0U);
                     ++mended;
                   });
  answers()[0]->click();
  EXPECT_EQ(mended, 1);
}

TEST_F(CameraAgreementAlertsTest, OfTwoCamerasEitherCanBeRotated) {
  CameraDisagreement rotated{.fault = CameraFault::Rotated, .cameras = {0, 1}};
  rotated.rotationCorrections = {Eigen::Vector3d(2.0 * kDegree, 0.0, 0.0),
                                 Eigen::Vector3d(0.0, 0.03, 0.0)};
  alerts_.setSnapshot(with({rotated}));
  EXPECT_EQ(
      bar_.text(),
      QStringLiteral("left or camera 2 points at least 2.0° away from its calibrated direction."));
  ASSERT_EQ(answers().size(), 2U);
  EXPECT_EQ(answers()[1]->text(), QStringLiteral("Correct direction of camera 2"));
}

TEST_F(CameraAgreementAlertsTest, WhatOnlyACalibrationMendsOffersThat) {
  alerts_.setSnapshot(with({samePose()}));
  QSignalSpy calibrate(&alerts_, &CameraAgreementAlerts::calibrationRequested);
  ASSERT_EQ(answers().size(), 2U);
  answers()[1]->click();
  ASSERT_EQ(calibrate.size(), 1);
  EXPECT_EQ(calibrate.front().front().toInt(), 1);
}

TEST_F(CameraAgreementAlertsTest, OneReasonIsShownAfterTheOther) {
  alerts_.setSnapshot(with({unit(), samePose()}));
  EXPECT_EQ(bar_.text(),
            QStringLiteral("The calibration seems to be in millimeters instead of meters."));
  alerts_.setSnapshot(with({unit(), samePose()}));
  EXPECT_EQ(bar_.text(),
            QStringLiteral("The calibration seems to be in millimeters instead of meters."));
  alerts_.setSnapshot(with({samePose()})); // mended
  EXPECT_EQ(bar_.text(), QStringLiteral("left and camera 2 have the same pose."));
  alerts_.setSnapshot(with({}));
  EXPECT_FALSE(isShown());
}

TEST_F(CameraAgreementAlertsTest, WhoClosesTheBarIsLeftAlone) {
  alerts_.setSnapshot(with({swapped()}));
  bar_.dismiss();
  alerts_.setSnapshot(with({swapped()}));
  EXPECT_FALSE(isShown());
  alerts_.setSnapshot(nullptr); // another run
  alerts_.setSnapshot(with({swapped()}));
  EXPECT_TRUE(isShown());
}

TEST_F(CameraAgreementAlertsTest, WhoCalibratesIsLeftAlone) {
  alerts_.setSuppressed(true);
  alerts_.setSnapshot(with({swapped()}));
  EXPECT_FALSE(isShown());
  alerts_.setSuppressed(false);
  alerts_.setSnapshot(with({swapped()}));
  EXPECT_TRUE(isShown());
}

TEST_F(CameraAgreementAlertsTest, ADelayIsSaidInSeconds) {
  const QStringList names{QStringLiteral("left"), QStringLiteral("right")};
  CameraDisagreement late{.fault = CameraFault::Late, .cameras = {1}, .delay = 0.198};
  EXPECT_EQ(disagreementText(late, names),
            QStringLiteral("The images of right are about 0.20 s late."));
  EXPECT_EQ(rigCorrectionText(late, 0, names), QStringLiteral("Set the delay of right"));
  late.delay = -0.1;
  EXPECT_EQ(disagreementText(late, names),
            QStringLiteral("The images of right are about 0.10 s early."));
}

} // namespace
} // namespace dewpoint::tests
