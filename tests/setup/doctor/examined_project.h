// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_writer.h"
#include "core/setup/doctor/doctor.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/parameters.h"
#include "tests/camera_motion/agreement/ball_rig.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace dewpoint::tests {

/// A sound project of two cameras with folders of images of a red ball; tests plant faults in it.
class ExaminedProject : public testing::Test {
protected:
  static constexpr int kFrames = 12;

  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / "examined" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    project_.file = folder_ / "desk.toml";
    project_.name = "desk";
    project_.framesPerSecond = ball::kRate;
    project_.parameters = ParameterValues(methodParameters(project_.method));
    project_.targets = {ball::target()};
    const CameraRig rig = ball::rigOf(2);
    for (std::size_t k = 0; k < rig.size(); ++k) {
      ProjectCamera camera;
      camera.camera = rig[k];
      camera.source = SourceKind::Images;
      camera.location = (folder_ / ("cam" + std::to_string(k + 1))).string();
      std::filesystem::create_directories(camera.location);
      project_.cameras.push_back(camera);
      for (int frame = 0; frame < kFrames; ++frame) {
        cv::imwrite(imageFile(k, frame), imageOf(k, frame));
      }
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  cv::Mat imageOf(std::size_t camera, int frame) const {
    return ball::imageOf(project_.cameras[camera].camera, frame / ball::kRate, 0.0)->image;
  }
  std::string imageFile(std::size_t camera, int frame) const {
    char name[16];
    std::snprintf(name, sizeof(name), "%04d.png", frame);
    return (std::filesystem::path(project_.cameras[camera].location) / name).string();
  }
  /// Makes a camera one of a video with so many frames.
  void makeVideo(std::size_t camera, double rate, int frames = kFrames) {
    const std::string file = project_.cameras[camera].location + ".mkv";
    auto writer = FrameWriter::createVideo(file, rate);
    for (int frame = 0; frame < frames; ++frame) {
      EXPECT_TRUE(writer->write(imageOf(camera, frame)));
    }
    EXPECT_TRUE(writer->finish());
    project_.cameras[camera].source = SourceKind::Video;
    project_.cameras[camera].location = file;
  }
  std::string text(const std::string& name, const std::string& content) const {
    const std::string file = (folder_ / name).string();
    std::ofstream(file) << content;
    return file;
  }
  static std::string times(double first, int count) {
    std::string lines = "time_s\n";
    for (int k = 0; k < count; ++k) {
      lines += std::to_string(first + k / ball::kRate) + "\n";
    }
    return lines;
  }

  std::vector<Finding> findings() const { return examine(project_, options_); }
  /// The finding of this kind; the test fails, and says what was found instead, when there is none.
  Finding found(FindingKind kind) const {
    const auto all = findings();
    const auto one = std::ranges::find(all, kind, &Finding::kind);
    if (one == all.end()) {
      ADD_FAILURE() << textsOf(kind).name << " is not among:\n" << linesOf(all);
      return {};
    }
    return *one;
  }
  static std::string linesOf(const std::vector<Finding>& all) {
    std::string lines;
    for (const Finding& finding : all) {
      lines += findingLine(finding) + "\n";
    }
    return lines;
  }

  std::filesystem::path folder_;
  Project project_;
  ExaminationOptions options_;
};

} // namespace dewpoint::tests
