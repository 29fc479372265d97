// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QLabel>

namespace dewpoint::ui {

struct Workbench;

/// Shows the number of the frame.
class FrameClock : public QLabel {
  Q_OBJECT
public:
  using QLabel::QLabel;
  void setSnapshot(const TrackSnapshotPtr& snapshot) {
    snapshot ? setNum(static_cast<int>(snapshot->frame)) : clear();
  }
};

void installFrameClock(const Workbench& bench);

} // namespace dewpoint::ui
