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
  Trajectory truth; ///< true positions of the targets; empty if unknown
  /// Background image of each camera, which shows the scene without targets; may be empty.
  std::vector<cv::Mat> backgroundImages = {};
  /// Memory limit, in bytes, for the data needed to go back in the run: images, particles, and
  /// copies of the tracker. 0: 1 GB for live cameras, half of that for recordings.
  std::size_t maxHistoryBytes = 0;
  /// Initial number of filter threads; it never changes the result. 0: the default,
  /// base::threadCountForFilter().
  int threadCount = 0;
  /// Encoded images of each live camera, in project order, which TakeRecorder can record; empty for
  /// recordings.
  std::vector<std::shared_ptr<capture::EncodedFeed>> feeds = {};
};

/// Request to open a project: either a project file (the demo if empty), or an unsaved project.
struct SessionRequest {
  template <std::convertible_to<std::filesystem::path> File>
  SessionRequest(File&& wanted) : file(std::forward<File>(wanted)) {} // NOLINT: implicit
  SessionRequest(Project wanted) : project(std::move(wanted)) {}      // NOLINT: implicit

  std::filesystem::path file;
  std::optional<Project> project;
  /// Current locations of files that are no longer at the path named in the project.
  MovedFiles movedFiles;
};

} // namespace dewpoint::session
