// SPDX-License-Identifier: GPL-3.0-or-later
// A small run to export: two targets, four frames at 10 Hz, a gap of one frame in the first.
#pragma once

#include "core/trajectory/export/trajectory_export.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace dewpoint::tests {

inline TrajectorySample exportSample(std::int64_t frame, const std::string& target,
                                     const Eigen::Vector3d& position) {
  TrajectorySample sample;
  sample.frame = frame;
  sample.time = static_cast<double>(frame) / 10.0;
  sample.target = target;
  sample.position = position;
  sample.covariance = Eigen::Vector3d(1e-6, 4e-6, 9e-6).asDiagonal();
  sample.covariance(0, 1) = sample.covariance(1, 0) = 5e-7;
  sample.effectiveSampleSize = 120.0;
  sample.cameraCount = 2;
  return sample;
}

inline Trajectory exportExample() {
  Trajectory trajectory;
  trajectory.header.entries = {{"version", "9.9"}, {"seed", "7"}};
  for (std::int64_t frame = 0; frame < 4; ++frame) {
    const auto t = static_cast<double>(frame);
    trajectory.samples.push_back(exportSample(frame, "ball", {0.1 * t, 0.25, 1.0 + t * t}));
    trajectory.samples.push_back(exportSample(frame, "cap, red", {1.0, 2.0, 3.0}));
  }
  trajectory.samples[4].isValid = false; // the ball at frame 2
  return trajectory;
}

inline ExportOptions exportAs(const std::string& format) {
  ExportOptions options;
  options.format = format;
  return options;
}

/// An empty folder of its own, removed at the end.
class ExportFolder {
public:
  ExportFolder()
      : path_(std::filesystem::path(::testing::TempDir()) /
              ("dewpoint_export_" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ExportFolder(const ExportFolder&) = delete;
  ExportFolder& operator=(const ExportFolder&) = delete;
  ~ExportFolder() { std::filesystem::remove_all(path_); }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// The main file's content; empty, with a failed check, if it cannot be exported.
inline std::string exported(const Trajectory& trajectory, const ExportOptions& options,
                            const std::string& name) {
  const ExportFolder folder;
  const auto summary = exportTrajectory(trajectory, options, folder / name);
  EXPECT_TRUE(summary) << (summary ? std::string() : errorSentence(summary.error()));
  return bytesOf(folder / name);
}

} // namespace dewpoint::tests
