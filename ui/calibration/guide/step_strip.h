// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <vector>

class QHBoxLayout;
class QToolButton;

namespace dewpoint::ui {

class CalibrationGuide;

/// The steps of the chosen way in one row above the pages of the calibration panel, each with a
/// check mark or another symbol, and one number. A click on a step opens the page for it. Hidden
/// until the user follows the guide.
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
