// SPDX-License-Identifier: GPL-3.0-or-later
// The files beside recordings that the accuracy suite and the experiments read, and those that the
// suite itself has written.
#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/clips/clip_sources.h"
#include "core/experiment/suite/skipped_runs.h"
#include "core/experiment/suite/suite_row.h"
#include "tests/fuzz/expectation.h"
#include "tests/fuzz/fuzzed_readers.h"
#include "tests/fuzz/hostile_text.h"
#include "tests/fuzz/input_file.h"

#include <sstream>
#include <string>

namespace dewpoint::tests {
namespace {

template <class Value> void expectPlainUnlessRead(const Result<Value>& read) {
  if (!read) {
    expectPlain(read.error());
  }
}

constexpr const char* kBandCameras = R"({"videos_18h": {
"K_left": [[700, 0, 320], [0, 700, 240], [0, 0, 1]], "dist_left": [0.1, 0, 0, 0, 0],
"K_right": [[700, 0, 320], [0, 700, 240], [0, 0, 1]], "dist_right": [0.1, 0, 0, 0, 0],
"R": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "T_unit": [-1, 0, 0]}})";
constexpr const char* kBandMarks =
    "frame,color,left_u,left_v,right_u,right_v\n0,yellow,320,240,300,240\n"
    "0,blue,330,240,310,240\n0,pink,340,240,320,240\n";

/// What the two clips of wands and boards have beside the table: written once.
struct OtherClipFiles {
  InputFile handCameras{"clips/hand2_desk_cameras.toml"};
  InputFile boardCameras{"clips/charuco4/camera_array.toml"};
  OtherClipFiles() {
    (void)handCameras.hold(corpusText("dewpoint/two.toml"));
    (void)boardCameras.hold(corpusText("caliscope/camera_array.toml"));
  }
};

} // namespace

void fuzzClipTable(std::string_view bytes) {
  static const OtherClipFiles kOthers;
  static const InputFile kHand("clips/hand2_desk.csv");
  static const InputFile kTimes("clips/charuco4/timestamps.csv");
  static const InputFile kCorners("clips/charuco4/CHARUCO_xyz_CHARUCO.csv");
  static const InputFile kBandCalibration("clips/tapes2_limbs/calib_scout.json");
  static const InputFile kBands("clips/tapes2_limbs/tapes_180349_scout.csv");
  const ClipFolders folders{inputFolder() / "clips", inputFolder() / "clips"};
  const std::string_view head = bytes.substr(0, 512); // tells which table it is
  if (head.find("u0") != head.npos) {
    (void)kHand.hold(bytes);
    expectPlainUnlessRead(handClip(folders));
  } else if (head.find("cam_id") != head.npos) {
    (void)kTimes.hold(bytes);
    (void)kCorners.hold("sync_index,keypoint_id,x_coord,y_coord,z_coord\n");
    expectPlainUnlessRead(boardClip(folders));
  } else if (head.find("keypoint_id") != head.npos) {
    (void)kTimes.hold("sync_index,cam_id,frame_time\n0,0,0.1\n0,1,0.1\n0,2,0.1\n0,3,0.1\n");
    (void)kCorners.hold(bytes);
    expectPlainUnlessRead(boardClip(folders));
  } else {
    (void)kBandCalibration.hold(kBandCameras);
    (void)kBands.hold(bytes);
    expectPlainUnlessRead(bandsClip(folders));
  }
}

void fuzzBandCameras(std::string_view bytes) {
  static const InputFile kCalibration("bands/tapes2_limbs/calib_scout.json");
  static const InputFile kMarks("bands/tapes2_limbs/tapes_180349_scout.csv");
  (void)kCalibration.hold(bytes);
  (void)kMarks.hold(kBandMarks);
  expectPlainUnlessRead(bandsClip({inputFolder() / "bands", inputFolder() / "bands"}));
}

void fuzzBoxTruth(std::string_view bytes) {
  // Each file alone: the first one that is broken ends the reading.
  static const InputFile kBoxes("otb-clips/otb/sequence/groundtruth_rect.txt");
  static const InputFile kCenters("juggle-clips/juggle1/gt1.csv");
  static const InputFile kThrows("throw-clips/throws_pinkball/balls_by_color.csv");
  for (const InputFile* file : {&kBoxes, &kCenters, &kThrows}) {
    (void)file->hold(bytes);
  }
  for (const char* folder : {"otb-clips", "juggle-clips", "throw-clips"}) {
    expectPlainUnlessRead(recordedBoxClips(inputFolder() / folder));
  }
}

void fuzzSuiteRows(std::string_view bytes) {
  std::istringstream lines{std::string(bytes)};
  for (std::string line; std::getline(lines, line);) {
    if (const auto row = parseRow(line)) {
      const std::string text = rowText(*row);
      const auto again = parseRow(text);
      // A row that ends in NaN has no last value, which marks an incomplete row.
      expect(!again || rowText(*again) == text, "a row of the suite changes when written again");
    }
    if (const auto trace = parseTrace(line)) {
      const auto again = parseTrace(traceText(*trace));
      expect(again && traceText(*again) == traceText(*trace),
             "a trace of the suite changes when written again");
    }
    if (const auto skipped = parseSkippedRun(line)) {
      const auto again = parseSkippedRun(skippedCsvLine(*skipped));
      expect(again && *again == *skipped, "a skipped run is another one when written again");
    }
  }
}

} // namespace dewpoint::tests
