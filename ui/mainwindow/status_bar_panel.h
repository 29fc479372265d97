// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/target_speed.h"
#include "ui/style/theme.h"

#include <QString>
#include <QWidget>

#include <memory>
#include <vector>

class QLabel;
class QToolButton;

namespace dewpoint::session {
struct TargetSnapshot;
struct TrackSnapshot;
} // namespace dewpoint::session
namespace dewpoint::tracking {
struct BoxEstimate;
} // namespace dewpoint::tracking

namespace dewpoint::ui {

class ElidedLabel;
class RunDetails;

using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Status bar with the state of a target, its position with uncertainty, its speed, the reason why
/// it is not tracked, and the frame shown. A button opens RunDetails, with values for experts.
/// Values do not move while they change. If there is not enough room, the rightmost values are
/// hidden first.
class StatusBarPanel : public QWidget {
  Q_OBJECT
public:
  explicit StatusBarPanel(QWidget* parent = nullptr);

  /// Sets the snapshot to describe. If it is null, no values are shown.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Sets the index of the target to describe; -1: the target that needs attention.
  void setTarget(int target);
  /// Returns the tracking state shown: the state of the described target or, if there is only one
  /// target, of the whole snapshot.
  TrackingState state() const { return state_; }

  QSize minimumSizeHint() const override;

Q_SIGNALS:
  /// Emitted when the frame number is clicked.
  void frameClicked();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override; ///< clicks on the frame number
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QLabel* addValueLabel(const char* name);
  void retranslateUi();
  void clear();
  void refresh();
  void showPosition(const TargetSnapshot& target);
  void showBox(const BoxEstimate& estimate);
  void clearEstimate(); ///< clears values of an earlier frame that are now unknown
  void applyPalette();
  /// Shows as many values as fit.
  void hideOverflow();

  QLabel* held_;
  QLabel* position_;
  QLabel* spread_;
  QLabel* speed_;
  ElidedLabel* reason_; ///< why the target is not held
  QLabel* playing_;
  QLabel* frame_;
  QLabel* rate_;
  QToolButton* more_;
  RunDetails* details_;
  /// Widgets that are hidden when there is not enough room, in the order in which they are hidden.
  std::vector<QWidget*> hideOrder_;
  TrackSnapshotPtr snapshot_;
  TargetSpeed motion_;
  int target_ = -1;
  QString name_;      ///< name of the target shown, if there are several targets
  QString stateText_; ///< shown instead of the state word; if empty, the state word is shown
  TrackingState state_ = TrackingState::NoImages;
};

} // namespace dewpoint::ui
