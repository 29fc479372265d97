// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/session/run/result_settings.h"
#include "core/session/run/snapshot.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace dewpoint::ui {

/// What a timeline shows, apart from the selection.
struct TimelineModel {
  std::vector<FrameRecord> records; ///< by rising frame; old ones in coarse steps
  QStringList targets;
  QStringList cameras;
  std::vector<ProjectMarker> markers;
  std::vector<PositionCorrection> corrections; ///< by rising frame
  std::vector<FrameSpan> oldResults;           ///< those of earlier settings, by rising frame
  bool isOld(qint64 frame) const;
  HistoryState history;
  std::optional<RerunState> rerun;
  bool live = false;
  double framesPerSecond = 30.0; ///< of the recording, by the time stamps of the records

  /// Takes in what is new in the log; a frame that comes again replaces the old one.
  void append(const std::vector<FrameRecord>& more, bool restarted);
  /// One past the last frame that a record stands for: the next record's, unless there are frames
  /// between that were never tracked.
  qint64 endOf(std::size_t record) const;
  /// The record of a frame, or of the last one before it within a coarse step; null when there is
  /// none.
  const FrameRecord* at(qint64 frame) const;
  /// Time of a frame in seconds, from its record or by the rate.
  double secondsOf(qint64 frame) const;
  /// Whether any frame lacks the image of this camera.
  bool hasDropouts(std::size_t camera) const { return (missing_ >> camera & 1U) != 0; }
  /// Whether the user has said where this target is at this frame.
  bool isCorrected(std::size_t target, qint64 frame) const;
  /// "Frame 132, 4.400 s: ball held (0.99) · …".
  QString describe(qint64 frame) const;

private:
  std::uint64_t missing_ = 0;
};

} // namespace dewpoint::ui
