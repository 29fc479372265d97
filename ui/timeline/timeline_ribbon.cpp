// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_ribbon.h"

#include "core/session/snapshot/snapshot_state.h"
#include "ui/style/theme.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kHeldHeight = 4.0;    ///< pixels, of a target that surely is there
constexpr double kMostHeldShare = 0.6; ///< of the row, of a target held in spite of all doubt
constexpr float kHeldStrength = 0.6F;  ///< of the color
constexpr float kGroundStrength = 0.3F;
constexpr double kStretchEdge = 2.0; ///< pixels, of what is not held

/// What stands behind a ribbon's color, so that it is not color alone that tells.
Qt::BrushStyle patternOf(TargetStatus status) {
  using enum TargetStatus;
  return status == Lost        ? Qt::DiagCrossPattern
         : status == Ambiguous ? Qt::Dense4Pattern
                               : Qt::BDiagPattern;
}

/// A stretch of one status; where several frames fall on one pixel, the worst is drawn.
struct Stretch {
  double begin = 0.0;
  double end = 0.0;
  TargetStatus status = TargetStatus::Held;
  double existenceProbability = 1.0;
};

std::ptrdiff_t badness(TargetStatus status) {
  using enum TargetStatus;
  static constexpr std::array kFromTheBest{Gone, Held, Ambiguous, Searching, Lost};
  return std::ranges::find(kFromTheBest, status) - kFromTheBest.begin();
}

std::vector<Stretch> stretchesOf(const TimelineModel& model, const TimelineScale& scale,
                                 std::size_t target) {
  std::vector<Stretch> stretches;
  const auto& records = model.records;
  for (std::size_t k = 0; k < records.size(); ++k) {
    const qint64 next = model.endFrameOf(k);
    if (static_cast<double>(next) < scale.shownBegin() ||
        static_cast<double>(records[k].frame) > scale.shownEnd() ||
        target >= records[k].targets.size()) {
      continue;
    }
    const FrameRecord::Entry& entry = records[k].targets[target];
    const Stretch now{scale.xOf(static_cast<double>(records[k].frame)),
                      scale.xOf(static_cast<double>(next)), entry.status,
                      static_cast<double>(entry.existenceProbability)};
    Stretch* last = stretches.empty() ? nullptr : &stretches.back();
    const bool same = last != nullptr && last->status == now.status &&
                      std::abs(last->existenceProbability - now.existenceProbability) < 0.02 &&
                      now.begin - last->end < 0.5;
    const bool narrow = last != nullptr && last->end - last->begin < 1.0;
    if (same) {
      last->end = now.end;
    } else if (narrow) {
      last->end = now.end;
      last->existenceProbability = std::min(last->existenceProbability, now.existenceProbability);
      last->status = badness(now.status) > badness(last->status) ? now.status : last->status;
    } else {
      stretches.push_back(now);
    }
  }
  return stretches;
}

void paintHeld(QPainter& painter, const QRectF& stretch, double existenceProbability,
               QColor color) {
  const double least = std::min(kHeldHeight, stretch.height());
  const double most = std::max(least, kMostHeldShare * stretch.height());
  const double doubt = 1.0 - std::clamp(existenceProbability, 0.0, 1.0);
  const double height = std::round(least + doubt * (most - least));
  color.setAlphaF(kHeldStrength);
  painter.fillRect(QRectF(stretch.left(), std::round(stretch.center().y() - 0.5 * height),
                          stretch.width(), height),
                   color);
}

void paintTrouble(QPainter& painter, const QRectF& stretch, TargetStatus status, QColor color) {
  QColor ground = color;
  ground.setAlphaF(kGroundStrength);
  painter.fillRect(stretch, ground);
  painter.fillRect(stretch, QBrush(color, patternOf(status)));
  painter.fillRect(QRectF(stretch.left(), stretch.top(), stretch.width(), kStretchEdge), color);
  painter.fillRect(
      QRectF(stretch.left(), stretch.bottom() - kStretchEdge, stretch.width(), kStretchEdge),
      color);
}

} // namespace

void paintRibbon(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                 const QRectF& row, std::size_t target, const QPalette& palette) {
  painter.fillRect(row, palette.color(QPalette::Base));
  for (const Stretch& stretch : stretchesOf(model, scale, target)) {
    if (stretch.status == TargetStatus::Gone) {
      continue;
    }
    const QColor color = trackingStateColor(trackingState(stretch.status), palette);
    const double begin = std::max(row.left(), stretch.begin);
    const double end = std::min(row.right(), stretch.end);
    const QRectF bar(begin, row.top(), std::max(1.0, end - begin), row.height());
    if (stretch.status == TargetStatus::Held) {
      paintHeld(painter, bar, stretch.existenceProbability, color);
    } else {
      paintTrouble(painter, bar, stretch.status, color);
    }
  }
}

void paintNothingTrackedText(QPainter& painter, const QRectF& rows, const QPalette& palette) {
  painter.setPen(palette.color(QPalette::PlaceholderText));
  painter.drawText(rows, Qt::AlignCenter,
                   QCoreApplication::translate(
                       "Timeline", "The state of each target appears here during tracking."));
}

} // namespace dewpoint::ui
