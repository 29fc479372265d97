// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/rewind/change_rule.h"

#include <QObject>

class QTimer;

namespace dewpoint::session {
class Session;
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Keeps the results of a recording consistent with the current settings, according to the rules in
/// ChangeRule (when to do so without asking the user). A short time after the last change of the
/// settings, it tracks frames with old results again, or offers to do so.
class ResultRefresher : public QObject {
  Q_OBJECT
public:
  explicit ResultRefresher(QObject* parent = nullptr);

  /// Watches a run; null if the run is over.
  void watchSession(Session* session);
  /// Sets the longest expected duration (seconds) for which frames are tracked again without asking
  /// the user.
  void setQuickRerunLimit(double seconds) { quickSeconds_ = seconds; }
  /// Reports that a setting of the run was changed.
  void onSettingEdited();
  /// Reports that the user plays, restarts or tracks again. No frames are tracked again
  /// automatically until the next change of the settings.
  void suspend();
  /// Processes the newest snapshot. `wentBack` is true if the run has gone back to an earlier frame
  /// or restarted since the previous snapshot.
  void processSnapshot(const TrackSnapshot& snapshot, bool wentBack);
  /// Tracks frames again, starting at the first frame whose result is from earlier settings. The
  /// frame shown stays the same.
  void trackAgain();

  /// Returns the results that do not match the current settings; none for live cameras.
  const OldResults& oldResults() const { return old_; }
  /// Returns whether tracking frames again in the background was requested or has begun, although
  /// the newest snapshot does not report it.
  bool isRefreshing() const { return refreshing_ != Refreshing::No && !isRerunning_; }

Q_SIGNALS:
  /// Emitted when the return value of oldResults() has changed.
  void oldResultsChanged();
  /// Emitted when frames with results of earlier settings can now be tracked again (`offers` is
  /// true), or no longer can.
  void retrackOfferChanged(bool offers);
  /// Emitted when all frames requested with `trackAgain()` were tracked again, or this was
  /// abandoned.
  void refreshed();

private:
  enum class Refreshing { No, Requested, UnderWay };
  void giveUp();
  void setOld(OldResults old);
  void setOffered(bool offers);
  void apply();

  Session* session_ = nullptr;
  QTimer* quiet_;   ///< waits while the settings keep changing, for example during a slider drag
  QTimer* timeout_; ///< limits the wait for a requested rerun to begin
  double quickSeconds_ = ChangeRule::kQuickRerunSeconds;
  OldResults old_;
  bool isLive_ = true;
  bool isPlaying_ = false;
  bool isRerunning_ = false;
  bool isEdited_ = false;
  bool offers_ = false;
  Refreshing refreshing_ = Refreshing::No;
};

} // namespace dewpoint::ui
