// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/clips/calibrated_clip.h"

#include <filesystem>
#include <functional>
#include <string>

namespace dewpoint::experiment {

/// Folders from which real clips are read.
struct ClipFolders {
  /// Folder with one subfolder per recording; empty: there are no recordings.
  std::filesystem::path recordings;
  /// Folder with the truth made for this project: bench/clips in the sources.
  std::filesystem::path truth;
};

/// Origin of a clip's ground truth, which determines how independent the truth is of the methods.
enum class TruthOrigin {
  Board,    ///< positions computed from the corners of a printed board, without using color or a
            ///< tracker
  Marked,   ///< marked by hand in the images
  Segmented ///< segmented by target color; NOT independent of methods that use color
};

/// Use of a clip during the development of methods.
enum class TuningUse {
  No,     ///< not known to have been viewed during development
  Viewed, ///< viewed or used for tests, but no constant is known to have been chosen on it
  Yes     ///< constants or defaults were chosen on this clip
};

/// Declaration of a real clip: one row of the catalog. Either `calibrated` or `images` is set.
struct ClipDeclaration {
  std::string name;                ///< name of the scenario: "R1-hand"
  std::string recording;           ///< folder of the recording
  std::string description;         ///< what the clip shows, in one sentence
  std::string learningDescription; ///< how methods learn the target's appearance
  std::string truthDescription;    ///< kind, origin and accuracy of the truth
  TruthOrigin origin = TruthOrigin::Marked;
  /// Standard deviation of the truth along each axis: in mm, or in pixels for a clip recorded by
  /// one camera (`images` is set).
  double truthSigma = 0.0;
  TuningUse tuningUse = TuningUse::No;
  std::string tuningNote; ///< what was tuned on the clip, or why nothing was, in one clause
  int seedCount = 5;      ///< default number of runs in a report
  /// True if the `truth` folder of ClipFolders is also needed.
  bool needsTruthFolder = false;
  /// Loads a clip recorded by calibrated cameras, for methods that track in 3D space.
  std::function<Result<CalibratedClip>(const ClipFolders&)> calibrated = nullptr;
  /// Loads a clip recorded by one camera, for methods that follow boxes.
  std::function<Result<BoxClip>(const ClipFolders&)> images = nullptr;
};

/// Recording from which no clip is made, and the reason.
struct OmittedRecording {
  std::string recording; ///< folder of the recording
  std::string reason;    ///< why no clip is made from it, in one sentence
};

} // namespace dewpoint::experiment
