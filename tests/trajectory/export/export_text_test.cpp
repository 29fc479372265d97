// SPDX-License-Identifier: GPL-3.0-or-later
// The text formats against files written by hand from their descriptions.
#include "core/trajectory/export/export_catalog.h"
#include "core/trajectory/trajectory_reader.h"
#include "tests/trajectory/export_examples.h"

#include <nlohmann/json.hpp>

#include <clocale>

namespace dewpoint::tests {
namespace {

TEST(ExportText, TidyCsvAsWrittenByHand) {
  ExportOptions options = exportAs("csv");
  options.targets = {"ball"};
  // Standard deviations 1, 2, 3 mm of the variances 1, 4, 9 mm².
  const std::string rest = ",0.001,0.002,0.003,1e-06,5e-07,0,4e-06,0,9e-06,2,120,1,0\n";
  EXPECT_EQ(exported(exportExample(), options, "a.csv"),
            "# dewpoint trajectory\n"
            "# Lengths in m, times in s, covariances in m^2; Z points up, axes as in the project; "
            "right-handed.\n"
            "# version: 9.9\n# seed: 7\n# estimates: live\n"
            "time_s,frame,target,x_m,y_m,z_m,sx_m,sy_m,sz_m,cov_xx_m2,cov_xy_m2,cov_xz_m2,"
            "cov_yy_m2,cov_yz_m2,cov_zz_m2,cameras,ess,valid,filled\n"
            "0,0,ball,0,0.25,1" +
                rest + "0.1,1,ball,0.1,0.25,2" + rest + "0.2,2,ball,,,,,,,,,,,,,0,,0,0\n" +
                "0.3,3,ball,0.3,0.25,10" + rest);
}

/// The example, with a particle of highest weight 10 mm along X from the ball at frame 1.
Trajectory exampleWithBest() {
  Trajectory trajectory = exportExample();
  trajectory.samples[2].bestParticle = Eigen::Vector3d(0.11, 0.25, 2.0);
  return trajectory;
}

TEST(ExportText, TheParticleOfHighestWeightGoesAlong) {
  ExportOptions options = exportAs("csv");
  options.targets = {"ball"};
  options.unit = LengthUnit::Millimeter;
  const std::string csv = exported(exampleWithBest(), options, "a.csv");
  EXPECT_NE(csv.find(",valid,filled,best_x_mm,best_y_mm,best_z_mm\n"), std::string::npos);
  EXPECT_NE(csv.find(",2,120,1,0,110,250,2000\n"), std::string::npos); // frame 1
  EXPECT_NE(csv.find(",2,120,1,0,,,\n"), std::string::npos);           // frames 0 and 3
  EXPECT_NE(csv.find(",,0,0,,,\n"), std::string::npos);                // frame 2: a gap
  ExportOptions json = exportAs("jsonl");
  json.axes = WorldAxes::YUp; // (x, y, z) becomes (y, z, x)
  const std::string lines = exported(exampleWithBest(), json, "a.jsonl");
  EXPECT_NE(lines.find("\"best\":[0.25,2,0.11]"), std::string::npos);
  EXPECT_EQ(lines.find("\"best\"", lines.find("\"best\"") + 1), std::string::npos); // no other
  const std::string lines3d = exported(exampleWithBest(), exportAs("vtp"), "a.vtp");
  EXPECT_NE(lines3d.find("Name=\"best\" NumberOfComponents=\"3\""), std::string::npos);
  // Between recorded frames, and after smoothing, there are no particles.
  ExportOptions smooth = exportAs("csv");
  smooth.usesSmoothedEstimates = true;
  EXPECT_EQ(exported(exampleWithBest(), smooth, "a.csv").find("best_x"), std::string::npos);
}

TEST(ExportText, WhatWasCorrectedIsMarked) {
  Trajectory trajectory = exportExample();
  trajectory.samples[2].isCorrected = true; // the ball at frame 1
  trajectory.samples[4].isCorrected = true; // at frame 2, which is a gap
  ExportOptions options = exportAs("csv");
  options.targets = {"ball"};
  const std::string csv = exported(trajectory, options, "a.csv");
  EXPECT_NE(csv.find(",valid,filled,corrected\n"), std::string::npos);
  EXPECT_NE(csv.find("0.1,1,ball,0.1,0.25,2,0.001,0.002,0.003,1e-06,5e-07,0,4e-06,0,9e-06,2,120,1,"
                     "0,1\n"),
            std::string::npos);
  EXPECT_NE(csv.find(",2,120,1,0,0\n"), std::string::npos);
  EXPECT_NE(csv.find(",,0,0,0\n"), std::string::npos);
  const std::string lines = exported(trajectory, exportAs("jsonl"), "a.jsonl");
  EXPECT_NE(lines.find(",\"corrected\":true}"), std::string::npos);
  EXPECT_EQ(lines.find("corrected", lines.find("corrected") + 1), std::string::npos); // no other
  EXPECT_NE(exported(trajectory, exportAs("vtp"), "a.vtp").find("Name=\"corrected\""),
            std::string::npos);
  EXPECT_NE(exported(trajectory, exportAs("npz"), "a.npz").find("corrected.npy"),
            std::string::npos);
  EXPECT_EQ(exported(exportExample(), options, "a.csv").find("corrected"), std::string::npos);
  options.usesSmoothedEstimates = true; // the marks stay
  EXPECT_NE(exported(trajectory, options, "a.csv").find(",corrected\n"), std::string::npos);
}

TEST(ExportText, WhatIsAmbiguousIsMarked) {
  Trajectory trajectory = exportExample();
  trajectory.samples[2].isAmbiguous = true; // the ball at frame 1
  trajectory.samples[4].isAmbiguous = true; // at frame 2, which is a gap
  ExportOptions options = exportAs("csv");
  options.targets = {"ball"};
  const std::string csv = exported(trajectory, options, "a.csv");
  EXPECT_NE(csv.find(",valid,filled,ambiguous\n"), std::string::npos);
  EXPECT_NE(csv.find(",2,120,1,0,1\n"), std::string::npos); // frame 1
  EXPECT_NE(csv.find(",2,120,1,0,0\n"), std::string::npos); // frames 0 and 3
  EXPECT_NE(csv.find(",,0,0,0\n"), std::string::npos);      // frame 2: a gap
  const std::string lines = exported(trajectory, exportAs("jsonl"), "a.jsonl");
  EXPECT_NE(lines.find(",\"ambiguous\":true}"), std::string::npos);
  EXPECT_EQ(lines.find("ambiguous", lines.find("ambiguous") + 1), std::string::npos); // no other
  EXPECT_NE(exported(trajectory, exportAs("vtp"), "a.vtp").find("Name=\"ambiguous\""),
            std::string::npos);
  EXPECT_NE(exported(trajectory, exportAs("npz"), "a.npz").find("ambiguous.npy"),
            std::string::npos);
  EXPECT_EQ(exported(exportExample(), options, "a.csv").find("ambiguous"), std::string::npos);
  options.usesSmoothedEstimates = true; // the marks stay
  EXPECT_NE(exported(trajectory, options, "a.csv").find(",ambiguous\n"), std::string::npos);
}

TEST(ExportText, TheExtentOfWhatIsNoBallIsWritten) {
  Trajectory trajectory = exportExample();
  trajectory.samples[2].extent = Eigen::Vector3d(4e-4, 9e-4, 1e-4).asDiagonal(); // frame 1
  ExportOptions options = exportAs("csv");
  options.targets = {"ball"};
  options.unit = LengthUnit::Millimeter;
  const std::string csv = exported(trajectory, options, "a.csv");
  EXPECT_NE(csv.find(",valid,filled,extent_xx_mm2,extent_xy_mm2,extent_xz_mm2,extent_yy_mm2,"
                     "extent_yz_mm2,extent_zz_mm2\n"),
            std::string::npos);
  EXPECT_NE(csv.find(",2,120,1,0,400,0,0,900,0,100\n"), std::string::npos); // frame 1
  EXPECT_NE(csv.find(",2,120,1,0,,,,,,\n"), std::string::npos);             // frames 0 and 3
  ExportOptions json = exportAs("jsonl");
  json.axes = WorldAxes::YUp; // (x, y, z) becomes (y, z, x)
  EXPECT_NE(exported(trajectory, json, "a.jsonl")
                .find("\"extent\":[[0.0009,0,0],[0,0.0001,0],[0,0,0.0004]]"),
            std::string::npos);
  EXPECT_NE(exported(trajectory, exportAs("vtp"), "a.vtp").find("Name=\"extent\""),
            std::string::npos);
  EXPECT_NE(exported(trajectory, exportAs("npz"), "a.npz").find("extent.npy"), std::string::npos);
  EXPECT_EQ(exported(exportExample(), options, "a.csv").find("extent"), std::string::npos);
}

TEST(ExportText, TidyCsvIsReadByOurOwnReader) {
  const ExportFolder folder;
  ExportOptions options = exportAs("csv");
  options.targets = {"cap, red"};
  ASSERT_TRUE(exportTrajectory(exportExample(), options, folder / "a.csv"));
  const auto read = readExportSource(folder / "a.csv");
  ASSERT_TRUE(read) << errorSentence(read.error());
  ASSERT_EQ(read->samples.size(), 4U);
  EXPECT_EQ(read->samples[0].target, "cap, red");
  EXPECT_EQ(read->samples[3].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(read->samples[3].covariance, exportExample().samples[1].covariance);
}

TEST(ExportText, GapsAreReadByOurOwnReader) {
  const ExportFolder folder;
  ASSERT_TRUE(exportTrajectory(exportExample(), exportAs("csv"), folder / "a.csv"));
  const auto read = readExportSource(folder / "a.csv");
  ASSERT_TRUE(read) << errorSentence(read.error());
  EXPECT_FALSE(read->samples[4].isValid);
  EXPECT_FALSE(read->samples[4].position.allFinite());
}

TEST(ExportText, ACsvWithoutNotesBeginsWithItsColumnsAndIsReadTheSame) {
  const ExportFolder folder;
  ExportOptions options = exportAs("csv");
  ASSERT_TRUE(exportTrajectory(exportExample(), options, folder / "with.csv"));
  options.writesHeader = false;
  ASSERT_TRUE(exportTrajectory(exportExample(), options, folder / "without.csv"));
  EXPECT_TRUE(bytesOf(folder / "with.csv").starts_with("# dewpoint trajectory\n"));
  EXPECT_TRUE(bytesOf(folder / "without.csv").starts_with("time_s,frame,target,x_m,"));
  const auto with = readTrajectory(folder / "with.csv");
  const auto without = readTrajectory(folder / "without.csv");
  ASSERT_TRUE(with) << errorSentence(with.error());
  ASSERT_TRUE(without) << errorSentence(without.error());
  ASSERT_EQ(with->samples.size(), 8U);
  ASSERT_EQ(without->samples.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(with->samples[k].frame, without->samples[k].frame);
    EXPECT_EQ(with->samples[k].target, without->samples[k].target);
    EXPECT_EQ(with->samples[k].isValid, without->samples[k].isValid);
    if (with->samples[k].isValid) {
      EXPECT_EQ(with->samples[k].position, without->samples[k].position);
      EXPECT_EQ(with->samples[k].covariance, without->samples[k].covariance);
    }
  }
}

TEST(ExportText, OnlyFormatsWithoutAPlaceForNotesHaveNone) {
  const auto text = [](const ExportFormat& format, bool notes) {
    const ExportFolder folder;
    ExportOptions options = exportAs(std::string(format.id));
    options.writesHeader = notes;
    const auto written = exportTrajectory(exportExample(), options, folder / "a");
    return written ? bytesOf(written->files.front()) : errorSentence(written.error());
  };
  for (const ExportFormat& format : exportFormats()) {
    EXPECT_EQ(text(format, true) != text(format, false), format.hasNotes) << format.id;
  }
}

TEST(ExportText, WideCsvAsWrittenByHand) {
  ExportOptions options = exportAs("csv-wide");
  options.writesHeader = false;
  options.unit = LengthUnit::Millimeter;
  EXPECT_EQ(exported(exportExample(), options, "a.csv"),
            "time_s,frame,ball_x_mm,ball_y_mm,ball_z_mm,\"cap, red_x_mm\",\"cap, red_y_mm\","
            "\"cap, red_z_mm\"\n"
            "0,0,0,250,1000,1000,2000,3000\n"
            "0.1,1,100,250,2000,1000,2000,3000\n"
            "0.2,2,,,,1000,2000,3000\n"
            "0.3,3,300,250,10000,1000,2000,3000\n");
}

TEST(ExportText, TumAsWrittenByHand) {
  ExportOptions options = exportAs("tum");
  options.writesHeader = false;
  options.targets = {"ball"};
  EXPECT_EQ(exported(exportExample(), options, "a.tum"), "0.000000 0 0.25 1 0 0 0 1\n"
                                                         "0.100000 0.1 0.25 2 0 0 0 1\n"
                                                         "0.300000 0.3 0.25 10 0 0 0 1\n");
}

TEST(ExportText, TumHasOneFilePerTarget) {
  const ExportFolder folder;
  const auto summary = exportTrajectory(exportExample(), exportAs("tum"), folder / "run.tum");
  ASSERT_TRUE(summary);
  ASSERT_EQ(summary->files.size(), 2U);
  EXPECT_EQ(summary->files[0], folder / "run-ball.tum");
  EXPECT_EQ(summary->files[1], folder / "run-cap,_red.tum");
  const std::string text = bytesOf(summary->files[1]);
  EXPECT_NE(text.find("# target: cap, red\n# timestamp tx ty tz qx qy qz qw\n"), std::string::npos);
  EXPECT_NE(text.find("\n0.300000 1 2 3 0 0 0 1\n"), std::string::npos);
}

TEST(ExportText, TrcAsWrittenByHand) {
  // The layout of OpenSim's files; Y up: its (x, y, z) is our (y, z, x).
  EXPECT_EQ(exported(exportExample(), exportAs("trc"), "walk.trc"),
            "PathFileType\t4\t(X/Y/Z)\twalk.trc\n"
            "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\t"
            "OrigDataStartFrame\tOrigNumFrames\n"
            "10\t10\t4\t2\tm\t10\t1\t4\n"
            "Frame#\tTime\tball\t\t\tcap, red\t\t\n"
            "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
            "\n"
            "1\t0\t0.25\t1\t0\t2\t3\t1\n"
            "2\t0.1\t0.25\t2\t0.1\t2\t3\t1\n"
            "3\t0.2\t\t\t\t2\t3\t1\n"
            "4\t0.3\t0.25\t10\t0.3\t2\t3\t1\n");
}

TEST(ExportText, TrcHasEvenRowsWhereFramesWereDropped) {
  Trajectory trajectory = exportExample();
  // Frame 1 of both never came.
  trajectory.samples.erase(trajectory.samples.begin() + 2, trajectory.samples.begin() + 4);
  for (std::int64_t frame = 4; frame < 9; ++frame) {
    trajectory.samples.push_back(exportSample(frame, "ball", {1, 1, 1}));
  }
  const std::string text = exported(trajectory, exportAs("trc"), "a.trc");
  EXPECT_NE(text.find("\n10\t10\t9\t2\tm\t10\t1\t9\n"), std::string::npos);
  EXPECT_NE(text.find("\n2\t0.1\t\t\t\t\t\t\n"), std::string::npos);
  ExportOptions twice = exportAs("trc"); // what was recorded stays said
  twice.rowsPerSecond = 20.0;
  EXPECT_NE(exported(trajectory, twice, "a.trc").find("\n20\t20\t17\t2\tm\t10\t1\t9\n"),
            std::string::npos);
}

TEST(ExportText, JsonLinesAreReadByAnotherParser) {
  ExportOptions options = exportAs("jsonl");
  options.axes = WorldAxes::YUp;
  std::istringstream lines(exported(exportExample(), options, "a.jsonl"));
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  const auto header = nlohmann::json::parse(line);
  EXPECT_EQ(header.at("seed"), "7");
  EXPECT_NE(header.at("units").get<std::string>().find("Y points up"), std::string::npos);
  std::vector<nlohmann::json> rows;
  while (std::getline(lines, line)) {
    rows.push_back(nlohmann::json::parse(line));
  }
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[1].at("t"), 0.1);
  EXPECT_EQ(rows[1].at("targets").size(), 2U);
  EXPECT_EQ(rows[1].at("targets")[0].at("id"), "ball");
  EXPECT_EQ(rows[1].at("targets")[0].at("xyz"), nlohmann::json({0.25, 2.0, 0.1}));
  // Variances of y, z, x; the covariance of x and y is now that of the third and the first axis.
  EXPECT_EQ(rows[1].at("targets")[0].at("cov"),
            nlohmann::json({{4e-6, 0.0, 5e-7}, {0.0, 9e-6, 0.0}, {5e-7, 0.0, 1e-6}}));
  ASSERT_EQ(rows[2].at("targets").size(), 1U);
  EXPECT_EQ(rows[2].at("targets")[0].at("id"), "cap, red");
}

TEST(ExportText, IsTheSameInALocaleWithDecimalCommas) {
  const std::string before = exported(exportExample(), exportAs("csv"), "a.csv");
  if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
    GTEST_SKIP() << "no German locale";
  }
  EXPECT_EQ(exported(exportExample(), exportAs("csv"), "a.csv"), before);
  std::setlocale(LC_ALL, "C");
}

} // namespace
} // namespace dewpoint::tests
