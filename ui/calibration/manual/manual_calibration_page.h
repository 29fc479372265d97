// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QLabel;

namespace dewpoint::ui {

class ManualCalibration;
class PointCalibrator;

/// Calibration dock page for adjusting cameras by hand.
class ManualCalibrationPage : public QWidget {
  Q_OBJECT
public:
  ManualCalibrationPage(ManualCalibration& manual, PointCalibrator& points,
                        QWidget* parent = nullptr);

private:
  void retranslateUi();
  /// Lets Esc release the held points of all images, whichever part of the window has the focus.
  void makeReleaseKey(ManualCalibration& manual, PointCalibrator& points);

  QLabel* guide_;
  QLabel* remark_;
  QLabel* cameraTitle_;
  QLabel* gridTitle_;
  QLabel* pointsTitle_;
};

} // namespace dewpoint::ui
