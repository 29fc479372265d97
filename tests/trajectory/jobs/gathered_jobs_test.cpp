// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"
#include "core/base/text_file.h"
#include "core/trajectory/jobs/gathered_jobs.h"
#include "core/trajectory/jobs/job_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

/// Output folders of made-up jobs, all in one folder of the test's own.
class GatherTest : public testing::Test {
protected:
  void SetUp() override {
    root_ =
        fs::path(testing::TempDir()) /
        (std::string("gather_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  std::string folder(const std::string& name) const { return (root_ / name).string(); }

  /// A finished job of 10 frames whose trajectory has this text; `valid` frames of target "ball".
  void makeJob(const std::string& name, const JobIdentity& identity, std::int64_t valid = 10,
               const std::string& rows = "rows\n") {
    const auto job = JobFolder::beginJob(folder(name), {"trajectory.csv"});
    ASSERT_TRUE(job);
    ASSERT_TRUE(writeTextFile(root_ / name / "trajectory.csv", rows));
    JobRecord record;
    record.identity = identity;
    record.key = name;
    record.frameCount = 10;
    record.trackingSeconds = 0.5;
    record.targets = {{"ball", valid}};
    ASSERT_TRUE(job->finish(record, {"trajectory.csv"}));
  }

  void evaluateJob(const std::string& name, double rmse, const std::string& rows = "rows\n") {
    Evaluation one;
    one.target = "ball";
    one.rmse = rmse;
    one.p95 = 2.0 * rmse;
    one.fractionInside95Ellipsoid = 0.9;
    one.comparedFrameCount = 9;
    one.convergenceFrameCount = 1;
    ASSERT_TRUE(
        writeTextFile(root_ / name / kEvaluationFile, evaluationFileText({one}, sha256(rows))));
  }

  fs::path root_;
};

JobIdentity identityOf(const std::string& recording, std::uint64_t seed = 1,
                       const std::string& settings = "") {
  return {recording, "track", "dewpoint", seed, settings, "", "1.2.3"};
}

TEST_F(GatherTest, HasOneRowForEachJobAndTarget) {
  makeJob("b", identityOf("b", 10), 7);
  makeJob("a", identityOf("a, first", 2, "particles=50 kld_error=0"));
  evaluateJob("a", 0.001);
  const auto gathered = gatherJobs({folder("b"), folder("a")});
  ASSERT_TRUE(gathered);
  EXPECT_TRUE(gathered->isComplete());
  EXPECT_EQ(
      gatheredTableText(*gathered),
      "recording,command,method,settings,frame_range,seed,target,frames,coverage,frames_compared,"
      "rmse_mm,median_mm,p95_mm,max_mm,rmse_all_mm,inside_95,frames_to_converge,lost_frames,"
      "version\n"
      "\"a, first\",track,dewpoint,particles=50 "
      "kld_error=0,,2,ball,10,1,9,1,0,2,0,0,0.9,1,0,1.2.3\n"
      "b,track,dewpoint,,,10,ball,10,0.7,,,,,,,,,,1.2.3\n");
  EXPECT_EQ(gatheredDurationsText(*gathered),
            "recording,command,method,settings,frame_range,seed,frames,seconds,frames_per_second,"
            "threads\n"
            "\"a, first\",track,dewpoint,particles=50 kld_error=0,,2,10,0.5,20,1\n"
            "b,track,dewpoint,,,10,10,0.5,20,1\n");
}

TEST_F(GatherTest, OrderOfTheFoldersMakesNoDifference) {
  std::vector<std::string> folders;
  for (const std::uint64_t seed : {3U, 20U, 1U}) {
    for (const char* recording : {"b", "a"}) {
      const std::string name = recording + std::to_string(seed);
      makeJob(name, identityOf(recording, seed));
      evaluateJob(name, 0.001 * static_cast<double>(seed));
      folders.push_back(folder(name));
    }
  }
  folders.push_back(folder("missing"));
  const auto first = gatherJobs(folders);
  std::ranges::reverse(folders);
  const auto second = gatherJobs(folders);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(gatheredTableText(*first), gatheredTableText(*second));
  EXPECT_EQ(gatheredReportText(*first), gatheredReportText(*second));
  // Seeds as numbers, not as words.
  ASSERT_EQ(first->jobs.size(), 6u);
  EXPECT_EQ(first->jobs[1].record.identity.seed, 3u);
  EXPECT_EQ(first->jobs[2].record.identity.seed, 20u);
}

TEST_F(GatherTest, EachResultCountsOnce) {
  makeJob("one", identityOf("a"));
  makeJob("two", identityOf("a"));
  evaluateJob("two", 0.001);
  const auto gathered = gatherJobs({folder("one"), folder("two"), folder("one")});
  ASSERT_TRUE(gathered);
  ASSERT_EQ(gathered->jobs.size(), 1u);
  EXPECT_EQ(gathered->jobs.front().folder, folder("two")); // the one that was evaluated
  ASSERT_EQ(gathered->repeatedFolders.size(), 1u);
  EXPECT_EQ(gathered->repeatedFolders.front(), std::make_pair(folder("two"), folder("one")));

  // The same job with another result is an error, whichever comes first.
  makeJob("three", identityOf("a"), 10, "other rows\n");
  for (const auto& folders :
       {std::vector{folder("one"), folder("three")}, std::vector{folder("three"), folder("one")}}) {
    const auto contradiction = gatherJobs(folders);
    ASSERT_FALSE(contradiction);
    EXPECT_EQ(contradiction.error().code, ErrorCode::Mismatch);
    EXPECT_NE((contradiction.error().file + contradiction.error().detail).find("three"),
              std::string::npos);
  }
}

TEST_F(GatherTest, NamesWhatIsMissingOrUnfinished) {
  makeJob("done", identityOf("a"));
  ASSERT_TRUE(JobFolder::beginJob(folder("killed"), {}));
  makeJob("cut", identityOf("b"));
  fs::resize_file(root_ / "cut" / "trajectory.csv", 2);
  const auto gathered =
      gatherJobs({folder("killed"), folder("nowhere"), folder("done"), folder("cut")});
  ASSERT_TRUE(gathered);
  EXPECT_FALSE(gathered->isComplete());
  EXPECT_EQ(gathered->jobs.size(), 1u);
  EXPECT_EQ(gathered->missingFolders, std::vector{folder("nowhere")});
  EXPECT_EQ(gathered->unfinishedFolders, (std::vector{folder("cut"), folder("killed")}));
  const std::string report = gatheredReportText(*gathered);
  EXPECT_NE(report.find("1 runs of 1 recordings; 1 missing, 2 unfinished."), std::string::npos)
      << report;
  EXPECT_NE(report.find("- `" + folder("nowhere") + "`"), std::string::npos) << report;
  EXPECT_NE(report.find("- `" + folder("killed") + "`"), std::string::npos) << report;
}

TEST_F(GatherTest, EvaluationOfAnotherTrajectoryIsAnError) {
  makeJob("one", identityOf("a"));
  evaluateJob("one", 0.001, "rows of yesterday\n");
  const auto gathered = gatherJobs({folder("one")});
  ASSERT_FALSE(gathered);
  EXPECT_EQ(gathered.error().code, ErrorCode::Mismatch);
  ASSERT_TRUE(writeTextFile(root_ / "one" / kEvaluationFile, "{}"));
  const auto empty = gatherJobs({folder("one")});
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(empty.error().field, "trajectory_sha256");
  ASSERT_TRUE(writeTextFile(root_ / "one" / kEvaluationFile, "["));
  EXPECT_EQ(gatherJobs({folder("one")}).error().code, ErrorCode::NotParsed);
}

TEST_F(GatherTest, ReportHasTheMediansOfEachMethodAndTheWorstRuns) {
  // RMSE 1, 2, 9 mm: median 2; coverage 1, 0.4, 0.8: median 0.8.
  const std::vector<std::pair<double, std::int64_t>> runs{{0.001, 10}, {0.002, 4}, {0.009, 8}};
  std::vector<std::string> folders;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const std::string name = "r" + std::to_string(k);
    makeJob(name, identityOf(name), runs[k].second);
    evaluateJob(name, runs[k].first);
    folders.push_back(folder(name));
  }
  const auto gathered = gatherJobs(folders);
  ASSERT_TRUE(gathered);
  const std::string report = gatheredReportText(*gathered);
  EXPECT_NE(
      report.find("| track | dewpoint |  | 1.2.3 | 3 | 3 | 30 | 80.0 % | 2.0 | 4.0 | 90.0 % |"),
      std::string::npos)
      << report;
  const auto least = report.find("## Least coverage");
  const auto largest = report.find("## Largest errors");
  ASSERT_NE(least, std::string::npos);
  ASSERT_NE(largest, std::string::npos);
  EXPECT_LT(report.find("| r1 |", least), report.find("| r2 |", least));
  EXPECT_LT(report.find("| r2 |", largest), report.find("| r1 |", largest));
}

TEST_F(GatherTest, NothingGivesAnEmptyTable) {
  const auto gathered = gatherJobs({});
  ASSERT_TRUE(gathered);
  EXPECT_TRUE(gathered->isComplete());
  EXPECT_EQ(std::ranges::count(gatheredTableText(*gathered), '\n'), 1);
  EXPECT_NE(gatheredReportText(*gathered).find("0 runs of 0 recordings"), std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
