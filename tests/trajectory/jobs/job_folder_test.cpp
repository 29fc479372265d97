// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"
#include "core/base/text_file.h"
#include "core/trajectory/jobs/job_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

fs::path emptyJobFolder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("job_folder_" + name);
  fs::remove_all(folder);
  return folder;
}

JobRecord recordWithKey(const std::string& key) {
  JobRecord record;
  record.identity = {"day 1", "track", "dewpoint", 7, "particles=200", "0:60", "1.2.3"};
  record.key = key;
  record.frameCount = 60;
  record.trackingSeconds = 1.5;
  record.targets = {{"ball", 58}};
  return record;
}

TEST(JobRecord, ReadsWhatItWrote) {
  const fs::path folder = emptyJobFolder("record");
  fs::create_directories(folder);
  JobRecord record = recordWithKey("k");
  record.threadCount = 2;
  record.files = {{"trajectory.csv", 12, "abc"}};
  ASSERT_TRUE(writeTextFile(folder / kDoneFile, jobRecordText(record)));
  EXPECT_EQ(readJobRecord(folder / kDoneFile), record);

  for (const char* name : {"../trajectory.csv", "/etc/passwd", "..", ""}) {
    record.files.front().name = name;
    ASSERT_TRUE(writeTextFile(folder / kDoneFile, jobRecordText(record)));
    const auto read = readJobRecord(folder / kDoneFile);
    ASSERT_FALSE(read) << name;
    EXPECT_EQ(read.error().field, "files") << name;
  }
  for (const char* text : {"", "{", "[]"}) {
    ASSERT_TRUE(writeTextFile(folder / kDoneFile, text));
    const auto read = readJobRecord(folder / kDoneFile);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().code, ErrorCode::NotParsed) << text;
  }
}

TEST(JobRecord, RefusesNumbersThatDoNotFit) {
  const fs::path folder = emptyJobFolder("numbers");
  fs::create_directories(folder);
  JobRecord record = recordWithKey("k");
  record.files = {{"trajectory.csv", 12, "abc"}};
  const std::string text = jobRecordText(record);
  struct Change {
    const char* before;
    const char* after;
    ErrorCode code;
    const char* field;
  };
  for (const Change& change :
       {Change{"\"seed\": 7", "\"seed\": -7", ErrorCode::BadValue, "seed"},
        Change{"\"seed\": 7", "\"sed\": 7", ErrorCode::MissingKey, "seed"},
        Change{"\"frames\": 60", "\"frames\": 1e300", ErrorCode::WrongType, "frames"},
        Change{"\"frames\": 60", "\"frames\": 10000000001", ErrorCode::BadValue, "frames"},
        Change{"\"threads\": 1", "\"threads\": 4294967297", ErrorCode::BadValue, "threads"},
        Change{"\"valid_frames\": 58", "\"valid_frames\": \"58\"", ErrorCode::WrongType,
               "targets.valid_frames"},
        Change{"\"bytes\": 12", "\"bytes\": -12", ErrorCode::BadValue, "files.bytes"},
        Change{"\"seconds\": 1.5", "\"seconds\": null", ErrorCode::WrongType, "seconds"}}) {
    std::string changed = text;
    const std::size_t at = changed.find(change.before);
    ASSERT_NE(at, std::string::npos) << change.before;
    changed.replace(at, std::string(change.before).size(), change.after);
    ASSERT_TRUE(writeTextFile(folder / kDoneFile, changed));
    const auto read = readJobRecord(folder / kDoneFile);
    ASSERT_FALSE(read) << change.after;
    EXPECT_EQ(read.error().code, change.code) << change.after;
    EXPECT_EQ(read.error().field, change.field) << change.after;
    EXPECT_EQ(read.error().file, (folder / kDoneFile).string());
  }
}

TEST(JobRecord, HasAnUpperLimitForItsSizeAndForTheNumberOfItsTargets) {
  const fs::path folder = emptyJobFolder("limits");
  fs::create_directories(folder);
  JobRecord record = recordWithKey("k");
  ASSERT_TRUE(writeTextFile(folder / kDoneFile, std::string(5U << 20U, ' ')));
  EXPECT_EQ(readJobRecord(folder / kDoneFile).error().code, ErrorCode::FileUnreadable);
  record.targets.resize(10'001);
  ASSERT_TRUE(writeTextFile(folder / kDoneFile, jobRecordText(record)));
  const auto read = readJobRecord(folder / kDoneFile);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::BadValue);
  EXPECT_EQ(read.error().field, "targets");
}

TEST(JobRecord, IsWrittenForANameThatIsNotUtf8) {
  JobRecord record = recordWithKey("k");
  record.identity.recordingName = "day \xFF";
  const fs::path folder = emptyJobFolder("bytes");
  fs::create_directories(folder);
  ASSERT_TRUE(writeTextFile(folder / kDoneFile, jobRecordText(record)));
  EXPECT_TRUE(readJobRecord(folder / kDoneFile));
}

