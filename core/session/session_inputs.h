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

/// What a run needs, chosen and wired by the application.
struct SessionInputs {
  Project project;
  std::unique_ptr<FrameSetSource> source;
  Trajectory truth; ///< empty when unknown
  /// Of the cameras (loadEmptyRooms); may be empty.
  std::vector<cv::Mat> emptyRooms = {};
  /// Bytes that going back in the run may take: images of live cameras, particles, copies.
  /// 0: 1 GB for live cameras, half of it for recordings.
  std::size_t historyBytes = 0;
  /// Threads that share the work of the filter at first; they never change its result. 0: as
  /// base::filterThreads() says.
  int threads = 0;
};

/// What a person wants to work on: the project in a file (empty: the demo), or one that is in no
/// file as it is.
struct SessionRequest {
  template <std::convertible_to<std::filesystem::path> File>
  SessionRequest(File&& wanted) : file(std::forward<File>(wanted)) {} // NOLINT: implicit
  SessionRequest(Project wanted) : project(std::move(wanted)) {}      // NOLINT: implicit

  std::filesystem::path file;
  std::optional<Project> project;
  MovedFiles moved; ///< of `file`: where files are that it names elsewhere
};

} // namespace dewpoint::session
