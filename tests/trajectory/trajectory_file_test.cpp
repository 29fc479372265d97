// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/trajectory_reader.h"
#include "core/trajectory/trajectory_writer.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace dewpoint::tests {
namespace {

std::filesystem::path temporary(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) /
         ("dewpoint_" + std::to_string(::getpid()) + "_" + name);
}

std::string contents(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

Result<Trajectory> readText(const std::string& text) {
  const auto path = temporary("text.csv");
  std::ofstream(path) << text;
  auto result = readTrajectory(path);
  std::filesystem::remove(path);
  return result;
}

TrajectorySample sample() {
  TrajectorySample s;
  s.time = 1.0 / 3.0; // needs all 17 digits
  s.frame = 10;
  s.target = "ball, \"red\"";
  s.position = {0.1, -2.5e-7, 3.0};
  s.covariance << 1e-6, 2e-7, 3e-7, 2e-7, 4e-6, 5e-7, 3e-7, 5e-7, 6e-6;
  s.effectiveSampleSize = 123.5;
  s.cameraCount = 2;
  s.isValid = false;
  return s;
}

TEST(TrajectoryFile, ReadsBackExactlyWhatWasWritten) {
  const auto path = temporary("round.csv");
  TrajectoryHeader header;
  header.entries = {{"method", "barrera"}, {"note", "two\nlines: one"}};
  header.cameras = {{"left \"a\"", {0.1, 0.2, 0.3}, {0.6, 0.0, 0.8}}};
  auto writer = TrajectoryWriter::create(path, header);
  ASSERT_TRUE(writer);
  ASSERT_TRUE(writer->write(sample()));
  ASSERT_TRUE(writer->finish());
  EXPECT_FALSE(writer->write(sample()));

  const auto read = readTrajectory(path);
  ASSERT_TRUE(read) << errorSentence(read.error());
  ASSERT_EQ(read->samples.size(), 1u);
  const TrajectorySample& s = read->samples.front();
  EXPECT_EQ(s.time, sample().time);
  EXPECT_EQ(s.frame, 10);
  EXPECT_EQ(s.target, sample().target);
  EXPECT_EQ(s.position, sample().position);
  EXPECT_EQ(s.covariance, sample().covariance);
  EXPECT_EQ(s.effectiveSampleSize, 123.5);
  EXPECT_EQ(s.cameraCount, 2);
  EXPECT_FALSE(s.isValid);
  ASSERT_EQ(read->header.cameras.size(), 1u);
  EXPECT_EQ(read->header.cameras[0].name, "left \"a\"");
  EXPECT_EQ(read->header.cameras[0].center, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(read->header.cameras[0].opticalAxis, Eigen::Vector3d(0.6, 0.0, 0.8));
  ASSERT_EQ(read->header.entries.size(), 2u);
  EXPECT_EQ(read->header.entries[0].second, "barrera");
  EXPECT_EQ(read->header.entries[1].second, "two lines: one"); // a header entry is one line
  std::filesystem::remove(path);
}

TEST(TrajectoryFile, LooksAsDocumented) {
  const auto path = temporary("golden.csv");
  auto writer = TrajectoryWriter::create(path, {{{"seed", "1"}}, {{"a", {1, 2, 3}, {0, 0, 1}}}});
  ASSERT_TRUE(writer);
  TrajectorySample s;
  s.time = 0.1;
  s.frame = 3;
  s.target = "ball";
  s.position = {0.5, 0.25, 1.0};
  ASSERT_TRUE(writer->write(s));
  // Not finished on purpose: a killed run leaves every row it wrote.
  EXPECT_EQ(contents(path), "# dewpoint trajectory\n"
                            "# units: time s, position m, covariance m^2\n"
                            "# seed: 1\n"
                            "# camera: \"a\" center 1 2 3 axis 0 0 1\n"
                            "time_s,frame,target,x_m,y_m,z_m,cov_xx_m2,cov_xy_m2,cov_xz_m2,"
                            "cov_yy_m2,cov_yz_m2,cov_zz_m2,ess,cameras,valid\n"
                            "0.1,3,ball,0.5,0.25,1,0,0,0,0,0,0,0,0,1\n");
  std::filesystem::remove(path);
}

TEST(TrajectoryFile, UnwritablePlacesAreErrors) {
  const auto missing = TrajectoryWriter::create(temporary("no_folder") / "a.csv", {});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::FileUnwritable);
  EXPECT_NE(missing.error().file.find("a.csv"), std::string::npos);
  if (!std::filesystem::exists("/dev/full"))
    GTEST_SKIP() << "no /dev/full";
  const auto full = TrajectoryWriter::create("/dev/full", {}); // a disk without space
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().code, ErrorCode::FileUnwritable);
}

