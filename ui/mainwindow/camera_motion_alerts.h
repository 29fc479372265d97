// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <QObject>
#include <QString>

#include <cstdint>
#include <set>
#include <tuple>

namespace dewpoint::ui {

class MessageBar;

/// Says in the message bar that a camera was bumped, and what to do: one click solves it again
/// where that is possible. Each state of a bump is said once; whoever closes the bar is left alone.
class CameraMotionAlerts : public QObject {
  Q_OBJECT
public:
  explicit CameraMotionAlerts(MessageBar& bar, QObject* parent = nullptr);

  /// The moment shown; null: the run is over, and what was said counts no more.
  void setSnapshot(const TrackSnapshotPtr& snapshot);

Q_SIGNALS:
  void resolveWanted(int camera);
  void calibrateWanted(int camera);

private:
  enum class Stage { Waiting, Solved, Unsolvable, Back };
  using Key = std::tuple<std::size_t, std::int64_t, Stage>;
  void clear();
  static Stage stageOf(const CameraMotionReport& report, const TrackSnapshot& snapshot);
  void say(const CameraMotionReport& report, Stage stage, const QString& camera);
  void withdraw();

  MessageBar& bar_;
  std::set<Key> said_;
  std::size_t count_ = 0; ///< reports of the snapshot before
  QString text_;          ///< what the bar was given last
};

} // namespace dewpoint::ui