TEST(JobFolder, IsDoneOnlyAfterTheEnd) {
  const fs::path folder = emptyJobFolder("done");
  const auto job = JobFolder::beginJob(folder, {"trajectory.csv"});
  ASSERT_TRUE(job);
  EXPECT_TRUE(fs::exists(folder / kUnfinishedFile));
  ASSERT_TRUE(writeTextFile(folder / "trajectory.csv", "rows\n"));
  EXPECT_FALSE(JobFolder::readFinishedRecord(folder, "k"));

  ASSERT_TRUE(job->finish(recordWithKey("k"), {"trajectory.csv"}));
  EXPECT_FALSE(fs::exists(folder / kUnfinishedFile));
  const auto done = JobFolder::readFinishedRecord(folder, "k");
  ASSERT_TRUE(done);
  EXPECT_EQ(done->files, (std::vector<JobFile>{{"trajectory.csv", 5, sha256("rows\n")}}));
  EXPECT_FALSE(JobFolder::readFinishedRecord(folder, "other"));
  EXPECT_FALSE(JobFolder::readFinishedRecord(folder, ""));

  // A file that is not as it was written: not done.
  ASSERT_TRUE(writeTextFile(folder / "trajectory.csv", "ro"));
  EXPECT_FALSE(JobFolder::readFinishedRecord(folder, "k"));
  fs::remove(folder / "trajectory.csv");
  EXPECT_FALSE(JobFolder::readFinishedRecord(folder, "k"));
}

TEST(JobFolder, NextJobTakesAwayWhatTheFormerLeftAndNothingElse) {
  const fs::path folder = emptyJobFolder("again");
  const auto first = JobFolder::beginJob(folder, {"trajectory.csv", "reasons.csv"});
  ASSERT_TRUE(first);
  for (const char* name : {"trajectory.csv", "reasons.csv", "truth.csv"}) {
    ASSERT_TRUE(writeTextFile(folder / name, name));
  }
  ASSERT_TRUE(first->finish(recordWithKey("k"), {"trajectory.csv", "reasons.csv"}));
  ASSERT_TRUE(writeTextFile(folder / kEvaluationFile, "{}"));
  // Somebody has put a file of their own in place of one of the job's.
  ASSERT_TRUE(writeTextFile(folder / "reasons.csv", "notes of a person"));

  ASSERT_TRUE(JobFolder::beginJob(folder, {"boxes.csv"}));
  EXPECT_FALSE(fs::exists(folder / kDoneFile));
  EXPECT_FALSE(fs::exists(folder / kEvaluationFile));
  EXPECT_FALSE(fs::exists(folder / "trajectory.csv"));
  EXPECT_TRUE(fs::exists(folder / "reasons.csv"));
  EXPECT_TRUE(fs::exists(folder / "truth.csv")); // of the user
}

TEST(JobFolder, OnlyTheLastOfTwoThatRunAtOnceFinishes) {
  const fs::path folder = emptyJobFolder("two");
  const auto stray = JobFolder::beginJob(folder, {"trajectory.csv"});
  ASSERT_TRUE(stray);
  std::ofstream open(folder / "trajectory.csv");
  const auto last = JobFolder::beginJob(folder, {"trajectory.csv"});
  ASSERT_TRUE(last);
  ASSERT_TRUE(writeTextFile(folder / "trajectory.csv", "of the last\n"));
  open << "of the stray one\n";
  open.close();
  const auto refused = stray->finish(recordWithKey("k"), {"trajectory.csv"});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::FileUnwritable);
  EXPECT_FALSE(fs::exists(folder / kDoneFile));
  ASSERT_TRUE(last->finish(recordWithKey("k"), {"trajectory.csv"}));
  EXPECT_EQ(readTextFile(folder / "trajectory.csv"), "of the last\n");
}

TEST(JobFolder, FolderThatCannotBeMadeIsAnError) {
  const fs::path file = emptyJobFolder("file");
  ASSERT_TRUE(writeTextFile(file, ""));
  const auto begun = JobFolder::beginJob(file / "run", {});
  ASSERT_FALSE(begun);
  EXPECT_EQ(begun.error().code, ErrorCode::FileUnwritable);
  fs::remove(file);
}

TEST(JobKey, ChangesWithWhatTheResultDependsOn) {
  const fs::path folder = emptyJobFolder("key");
  fs::create_directories(folder / "images");
  ASSERT_TRUE(writeTextFile(folder / "times.csv", "1\n"));
  ASSERT_TRUE(writeTextFile(folder / "video.mkv", std::string(2000000, 'v')));
  ASSERT_TRUE(writeTextFile(folder / "images" / "1.png", "a"));
  ASSERT_TRUE(writeTextFile(folder / "images" / "2.png", "b"));
  const auto key = [&](const std::string& description = "seed 1") {
    return *jobKey(description, {{"times.csv", folder / "times.csv"},
                                 {"video.mkv", folder / "video.mkv"},
                                 {"images", folder / "images"}});
  };
  const auto later = [](const fs::path& file) {
    fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(5));
  };
  const std::string before = key();
  EXPECT_EQ(before.size(), 64u);
  EXPECT_EQ(key(), before);
  EXPECT_NE(key("seed 2"), before);
  later(folder / "times.csv"); // small: its content counts
  EXPECT_EQ(key(), before);
  later(folder / "video.mkv");
  const std::string touched = key();
  EXPECT_NE(touched, before);
  ASSERT_TRUE(writeTextFile(folder / "times.csv", "2\n"));
  const std::string rewritten = key();
  EXPECT_NE(rewritten, touched);
  later(folder / "images" / "2.png");
  const std::string image = key();
  EXPECT_NE(image, rewritten);
  ASSERT_TRUE(writeTextFile(folder / "images" / "3.png", "c"));
  EXPECT_NE(key(), image);

  const auto missing = jobKey("seed 1", {{"none.mkv", folder / "none.mkv"}});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::FileMissing);
}

} // namespace
} // namespace dewpoint::tests
