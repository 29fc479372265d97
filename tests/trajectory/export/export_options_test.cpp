// SPDX-License-Identifier: GPL-3.0-or-later
// What a person chooses, and what is refused.
#include "core/trajectory/export/export_catalog.h"
#include "core/trajectory/export/path_interpolation.h"
#include "tests/trajectory/export_examples.h"

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

Result<ExportTable> tableOf(const ExportOptions& options,
                            const Trajectory& trajectory = exportExample()) {
  return makeExportTable(trajectory, options, {});
}

TEST(ExportOptions, ChooseTargetsAndSpan) {
  ExportOptions options;
  options.targets = {"cap, red"};
  options.rangeBegin = RangeBound{0.1, false};
  options.rangeEnd = RangeBound{2.0, true};
  const auto table = tableOf(options);
  ASSERT_TRUE(table) << errorSentence(table.error());
  EXPECT_EQ(table->targets, std::vector<std::string>{"cap, red"});
  EXPECT_EQ(table->frames, (std::vector<std::int64_t>{1, 2}));
}

TEST(ExportOptions, GapsAreLeftOrFilledAndMarked) {
  ExportOptions options;
  options.targets = {"ball"};
  auto table = tableOf(options);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->gapCount(), 1U);
  EXPECT_FALSE(table->cells[0][2].hasPosition);
  options.gapRule = GapRule::Fill;
  table = tableOf(options);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->gapCount(), 0U);
  const ExportCell& cell = table->cells[0][2];
  EXPECT_TRUE(cell.isFilled);
  EXPECT_FALSE(cell.covariance) << "nobody knows how far it is off";
  EXPECT_NEAR(cell.position.x(), 0.2, 1e-12);
  EXPECT_NEAR(cell.position.z(), 5.0, 1e-12) << "1 + t² is a parabola";
  EXPECT_FALSE(table->cells[0][1].isFilled);
  options.maxFilledGapSeconds = 0.15; // the gap's neighbors are 0.2 s apart
  EXPECT_EQ(tableOf(options)->gapCount(), 1U);
}

TEST(ExportOptions, ResamplesAlongTheCubic) {
  Trajectory trajectory;
  const auto position = [](double t) { return Eigen::Vector3d(t, 0.0, 3.0 * t - 4.905 * t * t); };
  for (std::int64_t frame = 0; frame < 11; ++frame) {
    trajectory.samples.push_back(
        exportSample(frame, "ball", position(static_cast<double>(frame) / 10.0)));
  }
  ExportOptions options;
  options.rowsPerSecond = 25.0;
  const auto table = tableOf(options, trajectory);
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rowCount(), 26U);
  EXPECT_EQ(table->rowsPerSecond, 25.0);
  for (std::size_t row = 0; row < 26; ++row) {
    EXPECT_NEAR(table->times[row], 0.04 * static_cast<double>(row), 1e-12);
    // A ball in flight: the parabola is met exactly.
    EXPECT_LT((table->cells[0][row].position - position(table->times[row])).norm(), 1e-12);
    EXPECT_TRUE(table->cells[0][row].covariance);
    EXPECT_FALSE(table->cells[0][row].isFilled);
  }
}

TEST(ExportOptions, ResamplingLeavesGaps) {
  ExportOptions options;
  options.targets = {"ball"};
  options.rowsPerSecond = 20.0;
  const auto table = tableOf(options);
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rowCount(), 7U); // 0, 0.05, ... 0.3 s
  const std::vector<bool> expected{true, true, true, false, false, false, true};
  for (std::size_t row = 0; row < 7; ++row) {
    EXPECT_EQ(table->cells[0][row].hasPosition, expected[row]) << row;
  }
}

TEST(ExportOptions, InterpolatesWithoutNeighborsAlongTheChord) {
  const TimedPosition a{1.0, {0, 0, 0}};
  const TimedPosition b{3.0, {2, 4, 6}};
  EXPECT_LT((interpolatedPosition({}, a, b, {}, 1.5) - Eigen::Vector3d(0.5, 1.0, 1.5)).norm(),
            1e-15);
}

TEST(ExportOptions, UnitsAndAxesTurnTheCovarianceToo) {
  ExportOptions options;
  options.axes = WorldAxes::YUp;
  options.unit = LengthUnit::Millimeter;
  const auto table = tableOf(options);
  ASSERT_TRUE(table);
  const ExportCell& cell = table->cells[0][1]; // (0.1, 0.25, 2)
  EXPECT_LT((cell.position - Eigen::Vector3d(250, 2000, 100)).norm(), 1e-9);
  ASSERT_TRUE(cell.covariance);
  EXPECT_LT((cell.covariance->diagonal() - Eigen::Vector3d(4, 9, 1)).norm(), 1e-12);
  EXPECT_NEAR((*cell.covariance)(0, 2), 0.5, 1e-12);
}

TEST(ExportOptions, ChoosesAndNamesFormats) {
  for (const ExportFormat& format : exportFormats()) {
    EXPECT_EQ((*findExportFormat(format.id))->title, format.title);
    const auto preview = previewExport(exportExample(), exportAs(std::string(format.id)), "a");
    ASSERT_TRUE(preview) << format.id;
    EXPECT_NE(preview->unitsSentence.find("right-handed"), std::string::npos);
    EXPECT_NE(preview->sizeSentence.find("2 targets, 4 rows at 10 per second, 1 positions unknown"),
              std::string::npos)
        << preview->sizeSentence;
    EXPECT_GT(preview->text.size(), 40U) << preview->text;
  }
}

