// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <vector>

class QHBoxLayout;
class QToolButton;

namespace dewpoint::ui {

class CalibrationGuide;

/// Row above the pages of the calibration panel with the steps of the chosen way to calibrate. Each
/// step has a symbol, such as a check mark, and a number for its progress. A click on a step opens
/// its page. Hidden until the user follows the guide.
class StepStrip : public QWidget {
  Q_OBJECT
public:
  explicit StepStrip(CalibrationGuide& guide, QWidget* parent = nullptr);

private:
  void refresh();
  void setCount(int count);

  CalibrationGuide& guide_;
  QHBoxLayout* row_;
  std::vector<QToolButton*> buttons_;
};

} // namespace dewpoint::ui
