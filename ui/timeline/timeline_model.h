// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/run/result_settings.h"
#include "core/session/snapshot/display_colors.h"
#include "core/session/snapshot/snapshot.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Data that a timeline shows, except the selection.
struct TimelineModel {
  /// Records of the tracked frames, in increasing frame order. Only some of the old frames have a
  /// record.
  std::vector<FrameRecord> records;
  QStringList targetNames;
  std::vector<DisplayColorSource> colorSources; ///< what determines the color of each target
  QStringList cameraNames;
  std::vector<ProjectMarker> markers;
  /// Positions corrected by the user, in increasing frame order.
  std::vector<PositionCorrection> corrections;
  /// Frames with results from earlier settings, in increasing frame order.
  std::vector<ResultRange> oldResults;
  bool hasOldResult(qint64 frame) const;
  HistoryState history;
  std::optional<RerunState> rerun;
  bool isLive = false;
  /// Frame rate, computed from the time stamps of the records; if there are fewer than two records,
  /// the frame rate of the source.
  double framesPerSecond = 30.0;

  /// Sets the frame rate of the source, which is used until there are two records.
  void setSourceFrameRate(double rate);
  /// Adds new log records. If a frame is repeated, the new record replaces the old one. If the run
  /// has `restarted`, all old records are removed first.
  void append(const std::vector<FrameRecord>& more, bool restarted);
  /// Returns the frame after the last frame that a record represents. This is the frame of the next
  /// record, unless there are untracked frames before it.
  qint64 endFrameOf(std::size_t record) const;
  /// Returns the record that represents a frame: the record of this frame or, where only every few
  /// frames have a record, of the closest earlier frame. Returns null if there is none.
  const FrameRecord* recordAt(qint64 frame) const;
  /// Returns the time of a frame in seconds, from its record or from the frame rate.
  double secondsOf(qint64 frame) const;
  /// Returns the frame closest to a time in seconds. For a time beyond the records, the frame is
  /// computed from the frame rate, and may not exist.
  qint64 frameAtSeconds(double seconds) const;
  /// Returns whether this camera's image is missing in any frame.
  bool hasDropouts(std::size_t camera) const { return (missing_ >> camera & 1U) != 0; }
  /// Returns whether the user corrected this target's position in this frame.
  bool isCorrected(std::size_t target, qint64 frame) const;
  /// Returns the frame of the closest marker after (1) or before (-1) a frame, or nothing if there
  /// is none.
  std::optional<qint64> nextMarkerFrame(qint64 from, int direction) const;
  /// Returns a text about a frame: "Frame 132, 4.400 s: ball tracking (0.99) · …".
  QString descriptionOf(qint64 frame) const;

private:
  std::uint64_t missing_ = 0;
};

} // namespace dewpoint::ui
