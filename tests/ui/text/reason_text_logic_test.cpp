// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/camera_names.h"
#include "ui/text/reason_text.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace dewpoint::tests {
namespace {

std::string text(CameraStatus trouble, double pixels = 0.0) {
  return cameraReasonText({trouble, pixels}).toStdString();
}

TEST(ReasonText, EveryTroubleHasItsText) {
  std::set<std::string> all;
  for (int k = static_cast<int>(CameraStatus::None) + 1;
       k <= static_cast<int>(CameraStatus::Unclear); ++k) {
    const std::string words = text(static_cast<CameraStatus>(k), 3.0);
    EXPECT_FALSE(words.empty()) << k;
    EXPECT_TRUE(all.insert(words).second) << words;
  }
  EXPECT_EQ(text(CameraStatus::None), "");
}

TEST(ReasonText, PixelsAreRoundedAndNeverZero) {
  EXPECT_EQ(text(CameraStatus::Distractor, 2.6), "3 px away from a distractor");
  EXPECT_EQ(text(CameraStatus::Distractor, 0.9), "at a distractor");
  EXPECT_EQ(text(CameraStatus::Elsewhere, 0.2), "color found 1 px away");
}

TEST(ReasonText, AnImageSaysThatTheTargetIsHiddenInIt) {
  EXPECT_EQ(cameraReasonTextInImage({CameraStatus::Hidden, 0.0}).toStdString(), "hidden here");
  EXPECT_EQ(cameraReasonTextInImage({CameraStatus::OutOfView, 0.0}).toStdString(),
            "not in this image");
  EXPECT_EQ(cameraReasonTextInImage({CameraStatus::Dark, 0.0}).toStdString(), "too dark");
  EXPECT_EQ(cameraBlindText({CameraStatus::Hidden, 0.0}).toStdString(), "◌ hidden here");
  EXPECT_TRUE(isCameraBlind({CameraStatus::OutOfView, 0.0}));
  EXPECT_FALSE(isCameraBlind({CameraStatus::PartlyHidden, 0.0}));
  EXPECT_FALSE(isCameraBlind({CameraStatus::None, 0.0}));
}

TEST(ReasonText, OnlyCamerasInTroubleAreNamed) {
  const std::vector<CameraReport> reports{
      {CameraStatus::Hidden, 0.0}, {CameraStatus::None, 0.0}, {CameraStatus::Dark, 0.0}};
  EXPECT_EQ(reasonText(reports, {"left", "middle", "right"}).toStdString(),
            "left: hidden · right: too dark");
  EXPECT_TRUE(reasonText({{CameraStatus::None, 0.0}}, {"left"}).isEmpty());
}

TEST(ReasonText, CamerasWithTheSameTroubleShareItsWords) {
  const std::vector<CameraReport> reports{
      {CameraStatus::Unclear, 0.0}, {CameraStatus::Hidden, 0.0}, {CameraStatus::Unclear, 0.0}};
  EXPECT_EQ(reasonText(reports, {"left", "middle", "right"}).toStdString(),
            "left, right: right color, wrong shape · middle: hidden");
}

TEST(ReasonText, ACameraWithoutANameHasItsNumber) {
  CameraRig rig(2);
  rig[0].name = "left";
  EXPECT_EQ(cameraNames(rig), (QStringList{"left", "camera 2"}));
  EXPECT_EQ(cameraName(rig, 4), QStringLiteral("camera 5"));
  TrackSnapshot snapshot;
  EXPECT_TRUE(cameraNames(snapshot).isEmpty());
  snapshot.rig = std::make_shared<const CameraRig>(rig);
  EXPECT_EQ(cameraNames(snapshot), cameraNames(rig));
}

} // namespace
} // namespace dewpoint::tests
