// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

namespace dewpoint::ui {

class BoardCalibrator;
class CameraView;

/// Camera view overlay for live board calibration. Draws the outline of the detected board and
/// highlights it briefly when the view is captured. Ignores mouse and keyboard input.
class BoardLayer : public QWidget {
  Q_OBJECT
public:
  BoardLayer(int camera, CameraView* view, BoardCalibrator& calibrator);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  void refresh();

  std::size_t camera_;
  CameraView* view_;
  BoardCalibrator& calibrator_;
  std::size_t taken_ = 0;
  bool highlighted_ = false;
};

} // namespace dewpoint::ui
