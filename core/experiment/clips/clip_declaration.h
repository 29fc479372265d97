// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/clips/calibrated_clip.h"

#include <filesystem>
#include <functional>
#include <string>

namespace dewpoint::experiment {

/// Where real clips are read from.
struct ClipFolders {
  std::filesystem::path recordings; ///< a folder per recording; empty: there are none
  std::filesystem::path truth;      ///< bench/clips of the sources: truth that was made here
};

/// Where a clip's truth comes from, and so how independent it is of the methods.
enum class TruthOrigin {
  Board,    ///< corners of a printed board: no color, no tracker
  Marked,   ///< by hand, by eye
  Segmented ///< from the targets' colors: NOT independent of methods that use color
};

/// Whether methods were made on a clip.
enum class TunedOn {
  No,     ///< nobody looked at it while a method was made, as far as it is recorded
  Looked, ///< it was looked at or tested with; no constant is recorded as chosen on it
  Yes     ///< constants were chosen, or defaults set, on it
};

/// A real clip: one row of the catalog. Either `calibrated` or `images` is there.
struct ClipDeclaration {
  std::string name;      ///< of the scenario: "R1-hand"
  std::string recording; ///< folder of the recording
  std::string sentence;  ///< what is to be seen
  std::string start;     ///< how methods get to know the target
  std::string truth;     ///< what it is, from where, and how exact
  TruthOrigin origin = TruthOrigin::Marked;
  /// How exact, along each axis: mm, or pixels where only images are measured.
  double truthSigma = 0.0;
  TunedOn tunedOn = TunedOn::No;
  std::string tuned; ///< what was, or why not, in one clause
  int seeds = 5;     ///< runs of a report unless requested otherwise
  /// Whether `truth` of ClipFolders is needed too.
  bool needsTruthFolder = false;
  /// Of calibrated cameras: for methods that track in space.
  std::function<Result<CalibratedClip>(const ClipFolders&)> calibrated = nullptr;
  /// Of one camera: for methods that follow boxes.
  std::function<Result<BoxClip>(const ClipFolders&)> images = nullptr;
};

/// A recording that no clip is made of, and why.
struct OmittedRecording {
  std::string recording; ///< its folder
  std::string reason;    ///< a sentence
};

} // namespace dewpoint::experiment
