// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Whether one kind of recordings can be written and read on this computer.
struct CodecOutcome {
  std::string name; ///< "FFV1"
  /// Recordings of this program need it; without the others only recordings of other programs
  /// cannot be read.
  bool isNeeded = false;
  bool isLossless = false;
  std::string problem = {}; ///< what went wrong; empty: nothing
  bool isMissing = false;   ///< this computer cannot write it, so reading it was not tried
  double difference = 0.0;  ///< mean absolute difference of what was read back, gray values
};

/// Writes a small moving picture as a Motion JPEG, an FFV1 and an H.264 video and as a folder of
/// PNG images into a folder that is there, and reads each back. The files stay.
std::vector<CodecOutcome> checkCodecs(const std::filesystem::path& folder);

} // namespace dewpoint::capture
