// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/jobs/gathered_jobs.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/input_file.h"

#include <string>

namespace dewpoint::tests {
namespace {

/// A finished job whose only file is empty.
constexpr const char* kRecord = R"({"recording": "day 1", "command": "track", "method": "dewpoint",
"seed": 7, "settings": "", "frame_range": "", "version": "0.1.0", "key": "k", "frames": 60,
"seconds": 1.5, "threads": 1, "targets": [{"name": "ball", "valid_frames": 58}],
"files": [{"name": "trajectory.csv", "bytes": 0, "sha256": "abc"}]})";

void gatherFolder(const std::string& folder) {
  const auto gathered = trajectory::gatherJobs({folder});
  if (!gathered) {
    expectPlain(gathered.error());
    return;
  }
  (void)trajectory::gatheredTableText(*gathered);
  (void)trajectory::gatheredDurationsText(*gathered);
  (void)trajectory::gatheredReportText(*gathered);
}

} // namespace

void fuzzJobRecord(std::string_view bytes) {
  static const InputFile kResult("job/trajectory.csv");
  static const InputFile kFile("job/done.json");
  const auto record = trajectory::readJobRecord(kFile.hold(bytes));
  if (!record) {
    expectPlain(record.error());
    return;
  }
  gatherFolder(kFile.path().parent_path());
  const auto again = trajectory::readJobRecord(kFile.hold(trajectory::jobRecordText(*record)));
  if (!again) {
    expectPlain(again.error());
  }
  expect(again && *again == *record, "the record of a job is another one when written again");
}

void fuzzEvaluation(std::string_view bytes) {
  static const InputFile kResult("evaluated/trajectory.csv");
  static const InputFile kDone("evaluated/done.json");
  static const InputFile kFile("evaluated/evaluation.json");
  (void)kDone.hold(kRecord);
  gatherFolder(kFile.hold(bytes).parent_path());
}

} // namespace dewpoint::tests
