// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;

namespace dewpoint::ui {

class WandCalibrator;
class WandWaving;

/// Calibration dock page for refining cameras with a wand: a single ball, or a stick with two
/// balls.
class WandCalibrationPage : public QWidget {
  Q_OBJECT
public:
  explicit WandCalibrationPage(WandCalibrator& calibrator, QWidget* parent = nullptr);

private:
  void retranslateUi();

  WandCalibrator& calibrator_;
  QLabel* guide_;
  QLabel* instantsTitle_;
  QLabel* wavingTitle_;
  WandWaving* waving_;
  QLabel* outcomeTitle_;
};

} // namespace dewpoint::ui
