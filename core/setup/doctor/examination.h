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

/// How a project is to be checked.
struct ExaminationWishes {
  std::filesystem::path output = {}; ///< where results would go; empty: the folder of the project
  bool everyFrame = false;           ///< decode all frames, not only the first, middle and last
  /// Opens the images of a project as a run would; empty: what needs it is left out.
  std::function<Result<std::unique_ptr<FrameSetSource>>(const Project&)> open = {};
  /// Called now and then with the part that is done (0 to 1); false ends the examination early.
  std::function<bool(double)> goOn = [](double) { return true; };
};

/// What was found in the recording of one camera.
struct CameraFootage {
  bool isOpen = false; ///< it can be read
  std::int64_t frames = 0;
  double rate = 0.0; ///< as the recording states it; 0: it does not
  cv::Size size;     ///< after the rotation
  std::vector<std::int64_t> places = {};
  std::vector<cv::Mat> images = {}; ///< the first, the middle and the last, CV_8UC3, rotated
  std::optional<CaptureTimes> times = {};
};

/// A project under examination: what the checks have found so far, each going by those before it.
struct Examination {
  Examination(const Project& examined, const ExaminationWishes& wanted)
      : project(examined), wishes(wanted), footage(examined.cameras.size()) {}

  const Project& project;
  const ExaminationWishes& wishes;
  std::vector<CameraFootage> footage; ///< in the order of the project's cameras
  std::vector<Finding> findings = {};

  /// In a field of the project file.
  void add(FindingKind kind, std::vector<std::string> values, std::string field = "") {
    findings.push_back({kind, std::move(values), project.file.string(), std::move(field)});
  }
  /// In another file.
  void addIn(const std::string& file, FindingKind kind, std::vector<std::string> values) {
    findings.push_back({kind, std::move(values), file, ""});
  }
  bool has(FindingKind kind) const;
  bool hasProblem() const { return worstOf(findings) == FindingLevel::Problem; }
  /// "camera 'left'", in sentences.
  std::string nameOf(std::size_t camera) const;
};

/// A field of a camera in the project file: "camera 1.video".
std::string cameraKey(std::size_t camera, const char* key);

/// An error without the file, for a sentence that names it already.
std::string withoutFile(const Error& error);

} // namespace dewpoint::setup
