// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/mainwindow/target_speed.h"
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

/// The line at the bottom: whether the target is held, where it is and how exactly that is known,
/// how fast it is; why it is not held; which frame is shown. What only an expert asks for is in
/// RunDetails, behind a button. Figures keep their places while they change, and where there is no
/// room for all, those at the right go first.
class StatusBarPanel : public QWidget {
  Q_OBJECT
public:
  explicit StatusBarPanel(QWidget* parent = nullptr);

  /// The frame shown; null: there is nothing to measure.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// The target that is chosen; -1: the one that needs attention.
  void setTarget(int target);
  /// Held while two cameras see the target; searching at first and for a second after a loss.
  HoldState state() const { return state_; }

  QSize minimumSizeHint() const override;

protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private:
  QLabel* figure(const char* name);
  void retranslateUi();
  void clear();
  void refresh();
  void showPlace(const TargetSnapshot& target);
  void showBox(const BoxEstimate& estimate);
  void clearBelief(); ///< what is not known now: not that of another frame
  void applyPalette();
  /// Shows as many figures as there is room for.
  void fit();

  QLabel* held_;
  QLabel* position_;
  QLabel* spread_;
  QLabel* speed_;
  ElidedLabel* reason_; ///< why it is not held
  QLabel* playing_;
  QLabel* frame_;
  QLabel* rate_;
  QToolButton* more_;
  RunDetails* details_;
  /// In the order in which they go where there is no room.
  std::vector<QWidget*> dispensable_;
  TrackSnapshotPtr snapshot_;
  TargetSpeed motion_;
  int target_ = -1;
  QString name_;      ///< of the target shown, when there are several
  QString stateText_; ///< shown instead of the word of the state; empty: that word
  HoldState state_ = HoldState::NoImages;
};

} // namespace dewpoint::ui
