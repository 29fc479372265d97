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

namespace dewpoint::capture {
class EncodedFeed;
} // namespace dewpoint::capture

namespace dewpoint::session {

/// Inputs of a run, chosen by the application.
struct SessionInputs {
  Project project;
  std::unique_ptr<FrameSetSource> source;
  Trajectory truth; ///< empty when unknown
  /// Background image of each camera (loadBackgroundImages()); may be empty.
  std::vector<cv::Mat> backgroundImages = {};
  /// Memory limit, in bytes, for the data needed to go back in the run: images of live cameras,
  /// particles, and copies of the tracker. If it is 0, the limit is 1 GB for live cameras and half
  /// of that for recordings.
  std::size_t historyBytes = 0;
  /// Initial number of filter threads, which never changes the result. 0: default of
  /// base::filterThreadCount().
  int threads = 0;
  /// Images of each live camera as it sends them, in the order of the project, for TakeRecorder;
  /// empty for recordings.
  std::vector<std::shared_ptr<capture::EncodedFeed>> feeds = {};
};

/// Request to open a project: either a project file (the demo if empty), or an unsaved project.
struct SessionRequest {
  template <std::convertible_to<std::filesystem::path> File>
  SessionRequest(File&& wanted) : file(std::forward<File>(wanted)) {} // NOLINT: implicit
  SessionRequest(Project wanted) : project(std::move(wanted)) {}      // NOLINT: implicit

  std::filesystem::path file;
  std::optional<Project> project;
  MovedFiles moved; ///< current locations of files that are no longer where the project names them
};

} // namespace dewpoint::session
