// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_model.h"

#include "core/trajectory/motion.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/text/tracking_state_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace dewpoint::ui {

void TimelineModel::append(const std::vector<FrameRecord>& more, bool restarted) {
  if (restarted) {
    records.clear();
    missing_ = 0;
  }
  for (const FrameRecord& record : more) {
    while (!records.empty() && records.back().frame >= record.frame) {
      records.pop_back();
    }
    records.push_back(record);
    missing_ |= record.missingCameraBits;
  }
  if (records.size() > 1) {
    const FrameRecord& first = records[records.size() - std::min<std::size_t>(records.size(), 60)];
    const double span = records.back().time - first.time;
    if (span > 0.0) {
      framesPerSecond = static_cast<double>(records.back().frame - first.frame) / span;
    }
  }
}

void TimelineModel::setSourceFrameRate(double rate) {
  if (records.size() < 2 && rate > 0.0) {
    framesPerSecond = rate;
  }
}

qint64 TimelineModel::endFrameOf(std::size_t record) const {
  const std::int64_t frame = records[record].frame;
  if (record + 1 == records.size()) {
    return frame + 1;
  }
  const std::int64_t before = record > 0 ? frame - records[record - 1].frame : 1;
  const std::int64_t step = records[record + 1].frame - frame;
  // Old records stand in coarse steps that fall by halves.
  return step <= std::max(kMaxSkippedFrames, 2 * before) ? frame + step : frame + 1;
}

const FrameRecord* TimelineModel::recordAt(qint64 frame) const {
  const auto next = std::upper_bound(
      records.begin(), records.end(), frame,
      [](qint64 number, const FrameRecord& record) { return number < record.frame; });
  if (next == records.begin() || (next == records.end() && std::prev(next)->frame < frame)) {
    return nullptr; // before the first, or not tracked yet
  }
  const auto record = std::prev(next);
  return frame < endFrameOf(std::size_t(record - records.begin())) ? &*record : nullptr;
}

double TimelineModel::secondsOf(qint64 frame) const {
  const FrameRecord* record = recordAt(frame);
  const FrameRecord* known = record != nullptr  ? record
                             : !records.empty() ? &records.back()
                                                : nullptr;
  return known != nullptr
             ? known->time + static_cast<double>(frame - known->frame) / framesPerSecond
             : static_cast<double>(frame) / framesPerSecond;
}

qint64 TimelineModel::frameAtSeconds(double seconds) const {
  const auto next = std::ranges::upper_bound(records, seconds, {}, &FrameRecord::time);
  if (records.empty()) {
    return std::llround(seconds * framesPerSecond);
  }
  const FrameRecord& known = next == records.begin() ? records.front() : *std::prev(next);
  const qint64 frame = known.frame + std::llround((seconds - known.time) * framesPerSecond);
  return next == records.end() ? frame : std::min<qint64>(frame, next->frame);
}

bool TimelineModel::isCorrected(std::size_t target, qint64 frame) const {
  return std::ranges::any_of(corrections, [&](const PositionCorrection& correction) {
    return correction.frame == frame && !correction.trackedFrom &&
           static_cast<std::size_t>(correction.target) == target;
  });
}

bool TimelineModel::hasOldResult(qint64 frame) const {
  return std::ranges::any_of(oldResults, [frame](const ResultRange& range) {
    return range.firstFrame <= frame && frame <= range.lastFrame;
  });
}

std::optional<qint64> TimelineModel::nextMarkerFrame(qint64 from, int direction) const {
  std::optional<qint64> nearest;
  for (const ProjectMarker& marker : markers) {
    const bool ahead = direction > 0 ? marker.frame > from : marker.frame < from;
    if (ahead && (!nearest || std::abs(marker.frame - from) < std::abs(*nearest - from))) {
      nearest = marker.frame;
    }
  }
  return nearest;
}

QString TimelineModel::descriptionOf(qint64 frame) const {
  QString text = QCoreApplication::translate("Timeline", "Frame %1, %2")
                     .arg(frameNumberText(frame), secondsText(secondsOf(frame), 2));
  const FrameRecord* record = recordAt(frame);
  if (record == nullptr) {
    return text + QLatin1Char('\n') + QCoreApplication::translate("Timeline", "not tracked");
  }
  if (record->cameraProblems != nullptr) {
    for (const Error& problem : *record->cameraProblems) {
      text += QStringLiteral("\n◆ ") + errorText(problem);
    }
  }
  if (hasOldResult(frame)) {
    text += QLatin1Char('\n') +
            QCoreApplication::translate("Timeline", "tracked with earlier settings");
  }
  for (std::size_t k = 0; k < record->targets.size(); ++k) {
    const FrameRecord::Entry& entry = record->targets[k];
    if (entry.status == TargetStatus::Gone) {
      continue;
    }
    text += QStringLiteral("\n%1 %2 (%3)")
                .arg(targetNames.value(static_cast<int>(k)),
                     trackingStateText(trackingState(entry.status)),
                     numberText(static_cast<double>(entry.existenceProbability), 2));
    if (const QString reason = reasonText(entry.cameraReports, cameraNames); !reason.isEmpty()) {
      text += QStringLiteral(" – ") + reason;
    }
    if (isCorrected(k, frame)) {
      text += QStringLiteral(" – ") + QCoreApplication::translate("Timeline", "corrected");
    }
  }
  return text;
}

} // namespace dewpoint::ui
