// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/broadcast/message/frame_message.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::broadcast {

/// Format in which results are sent during a run, such as JSON lines. Its functions have no side
/// effects: the same input gives the same bytes.
struct StreamFormat {
  std::string_view id;               ///< name in documents and messages
  std::string_view title;            ///< description in a few words
  std::string_view frameDescription; ///< contents of a frame, in one sentence
  /// Returns the text that a receiver gets before the first frame, and again after a change of the
  /// rig. An empty text is not sent.
  std::string (*preamble)(const RigMessage& rig);
  /// Returns a frame as pieces: lines including their line ends, or datagrams. A receiver can
  /// understand each piece without the others.
  std::vector<std::string> (*encode)(const FrameMessage& frame);
};

/// Returns all stream formats.
std::span<const StreamFormat> streamFormats();

/// Returns the format of JSON lines.
const StreamFormat& jsonLinesFormat();
/// Returns the format of CSV rows.
const StreamFormat& csvRowsFormat();
/// Returns the format of OSC messages.
const StreamFormat& oscMessagesFormat();
/// Returns the format of TUIO 3D cursors.
const StreamFormat& tuioCursorsFormat();

} // namespace dewpoint::broadcast
