// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/capture_times.h"
#include "core/capture/frame_source.h"
#include "core/project/project.h"
#include "core/setup/doctor/finding.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::setup {

/// Options for checking a project.
struct ExaminationOptions {
  /// Folder to which results would be written; empty: the folder of the project.
  std::filesystem::path outputFolder = {};
  bool decodesEveryFrame =
      false; ///< true to decode all frames, not only the first, middle and last ones
  /// Function that opens the images of a project as a run would. If it is empty, checks that need
  /// images from all cameras are omitted.
  std::function<Result<std::unique_ptr<FrameSetSource>>(const Project&)> open = {};
  /// Called from time to time with the progress (0 to 1); returning false ends the examination
  /// early.
  std::function<bool(double)> shouldContinue = [](double) { return true; };
};

/// Data about the recording of one camera.
struct CameraFootage {
  bool isOpen = false; ///< true if the recording can be read
  std::int64_t frameCount = 0;
  double framesPerSecond = 0.0; ///< frame rate given in the recording; 0: not given
  cv::Size size; ///< size of the images after rotation as the project specifies, pixels
  std::vector<std::int64_t> sequenceNumbers = {};
  /// First, middle and last image, CV_8UC3, rotated as the project specifies.
  std::vector<cv::Mat> images = {};
  std::optional<CaptureTimes> captureTimes = {};
};

/// A project being examined, and the findings so far. Each check uses the results of the preceding
/// ones.
struct Examination {
  Examination(const Project& examined, const ExaminationOptions& wanted)
      : project(examined), options(wanted), footage(examined.cameras.size()) {}

  const Project& project;
  const ExaminationOptions& options;
  /// Data about each recording, in the order of the project's cameras.
  std::vector<CameraFootage> footage;
  std::vector<Finding> findings = {};

  /// Adds a finding about a field of the project file.
  void add(FindingKind kind, std::vector<std::string> values, std::string field = "") {
    findings.push_back({kind, std::move(values), project.file.string(), std::move(field)});
  }
  /// Adds a finding about a file other than the project file.
  void addForFile(const std::string& file, FindingKind kind, std::vector<std::string> values) {
    findings.push_back({kind, std::move(values), file, ""});
  }
  /// Returns whether the checks so far have a finding of this kind.
  bool hasFinding(FindingKind kind) const;
  bool hasProblem() const { return worstLevelOf(findings) == FindingLevel::Problem; }
  /// Returns the name of a camera for use in sentences: "camera 'left'".
  std::string nameOf(std::size_t camera) const;
};

/// Returns the name of a camera's field in the project file: "camera 1.video".
std::string cameraKey(std::size_t camera, const char* key);

/// Returns the text of an error without the file name, for use in a sentence that already names the
/// file.
std::string messageWithoutFile(const Error& error);

} // namespace dewpoint::setup
