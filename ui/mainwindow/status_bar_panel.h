// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/theme.h"

#include <QString>
#include <QWidget>

#include <memory>

class QLabel;

namespace dewpoint::session {
struct TargetSnapshot;
struct TrackSnapshot;
} // namespace dewpoint::session
namespace dewpoint::tracking {
struct BoxEstimate;
} // namespace dewpoint::tracking

namespace dewpoint::ui {

class ElidedLabel;

using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// The line of numbers at the bottom: frame, rate, time per iteration, effective sample size,
/// spread, and whether the target is held. Figures keep their positions while they change.
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

protected:
  void changeEvent(QEvent* event) override;

private:
  QLabel* figure(const char* name);
  void retranslateUi();
  void clear();
  void refresh();
  void showPlace(const TargetSnapshot& target);
  void showBox(const BoxEstimate& estimate);
  void clearBelief(); ///< what is not known now: not that of another frame
  void applyPalette();

  QLabel* playing_;
  QLabel* frame_;
  QLabel* rate_;
  QLabel* time_;
  QLabel* sampleSize_;
  QLabel* spread_;
  QLabel* position_;
  ElidedLabel* reason_; ///< why it is not held
  QLabel* held_;
  TrackSnapshotPtr snapshot_;
  int target_ = -1;
  QString name_;      ///< of the target shown, when there are several
  QString stateText_; ///< shown instead of the word of the state; empty: that word
  HoldState state_ = HoldState::NoImages;
};

} // namespace dewpoint::ui
