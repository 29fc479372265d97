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

/// Keeps the results of a recording those of the settings shown, by the ChangeRule: waits until the
/// settings have rested for a moment, and then tracks again what other settings gave, or says that
/// this can be done.
class ResultKeeper : public QObject {
  Q_OBJECT
public:
  explicit ResultKeeper(QObject* parent = nullptr);

  /// A run begins, or is over: null.
  void watch(Session* session);
  /// Tracking again that is expected to take less than so many seconds is quick.
  void setQuick(double seconds) { quickSeconds_ = seconds; }
  /// A setting of the run was changed.
  void edited();
  /// The user plays, restarts or tracks again: nothing is tracked again unasked before the next
  /// change.
  void leaveAlone();
  /// The newest snapshot; `wentBack`: what was logged of the run begins again.
  void see(const TrackSnapshot& snapshot, bool wentBack);
  /// Tracks again from the first old result on; what is shown stays shown.
  void trackAgain();

  /// The results that are not of the settings of now; none of live cameras.
  const OldResults& old() const { return old_; }
  /// Whether frames are tracked again while the view is kept, and no snapshot tells of it.
  bool isRenewing() const { return renewing_ != Renewing::No && !isRerunning_; }

Q_SIGNALS:
  void oldResultsChanged();
  /// The results are of earlier settings, and could be tracked again; false: no more.
  void offered(bool offers);
  /// The frames of trackAgain() are there, or were given up.
  void renewed();

private:
  enum class Renewing { No, Requested, UnderWay };
  void giveUp();
  void setOld(OldResults old);
  void setOffered(bool offers);
  void apply();

  Session* session_ = nullptr;
  QTimer* quiet_;    ///< settings change again and again while a slider is dragged
  QTimer* patience_; ///< with frames that are to be tracked again
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
