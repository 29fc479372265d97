// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QToolButton>

#include <vector>

class QActionGroup;

namespace dewpoint::ui {

/// Button next to Play that shows the playback speed and offers all speeds in a menu. Handles the
/// speed actions.
class SpeedButton : public QToolButton {
  Q_OBJECT
public:
  explicit SpeedButton(const Workbench& bench, QWidget* parent = nullptr);

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  void connectActions();
  void setSpeed(double speed);
  /// Changes the speed by one step, up (1) or down (-1).
  void step(int direction);
  void showPace();

  Workbench bench_;
  QActionGroup* speeds_;
};

} // namespace dewpoint::ui