TEST(ExportOptions, PreviewsCountTheLinesOfNotes) {
  Trajectory trajectory = exportExample();
  trajectory.header.entries = {{"method", "dewpoint"}, {"seed", "7"}};
  const auto noteLineCount = [&](const char* format, bool header) {
    ExportOptions options = exportAs(format);
    options.writesHeader = header;
    const auto preview = previewExport(trajectory, options, "a");
    EXPECT_TRUE(preview) << format;
    return preview ? preview->noteLineCount : std::size_t{99};
  };
  const std::size_t inCsv = noteLineCount("csv", true);
  EXPECT_GE(inCsv, 4U); // title, units, and two entries
  EXPECT_EQ(noteLineCount("csv", false), 0U);
  EXPECT_EQ(noteLineCount("tum", true), inCsv + 2U); // the target, and the names of the columns
  EXPECT_EQ(noteLineCount("trc", true), 0U);
  EXPECT_EQ(noteLineCount("npz", true), 0U); // no text
}

TEST(ExportRefuses, WhatCannotBeWritten) {
  const ExportFolder folder;
  const auto wrong = [&](const ExportOptions& options, const std::string& name = "a.csv",
                         const Trajectory& trajectory = exportExample()) {
    const auto summary = exportTrajectory(trajectory, options, folder / name);
    EXPECT_FALSE(summary);
    return summary ? Error() : summary.error();
  };
  EXPECT_EQ(wrong(exportAs("doc")).code, ErrorCode::NotFound);
  ExportOptions options;
  options.targets = {"dog"};
  EXPECT_NE(errorSentence(wrong(options)).find("ball, cap, red"), std::string::npos);
  options = {};
  options.rangeBegin = RangeBound{99.0, false};
  EXPECT_EQ(wrong(options).field, "span");
  options = {};
  options.rowsPerSecond = 1e12;
  EXPECT_EQ(wrong(options).field, "rate");
  EXPECT_EQ(wrong({}, "a.csv", {}).field, "span");
  Trajectory trajectory = exportExample();
  trajectory.samples[2].position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(wrong({}, "a.csv", trajectory).field, "target ball, frame 1");
  trajectory.samples[2].time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(wrong({}, "a.csv", trajectory).field, "time_s");
  EXPECT_EQ(wrong({}, "no/folder.csv").code, ErrorCode::FileUnwritable);
  EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

TEST(ExportRefuses, AFileThatCannotBeReplacedAndKeepsIt) {
  const ExportFolder folder;
  std::ofstream(folder / "a.csv") << "old";
  std::filesystem::create_directory(folder / "a.csv.part"); // takes the place beside
  EXPECT_FALSE(exportTrajectory(exportExample(), exportAs("csv"), folder / "a.csv"));
  EXPECT_EQ(bytesOf(folder / "a.csv"), "old");
}

TEST(ExportProgress, CanCancel) {
  const ExportFolder folder;
  const auto summary = exportTrajectory(exportExample(), exportAs("pvd"), folder / "a.pvd",
                                        [](double done) { return done < 0.8; });
  ASSERT_TRUE(summary);
  EXPECT_TRUE(summary->isCanceled);
  EXPECT_TRUE(std::filesystem::is_empty(folder / ".")); // neither a.pvd nor frames beside it
}

// The older collection still names its parts: they must not be those of another run.
TEST(ExportProgress, CancelingLeavesAnOlderExportWhole) {
  const ExportFolder folder;
  ASSERT_TRUE(exportTrajectory(exportExample(), exportAs("pvd"), folder / "a.pvd"));
  const std::string old = bytesOf(folder / "a-frames/00000.vtp");
  Trajectory other = exportExample();
  other.samples.front().position.x() += 1.0;
  const auto summary = exportTrajectory(other, exportAs("pvd"), folder / "a.pvd",
                                        [](double done) { return done < 0.8; });
  ASSERT_TRUE(summary);
  EXPECT_TRUE(summary->isCanceled);
  EXPECT_EQ(bytesOf(folder / "a-frames/00000.vtp"), old);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / ".")) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

TEST(ExportReplaces, OnlyWhatItMay) {
  const ExportFolder folder;
  std::filesystem::create_directory(folder / "a-frames");
  std::ofstream(folder / "a-frames/00001.vtp") << "old";
  ExportOptions options = exportAs("pvd");
  options.replacesExisting = false;
  const auto asked = exportTrajectory(exportExample(), options, folder / "a.pvd");
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->existingFile, folder / "a-frames/00001.vtp");
  EXPECT_EQ(bytesOf(folder / "a-frames/00001.vtp"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder / "a-frames/00000.vtp"));
  options.replacesExisting = true;
  const auto done = exportTrajectory(exportExample(), options, folder / "a.pvd");
  ASSERT_TRUE(done);
  EXPECT_TRUE(done->existingFile.empty());
  EXPECT_NE(bytesOf(folder / "a-frames/00001.vtp"), "old");
}

} // namespace
} // namespace dewpoint::tests
