// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/run/result_settings.h"
#include "core/session/snapshot/snapshot.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Data that a timeline shows, except the selection.
struct TimelineModel {
  std::vector<FrameRecord> records; ///< by increasing frame; old ones in coarse steps
  QStringList targets;
  QStringList cameras;
  std::vector<ProjectMarker> markers;
  std::vector<PositionCorrection> corrections; ///< by rising frame
  std::vector<ResultRange> oldResults;         ///< those of earlier settings, by rising frame
  bool isOld(qint64 frame) const;
  HistoryState history;
  std::optional<RerunState> rerun;
  bool live = false;
  double framesPerSecond = 30.0; ///< of the recording, from the time stamps of the records

  /// Adds new records of the log; a repeated frame replaces its old record.
  void append(const std::vector<FrameRecord>& more, bool restarted);
  /// Returns one past the last frame that a record represents: the frame of the next record, unless
  /// untracked frames lie between them.
  qint64 endOf(std::size_t record) const;
  /// Returns the record of a frame, or of the last frame before it within a coarse step; null if
  /// there is none.
  const FrameRecord* at(qint64 frame) const;
  /// Time of a frame in seconds, from its record or from the frame rate.
  double secondsOf(qint64 frame) const;
  /// Whether any frame lacks the image of this camera.
  bool hasDropouts(std::size_t camera) const { return (missing_ >> camera & 1U) != 0; }
  /// Whether the user corrected the position of this target in this frame.
  bool isCorrected(std::size_t target, qint64 frame) const;
  /// The frame of the nearest marker after (1) or before (-1) a frame; nothing: there is none.
  std::optional<qint64> nextMarker(qint64 from, int direction) const;
  /// "Frame 132, 4.400 s: ball held (0.99) · …".
  QString describe(qint64 frame) const;

private:
  std::uint64_t missing_ = 0;
};

} // namespace dewpoint::ui
