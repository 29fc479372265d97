// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

/// Treatment of frames in which the position of a target is unknown.
enum class GapRule {
  LeaveEmpty, ///< the values of the frame are left empty
  Fill ///< the position is interpolated between its neighbors, or smoothed, and marked as filled
};

/// Upward axis of the file. Both choices are right-handed.
enum class WorldAxes {
  ZUp, ///< z points up, as in Dewpoint
  YUp  ///< y points up, as in Pose2Sim and OpenSim: (x, y, z) of the file is (y, z, x) of Dewpoint
};

/// Unit of lengths in the file.
enum class LengthUnit { Meter, Millimeter };

/// First or last row of an export: a time in seconds, or a frame number. The row at the bound is
/// exported too.
struct RangeBound {
  double secondsOrFrame = 0.0; ///< time in seconds, or frame number
  bool isFrameNumber = false;  ///< true if `secondsOrFrame` is a frame number
};

/// The user's choices for an export. Values that are not set take the default of the format.
struct ExportOptions {
  std::string format = "csv";           ///< id of one of exportFormats()
  std::vector<std::string> targets;     ///< names of the targets to export; empty: all targets
  std::optional<RangeBound> rangeBegin; ///< first row; not set: from the beginning
  std::optional<RangeBound> rangeEnd;   ///< last row; not set: to the end
  std::optional<double> rowsPerSecond;  ///< not set: as recorded
  GapRule gapRule = GapRule::LeaveEmpty;
  std::optional<WorldAxes> axes;
  std::optional<LengthUnit> unit;
  bool writesHeader = true; ///< true to write metadata even if the format does not require it
  /// True to export estimates that are smoothed after the run, instead of the live estimates.
  bool usesSmoothedEstimates = false;
  double maxFilledGapSeconds = 1.0; ///< longest gap that is filled
  std::string exportDate;           ///< date of the export for the header; empty: none
  bool replacesExisting = true;     ///< false: existing files are not overwritten
};

} // namespace dewpoint::trajectory
