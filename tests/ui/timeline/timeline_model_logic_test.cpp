// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_model.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

FrameRecord record(std::int64_t frame, TargetStatus status = TargetStatus::Held) {
  FrameRecord record;
  record.frame = frame;
  record.time = static_cast<double>(frame) / 25.0;
  record.targets.resize(1);
  record.targets[0].status = status;
  record.targets[0].existenceProbability = 0.99F;
  return record;
}

TimelineModel modelOf(const std::vector<std::int64_t>& frames) {
  TimelineModel model;
  model.targetNames = {QStringLiteral("ball")};
  model.cameraNames = {QStringLiteral("left"), QStringLiteral("right")};
  std::vector<FrameRecord> records;
  for (const std::int64_t frame : frames) {
    records.push_back(record(frame));
  }
  model.append(records, true);
  return model;
}

TEST(TimelineModel, AFrameThatComesAgainReplacesWhatFollowedIt) {
  TimelineModel model = modelOf({0, 1, 2, 3});
  model.append({record(2, TargetStatus::Lost)}, false);
  ASSERT_EQ(model.records.size(), 3U);
  EXPECT_EQ(model.records.back().targets[0].status, TargetStatus::Lost);
  model.append({record(7)}, true);
  EXPECT_EQ(model.records.size(), 1U);
}

TEST(TimelineModel, SkippedFramesBelongToTheRecordBeforeThem) {
  const TimelineModel model = modelOf({0, 1, 9, 18, 40});
  EXPECT_EQ(model.endFrameOf(1), 9);  // eight skipped: a live camera does that
  EXPECT_EQ(model.endFrameOf(2), 18); // in coarse steps as before
  EXPECT_EQ(model.endFrameOf(3), 19); // 22 frames were never tracked (twice 9 would be 18)
  EXPECT_EQ(model.endFrameOf(4), 41); // the newest
  EXPECT_EQ(model.recordAt(5)->frame, 1);
  EXPECT_EQ(model.recordAt(30), nullptr);
  EXPECT_EQ(model.recordAt(40)->frame, 40);
  EXPECT_EQ(model.recordAt(41), nullptr); // not tracked yet
  EXPECT_EQ(TimelineModel().recordAt(0), nullptr);
}

TEST(TimelineModel, SaysWhichTargetWasCorrectedAndWhere) {
  TimelineModel model = modelOf({0, 1, 2});
  PositionCorrection correction;
  correction.frame = 1;
  model.corrections = {correction};
  EXPECT_TRUE(model.isCorrected(0, 1));
  EXPECT_FALSE(model.isCorrected(1, 1));
  EXPECT_FALSE(model.isCorrected(0, 2));
  EXPECT_TRUE(model.descriptionOf(1).contains(QStringLiteral("corrected")));
  EXPECT_FALSE(model.descriptionOf(2).contains(QStringLiteral("corrected")));
}

TEST(TimelineModel, TheNearestMarkerInEitherDirectionIsTheNextOne) {
  TimelineModel model;
  EXPECT_FALSE(model.nextMarkerFrame(3, 1));
  model.markers = {{3, "a"}, {8, "b"}, {20, "c"}};
  EXPECT_EQ(model.nextMarkerFrame(3, 1), 8);
  EXPECT_EQ(model.nextMarkerFrame(9, -1), 8);
  EXPECT_FALSE(model.nextMarkerFrame(3, -1));
  EXPECT_FALSE(model.nextMarkerFrame(20, 1));
}

TEST(TimelineModel, TheSourceTellsTheRateUntilTimeStampsDo) {
  TimelineModel model;
  model.setSourceFrameRate(0.0); // unknown
  EXPECT_DOUBLE_EQ(model.framesPerSecond, 30.0);
  model.setSourceFrameRate(8.0);
  EXPECT_DOUBLE_EQ(model.secondsOf(300), 37.5);
  model.append({record(0), record(1)}, true);
  EXPECT_DOUBLE_EQ(model.framesPerSecond, 25.0);
  model.setSourceFrameRate(8.0);
  EXPECT_DOUBLE_EQ(model.framesPerSecond, 25.0);
}

TEST(TimelineModel, TheRateIsThatOfTheTimeStamps) {
  TimelineModel model = modelOf({10, 11, 12});
  EXPECT_DOUBLE_EQ(model.framesPerSecond, 25.0);
  EXPECT_DOUBLE_EQ(model.secondsOf(11), 0.44);
  EXPECT_DOUBLE_EQ(model.secondsOf(62), 2.48); // from the newest one on
  EXPECT_DOUBLE_EQ(TimelineModel().secondsOf(60), 2.0);
  EXPECT_EQ(model.frameAtSeconds(0.44), 11);
  EXPECT_EQ(model.frameAtSeconds(0.425), 11); // 10.6: the closest
  EXPECT_EQ(model.frameAtSeconds(2.48), 62);
  EXPECT_EQ(model.frameAtSeconds(0.2), 5); // before the first record
  EXPECT_EQ(TimelineModel().frameAtSeconds(2.0), 60);
}

TEST(TimelineModel, DropoutsAreKnownUntilTheRunBeginsAnew) {
  TimelineModel model = modelOf({0});
  FrameRecord without = record(1);
  without.missingCameraBits = 2; // the second camera
  model.append({without}, false);
  EXPECT_FALSE(model.hasDropouts(0));
  EXPECT_TRUE(model.hasDropouts(1));
  model.append({record(0)}, true);
  EXPECT_FALSE(model.hasDropouts(1));
}

TEST(TimelineModel, AFrameIsDescribedWithTargetAndReason) {
  TimelineModel model = modelOf({0, 1});
  FrameRecord lost = record(2, TargetStatus::Lost);
  lost.targets[0].existenceProbability = 0.1F;
  lost.targets[0].cameraReports = {{CameraStatus::Hidden, 0.0}, {CameraStatus::None, 0.0}};
  model.append({lost}, false);
  EXPECT_EQ(model.descriptionOf(1), QStringLiteral("Frame 2, 0.04 s\nball ● tracking (0.99)"));
  const QString text = model.descriptionOf(2);
  EXPECT_TRUE(text.endsWith(QStringLiteral("lost (0.10) – left: hidden"))) << text.toStdString();
  EXPECT_TRUE(model.descriptionOf(5).endsWith(QStringLiteral("not tracked")));
}

TEST(TimelineModel, AFrameTellsWhichCamerasHadAProblem) {
  TimelineModel model = modelOf({0});
  FrameRecord without = record(1);
  without.cameraProblems = std::make_shared<const std::vector<Error>>(
      std::vector<Error>{{ErrorCode::ConnectionLost, "/dev/video0", "camera 'left'", "unplugged"}});
  model.append({without}, false);
  EXPECT_FALSE(model.descriptionOf(0).contains(QStringLiteral("left")));
  const QString text = model.descriptionOf(1);
  EXPECT_TRUE(text.contains(QStringLiteral("camera 'left'"))) << text.toStdString();
  EXPECT_TRUE(text.contains(QStringLiteral("unplugged"))) << text.toStdString();
}

} // namespace
} // namespace dewpoint::tests
