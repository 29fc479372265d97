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
  std::filesystem::path recordings; ///< one folder per recording; empty: none
  std::filesystem::path truth;      ///< bench/clips of the sources: truth made for this project
};

/// Origin of a clip's truth, and therefore how independent it is of the methods.
enum class TruthOrigin {
  Board,    ///< corners of a printed board; no color, no tracker
  Marked,   ///< by hand and eye
  Segmented ///< from the targets' colors: NOT independent of methods that use color
};

/// Whether methods were developed with a clip.
enum class TunedOn {
  No,     ///< as far as recorded, nobody looked at it during development
  Looked, ///< viewed or used for tests; no constant is recorded as chosen on it
  Yes     ///< constants or defaults were chosen on it
};

/// Declaration of a real clip: one row of the catalog. Either `calibrated` or `images` is set.
struct ClipDeclaration {
  std::string name;      ///< name of the scenario: "R1-hand"
  std::string recording; ///< folder of the recording
  std::string sentence;  ///< what it shows
  std::string start;     ///< how methods learn the target
  std::string truth;     ///< kind, origin and accuracy of the truth
  TruthOrigin origin = TruthOrigin::Marked;
  /// Standard deviation of the truth along each axis: mm, or pixels if only images are measured.
  double truthSigma = 0.0;
  TunedOn tunedOn = TunedOn::No;
  std::string tuned; ///< what was tuned, or why nothing was, in one clause
  int seeds = 5;     ///< runs of a report unless requested otherwise
  /// Whether the `truth` folder of ClipFolders is also needed.
  bool needsTruthFolder = false;
  /// Loads a clip of calibrated cameras, for methods that track in space.
  std::function<Result<CalibratedClip>(const ClipFolders&)> calibrated = nullptr;
  /// Loads a clip of one camera, for methods that follow boxes.
  std::function<Result<BoxClip>(const ClipFolders&)> images = nullptr;
};

/// Recording from which no clip is made, and why.
struct OmittedRecording {
  std::string recording; ///< folder of the recording
  std::string reason;    ///< one sentence
};

} // namespace dewpoint::experiment
