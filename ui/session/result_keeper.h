// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/change_rule.h"

#include <QObject>

class QTimer;

namespace dewpoint::session {
class Session;
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Keeps the results of a recording consistent with the current settings, according to the
/// ChangeRule. Once the settings have not changed for a short time, it tracks frames with old
/// results again, or offers to do so.
class ResultKeeper : public QObject {
  Q_OBJECT
public:
  explicit ResultKeeper(QObject* parent = nullptr);

  /// Watches a run; null: the run is over.
  void watch(Session* session);
  /// Sets the limit in seconds below which tracking again counts as quick.
  void setQuick(double seconds) { quickSeconds_ = seconds; }
  /// Reports that a setting of the run was changed.
  void edited();
  /// Reports that the user plays, restarts or tracks again: no frames are tracked again
  /// automatically before the next change.
  void leaveAlone();
  /// Processes the newest snapshot. `wentBack`: the log of the run starts over.
  void see(const TrackSnapshot& snapshot, bool wentBack);
  /// Tracks again from the first old result on; the frame shown stays.
  void trackAgain();

  /// Results that do not match the current settings; none for live cameras.
  const OldResults& old() const { return old_; }
  /// Whether frames are being tracked again while the view stays and the snapshots do not show it.
  bool isRenewing() const { return renewing_ != Renewing::No && !isRerunning_; }

Q_SIGNALS:
  void oldResultsChanged();
  /// Whether results of earlier settings can be tracked again.
  void offered(bool offers);
  /// The frames of `trackAgain()` are done or were given up.
  void renewed();

private:
  enum class Renewing { No, Requested, UnderWay };
  void giveUp();
  void setOld(OldResults old);
  void setOffered(bool offers);
  void apply();

  Session* session_ = nullptr;
  QTimer* quiet_;   ///< settings change again and again while a slider is dragged
  QTimer* timeout_; ///< with frames that are to be tracked again
  double quickSeconds_ = ChangeRule::kQuick;
  OldResults old_;
  bool isLive_ = true;
  bool isPlaying_ = false;
  bool isRerunning_ = false;
  bool isEdited_ = false;
  bool offers_ = false;
  Renewing renewing_ = Renewing::No;
};

} // namespace dewpoint::ui
