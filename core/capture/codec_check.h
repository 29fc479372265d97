// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Result of writing and reading a test recording of one type; see checkCodecs().
struct CodecOutcome {
  std::string name; ///< name of the type, for example "FFV1"
  /// True if this program needs the codec for its own recordings. Otherwise the codec is only
  /// needed to read recordings from other programs.
  bool isNeeded = false;
  bool isLossless = false;
  std::string problem = {}; ///< what went wrong; empty if there was no problem
  /// True if this computer cannot write this type. Reading was then not tested.
  bool isMissing = false;
  double difference =
      0.0; ///< mean absolute difference between written and read images, in gray levels
};

/// Tests whether this computer can write and read recordings. Writes a short moving sequence to an
/// existing folder as Motion JPEG, FFV1 and H.264 videos and as a folder of PNG images, and reads
/// each of them back. Returns one result per type. The files are kept.
std::vector<CodecOutcome> checkCodecs(const std::filesystem::path& folder);

} // namespace dewpoint::capture
