// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Result of checking whether this computer can write and read one kind of recording.
struct CodecOutcome {
  std::string name; ///< for example "FFV1"
  /// Whether recordings of this program need the codec; without the others, only recordings of
  /// other programs cannot be read.
  bool isNeeded = false;
  bool isLossless = false;
  std::string problem = {}; ///< what went wrong; empty if nothing did
  bool isMissing = false;   ///< this computer cannot write it, so reading was not tried
  double difference = 0.0;  ///< mean absolute difference after reading back, in gray levels
};

/// Writes a short moving sequence as Motion JPEG, FFV1 and H.264 videos and as a folder of PNG
/// images into an existing folder, and reads each back. The files are kept.
std::vector<CodecOutcome> checkCodecs(const std::filesystem::path& folder);

} // namespace dewpoint::capture
