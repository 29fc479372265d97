// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/state_log.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

FrameRecord record(std::int64_t frame, TargetStatus status, const CameraReport& left = {}) {
  FrameRecord record;
  record.frame = frame;
  record.time = static_cast<double>(frame) / 25.0;
  record.targets.push_back({status, 0.5F, {left, {}}});
  return record;
}

TEST(StateLog, ARowIsWrittenWhenStateOrReasonChange) {
  StateLog log(test::twoCameras());
  const std::vector<Target> targets = test::twoCameraProject().targets;
  log.append(record(0, TargetStatus::Searching), targets);
  log.append(record(1, TargetStatus::Held), targets);
  log.append(record(2, TargetStatus::Held), targets);
  log.append(record(3, TargetStatus::Searching, {CameraStatus::Hidden, 0.0}), targets);
  log.append(record(4, TargetStatus::Searching, {CameraStatus::Hidden, 0.0}), targets);
  log.append(record(5, TargetStatus::Lost, {CameraStatus::Hidden, 0.0}), targets);
  EXPECT_EQ(log.csv(), "time_s,frame,target,state,reason\n"
                       "0.000000,0,ball,searching,\n"
                       "0.040000,1,ball,held,\n"
                       "0.120000,3,ball,searching,camera left: hidden\n"
                       "0.200000,5,ball,lost,camera left: hidden\n");
}

TEST(StateLog, TargetsThatComeLaterHaveRowsOfTheirOwn) {
  StateLog log(test::twoCameras());
  std::vector<Target> targets = test::twoCameraProject().targets;
  log.append(record(0, TargetStatus::Held), targets);
  targets.push_back(targets.front());
  targets.back().name = "second, green";
  FrameRecord both = record(1, TargetStatus::Held);
  both.targets.push_back({TargetStatus::Searching, 0.0F, {}});
  log.append(both, targets);
  EXPECT_NE(log.csv().find("0.040000,1,\"second, green\",searching,\n"), std::string::npos)
      << log.csv();
}

} // namespace
} // namespace dewpoint::tests
