// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>

#include <map>
#include <memory>

class QGridLayout;
class QLabel;

namespace dewpoint::session {
struct TargetSnapshot;
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Popup above the status bar with run details for experts: time per iteration, latency from image
/// to estimate, time budget, effective sample size, and the length of the stored history. The
/// values are updated while the popup is open.
class RunDetails : public QFrame {
  Q_OBJECT
public:
  explicit RunDetails(QWidget* parent = nullptr);

  /// Sets the snapshot and the target to describe. No values are shown for null.
  void setSnapshot(const TrackSnapshotPtr& snapshot, const TargetSnapshot* target);
  /// Opens the popup above `widget`, aligned with its right edge.
  void openAbove(const QWidget* widget);

private:
  QLabel* row(const char* name);
  void retranslateUi();
  void refresh(const TrackSnapshot& snapshot, const TargetSnapshot* target);

  QGridLayout* rows_;
  QLabel* time_;
  QLabel* latency_;
  QLabel* liveLatency_;
  QLabel* budget_;
  QLabel* sampleSize_;
  QLabel* iterations_;
  QLabel* dropped_;
  QLabel* seed_;
  QLabel* history_;
  std::map<QLabel*, QLabel*> names_; ///< label to the left of each value
};

} // namespace dewpoint::ui