TEST(TrajectoryFile, AnOldFileStaysWholeWhenTheNewOneCannotBeWritten) {
  const auto path = temporary("kept.csv");
  ASSERT_TRUE(writeTrajectory({{}, {sample()}}, path));
  const std::string before = contents(path);
  const auto beside = path.string() + ".part";
  std::filesystem::create_directory(beside); // what is written beside finds its place taken
  const auto status = writeTrajectory({{}, {sample(), sample()}}, path);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::FileUnwritable);
  EXPECT_EQ(status.error().file, path);
  EXPECT_EQ(contents(path), before);
  std::filesystem::remove(beside);
  ASSERT_TRUE(writeTrajectory({{}, {sample(), sample()}}, path));
  EXPECT_EQ(readTrajectory(path)->samples.size(), 2U);
  std::filesystem::remove(path);
}

TEST(TrajectoryFile, HoldsTheParticleOfHighestWeight) {
  const auto path = temporary("best.csv");
  Trajectory written{{}, {sample(), sample()}};
  written.header.hasBestParticles = true;
  written.samples[0].bestParticle = Eigen::Vector3d(0.1, 1.0 / 3.0, -2.5e-7);
  ASSERT_TRUE(writeTrajectory(written, path));
  EXPECT_NE(contents(path).find(",ess,cameras,valid,best_x_m,best_y_m,best_z_m\n"),
            std::string::npos);
  const auto read = readTrajectory(path);
  ASSERT_TRUE(read) << errorSentence(read.error());
  EXPECT_TRUE(read->header.hasBestParticles);
  ASSERT_EQ(read->samples.size(), 2U);
  EXPECT_EQ(read->samples[0].bestParticle, written.samples[0].bestParticle); // to the last bit
  EXPECT_FALSE(read->samples[1].bestParticle);                               // its cells are empty
  std::filesystem::remove(path);
  const auto old = readText("frame,x_m,y_m,z_m\n0,1,2,3\n"); // of a version without the columns
  ASSERT_TRUE(old);
  EXPECT_FALSE(old->header.hasBestParticles);
  EXPECT_FALSE(old->samples[0].bestParticle);
  EXPECT_EQ(
      readText("x_m,y_m,z_m,frame,best_x_m,best_y_m,best_z_m\n1,2,3,0,1,2o,3\n").error().field,
      "line 2, best_y_m");
}

TEST(TrajectoryFile, MarksWhatWasCorrected) {
  const auto path = temporary("corrected.csv");
  Trajectory written{{}, {sample(), sample()}};
  written.header.hasCorrectedColumn = true;
  written.samples[1].isCorrected = true;
  ASSERT_TRUE(writeTrajectory(written, path));
  EXPECT_NE(contents(path).find(",ess,cameras,valid,corrected\n"), std::string::npos);
  const auto read = readTrajectory(path);
  ASSERT_TRUE(read) << errorSentence(read.error());
  EXPECT_TRUE(read->header.hasCorrectedColumn);
  ASSERT_EQ(read->samples.size(), 2U);
  EXPECT_FALSE(read->samples[0].isCorrected);
  EXPECT_TRUE(read->samples[1].isCorrected);
  std::filesystem::remove(path);
  EXPECT_FALSE(readText("frame,x_m,y_m,z_m\n0,1,2,3\n")->header.hasCorrectedColumn);
}

