// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::broadcast {

/// A format in which results leave the program while it runs: one row of the table. Its functions
/// are pure, so that the bytes can be compared with written examples.
struct StreamFormat {
  std::string_view id;     ///< name in documents and messages
  std::string_view title;  ///< what it is, in a few words
  std::string_view fields; ///< what a frame contains, in one sentence
  /// Returns what a receiver gets before the first frame, and again after a change of the rig;
  /// empty: nothing.
  std::string (*opening)(const RigMessage& rig);
  /// Returns a frame as pieces, each of which a receiver can understand without the others: lines
  /// with their line end, or datagrams.
  std::vector<std::string> (*encode)(const FrameMessage& frame);
};

/// Returns all formats.
std::span<const StreamFormat> streamFormats();

/// Return one format each.
const StreamFormat& jsonLines();
const StreamFormat& csvRows();
const StreamFormat& oscMessages();
const StreamFormat& tuioCursors();

} // namespace dewpoint::broadcast
