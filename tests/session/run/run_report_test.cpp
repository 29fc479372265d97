// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/run_report.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dewpoint::tests {
namespace {

Error unplugged(const char* camera) {
  return {ErrorCode::ConnectionLost, "", camera, "unplugged"};
}

TEST(NoticeLog, EachCauseHasItsPeriods) {
  NoticeLog log;
  log.update({unplugged("left")}, 1.0);
  log.update({unplugged("left"), unplugged("right"), unplugged("right")}, 2.0);
  log.update({unplugged("right")}, 3.0);
  log.update({unplugged("left"), unplugged("right")}, 4.0);
  const auto& periods = log.periods();
  ASSERT_EQ(periods.size(), 3U);
  EXPECT_EQ(periods[0].text, errorSentence(unplugged("left")));
  EXPECT_EQ(periods[0].startSeconds, 1.0);
  EXPECT_EQ(periods[0].endSeconds, 3.0);
  EXPECT_EQ(periods[1].startSeconds, 2.0);
  EXPECT_FALSE(periods[1].endSeconds);
  EXPECT_EQ(periods[2].text, periods[0].text); // it came back
  EXPECT_EQ(periods[2].startSeconds, 4.0);
}

TEST(NoticeLog, ACauseThatFlickersFillsNoMemory) {
  NoticeLog log;
  for (std::size_t k = 0; k < 3 * NoticeLog::kMaxPeriods; ++k) {
    log.update({unplugged("left")}, static_cast<double>(k));
    log.update({}, static_cast<double>(k));
  }
  EXPECT_EQ(log.periods().size(), NoticeLog::kMaxPeriods);
}

TEST(RunReport, NoticesHaveTheirTimes) {
  RunStatistics figures;
  figures.noticeLog.update({unplugged("left")}, 1.5);
  figures.noticeLog.update({}, 2.5);
  figures.noticeLog.update({unplugged("right")}, 3.5);
  const auto json = nlohmann::json::parse(runReport(Project(), figures));
  ASSERT_EQ(json["notice_log"].size(), 2U);
  EXPECT_EQ(json["notice_log"][0]["notice"], errorSentence(unplugged("left")));
  EXPECT_EQ(json["notice_log"][0]["from"], 1.5);
  EXPECT_EQ(json["notice_log"][0]["to"], 2.5);
  EXPECT_TRUE(json["notice_log"][1]["to"].is_null());
}

TEST(RunReport, LiveRunsHaveTheirLatencies) {
  RunStatistics figures;
  EXPECT_FALSE(nlohmann::json::parse(runReport(Project(), figures)).contains("live_milliseconds"));
  const LatencyStages::Clock::time_point light(std::chrono::seconds(9));
  const auto after = [&](int milliseconds) {
    return light + std::chrono::milliseconds(milliseconds);
  };
  Frame frame;
  frame.origin = TimeOrigin::Sender;
  frame.instants = {light, after(40), after(44)};
  FrameSet set;
  set.frames = {std::make_shared<const Frame>(frame)};
  figures.liveLatency.addFrames(set, after(50), after(51));
  const auto json = nlohmann::json::parse(runReport(Project(), figures))["live_milliseconds"];
  EXPECT_EQ(json["images"]["sender"], 1);
  EXPECT_NEAR(json["capture"]["p50"].get<double>(), 40.0, 0.3);
  EXPECT_NEAR(json["decode"]["p99"].get<double>(), 4.0, 0.03);
  EXPECT_NEAR(json["wait"]["p50"].get<double>(), 6.0, 0.04);
  EXPECT_NEAR(json["compute"]["p50"].get<double>(), 1.0, 0.01);
  EXPECT_NEAR(json["light_to_estimate"]["p99"].get<double>(), 51.0, 0.4);
  EXPECT_FALSE(json.contains("draw")); // nothing was drawn
}

} // namespace
} // namespace dewpoint::tests
