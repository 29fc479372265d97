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

/// What an expert wants to know of a run, in a popup over the status line: time per iteration and
/// from frame to estimate, the time budget, effective sample size, what is kept of the past. It
/// goes on changing while it is open.
class RunDetails : public QFrame {
  Q_OBJECT
public:
  explicit RunDetails(QWidget* parent = nullptr);

  /// The frame shown and the target in it that is explained; null: nothing is known.
  void setSnapshot(const TrackSnapshotPtr& snapshot, const TargetSnapshot* target);
  /// Opens above this widget, at its right end.
  void openAbove(const QWidget* widget);

private:
  QLabel* row(const char* name);
  void retranslateUi();
  void refresh(const TrackSnapshot& snapshot, const TargetSnapshot* target);

  QGridLayout* rows_;
  QLabel* time_;
  QLabel* latency_;
  QLabel* budget_;
  QLabel* sampleSize_;
  QLabel* iterations_;
  QLabel* dropped_;
  QLabel* seed_;
  QLabel* history_;
  std::map<QLabel*, QLabel*> names_; ///< left of each
};

} // namespace dewpoint::ui