TEST(TrajectoryFile, MarksWhatIsAmbiguous) {
  const auto path = temporary("ambiguous.csv");
  Trajectory written{{}, {sample(), sample()}};
  written.header.hasAmbiguousColumn = true;
  written.samples[1].isAmbiguous = true;
  ASSERT_TRUE(writeTrajectory(written, path));
  EXPECT_NE(contents(path).find(",ess,cameras,valid,ambiguous\n"), std::string::npos);
  const auto read = readTrajectory(path);
  ASSERT_TRUE(read) << errorSentence(read.error());
  EXPECT_TRUE(read->header.hasAmbiguousColumn);
  ASSERT_EQ(read->samples.size(), 2U);
  EXPECT_FALSE(read->samples[0].isAmbiguous);
  EXPECT_TRUE(read->samples[1].isAmbiguous);
  std::filesystem::remove(path);
  EXPECT_FALSE(readText("frame,x_m,y_m,z_m\n0,1,2,3\n")->header.hasAmbiguousColumn);
}

TEST(TrajectoryFile, KeepsTheExtentOfWhatIsNoBall) {
  const auto path = temporary("extent.csv");
  Trajectory written{{}, {sample(), sample()}};
  written.header.hasExtent = true;
  Eigen::Matrix3d extent;
  extent << 4e-4, 1e-4, 0.0, 1e-4, 9e-4, -2e-4, 0.0, -2e-4, 1e-4;
  written.samples[1].extent = extent;
  ASSERT_TRUE(writeTrajectory(written, path));
  const auto read = readTrajectory(path);
  ASSERT_TRUE(read) << errorSentence(read.error());
  std::filesystem::remove(path);
  EXPECT_TRUE(read->header.hasExtent);
  ASSERT_EQ(read->samples.size(), 2U);
  EXPECT_FALSE(read->samples[0].extent);
  EXPECT_EQ(read->samples[1].extent, extent);
  EXPECT_EQ(read->samples[1].covariance, sample().covariance);
  EXPECT_FALSE(readText("frame,x_m,y_m,z_m\n0,1,2,3\n")->header.hasExtent);
}

TEST(TrajectoryFile, ReadsTruthByColumnNames) {
  const auto truth = readText("z_m,frame,x_m,remark,y_m\r\n3,7,1,hello,2\r\n");
  ASSERT_TRUE(truth) << errorSentence(truth.error());
  ASSERT_EQ(truth->samples.size(), 1u);
  EXPECT_EQ(truth->samples[0].position, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(truth->samples[0].frame, 7);
  EXPECT_TRUE(std::isnan(truth->samples[0].time));
  EXPECT_TRUE(truth->samples[0].isValid);
  EXPECT_EQ(truth->samples[0].target, "");
  const auto timed = readText("time_s,x_m,y_m,z_m\n0.5,1,2,3\n");
  ASSERT_TRUE(timed);
  EXPECT_EQ(timed->samples[0].frame, kNoFrame);
}

TEST(TrajectoryFile, IgnoresALineThatWasCutOff) {
  const auto cut = readText("frame,x_m,y_m,z_m\n0,1,2,3\n1,1,2,3.");
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->samples.size(), 1u);
}

TEST(TrajectoryFile, ErrorsNameLineAndColumn) {
  const auto bad = readText("# c\nframe,x_m,y_m,z_m\n0,1,2,3\n1,1,2o,3\n");
  ASSERT_FALSE(bad);
  EXPECT_EQ(bad.error().code, ErrorCode::BadValue);
  EXPECT_EQ(bad.error().field, "line 4, y_m");
  const auto comma = readText("frame,x_m,y_m,z_m\n0,1,2,3,5\n");
  ASSERT_FALSE(comma);
  EXPECT_EQ(comma.error().field, "line 2");
  const auto column = readText("frame,x_m,y_m\n0,1,2\n");
  ASSERT_FALSE(column);
  EXPECT_EQ(column.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(column.error().field, "line 1, z_m");
  EXPECT_EQ(readText("x_m,y_m,z_m\n").error().code, ErrorCode::MissingKey);
  EXPECT_EQ(readText("").error().code, ErrorCode::EndedEarly);
  EXPECT_EQ(readText("target,frame,x_m,y_m,z_m\n\"a,0,1,2,3\n").error().code, ErrorCode::NotParsed);
  EXPECT_EQ(readTrajectory(temporary("absent.csv")).error().code, ErrorCode::FileMissing);
  EXPECT_EQ(readTrajectory(::testing::TempDir()).error().code, ErrorCode::FileUnreadable);
}

} // namespace
} // namespace dewpoint::tests
