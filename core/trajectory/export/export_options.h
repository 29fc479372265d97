// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::trajectory {

enum class GapRule {
  Leave, ///< what is not known stays empty
  Fill   ///< it is interpolated between its neighbors, or smoothed, and marked
};

/// Which axis of the file points up. Both are right-handed.
enum class WorldAxes {
  ZUp, ///< as in the program
  YUp  ///< (x, y, z) of the file is (y, z, x) of the program, as Pose2Sim and OpenSim have it
};

enum class LengthUnit { Meter, Millimeter };

/// One end of what is exported, both ends included: a time in seconds, or a frame number.
struct SpanEnd {
  double value = 0.0;
  bool isFrame = false;
};

/// The user's choices for an export. What is left out is as the format has it.
struct ExportOptions {
  std::string format = "csv";       ///< an id of exportFormats()
  std::vector<std::string> targets; ///< all if empty
  std::optional<SpanEnd> from;      ///< from the beginning
  std::optional<SpanEnd> to;        ///< to the end
  std::optional<double> rate;       ///< rows per second; as recorded
  GapRule gaps = GapRule::Leave;
  std::optional<WorldAxes> axes;
  std::optional<LengthUnit> unit;
  bool header = true;      ///< metadata, where the format can do without
  bool smooth = false;     ///< what is known after the run instead of what was known live
  double longestGap = 1.0; ///< seconds that are filled at most
  std::string date;        ///< of the export, for the header; none if empty
  bool replaces = true;    ///< false: files that are there already are left alone
};

} // namespace dewpoint::trajectory
