// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QToolButton>

#include <vector>

class QActionGroup;

namespace dewpoint::ui {

/// How fast the run is played, beside Play: says the speed, and offers all of them in a menu. Does
/// the actions about speed.
class SpeedButton : public QToolButton {
  Q_OBJECT
public:
  explicit SpeedButton(const Workbench& bench, QWidget* parent = nullptr);

private:
  void connectActions();
  void setSpeed(double speed);
  /// One speed up (1) or down (-1).
  void step(int direction);
  void showPace();

  Workbench bench_;
  QActionGroup* speeds_;
};

} // namespace dewpoint::ui
