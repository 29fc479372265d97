// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/project/moved_files.h"
#include "core/project/project.h"
#include "core/trajectory/trajectory.h"

#include <opencv2/core/mat.hpp>

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::session {

/// Inputs of a run, chosen by the application.
struct SessionInputs {
  Project project;
  std::unique_ptr<FrameSetSource> source;
  Trajectory truth; ///< empty when unknown
  /// Of the cameras (loadBackgroundImages); may be empty.
  std::vector<cv::Mat> backgroundImages = {};
  /// Bytes that going back in the run may take: images of live cameras, particles, copies.
  /// 0: 1 GB for live cameras, half of it for recordings.
  std::size_t historyBytes = 0;
  /// Initial number of filter threads, which never changes the result. 0: default of
  /// base::filterThreads().
  int threads = 0;
};

/// Project that the user wants to open: the one in a file (empty: the demo), or an unsaved one.
struct SessionRequest {
  template <std::convertible_to<std::filesystem::path> File>
  SessionRequest(File&& wanted) : file(std::forward<File>(wanted)) {} // NOLINT: implicit
  SessionRequest(Project wanted) : project(std::move(wanted)) {}      // NOLINT: implicit

  std::filesystem::path file;
  std::optional<Project> project;
  MovedFiles moved; ///< present location of files that `file` names elsewhere
};

} // namespace dewpoint::session
