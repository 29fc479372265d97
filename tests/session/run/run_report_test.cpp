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
  EXPECT_EQ(periods[0].text, sentence(unplugged("left")));
  EXPECT_EQ(periods[0].from, 1.0);
  EXPECT_EQ(periods[0].to, 3.0);
  EXPECT_EQ(periods[1].from, 2.0);
  EXPECT_FALSE(periods[1].to);
  EXPECT_EQ(periods[2].text, periods[0].text); // it came back
  EXPECT_EQ(periods[2].from, 4.0);
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
  EXPECT_EQ(json["notice_log"][0]["notice"], sentence(unplugged("left")));
  EXPECT_EQ(json["notice_log"][0]["from"], 1.5);
  EXPECT_EQ(json["notice_log"][0]["to"], 2.5);
  EXPECT_TRUE(json["notice_log"][1]["to"].is_null());
}

} // namespace
} // namespace dewpoint::tests
