// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace dewpoint::ui {

class CoverageMap;
class WandCalibrator;

/// Collects wand views from live cameras. Shows a button to start and stop, the elapsed time, and
/// what each camera has seen.
class WandWaving : public QWidget {
  Q_OBJECT
public:
  explicit WandWaving(WandCalibrator& calibrator, QWidget* parent = nullptr);

private:
  void retranslateUi();
  void refresh();
  void showCameras();
  void makeCameraRows(std::size_t count);

  WandCalibrator& calibrator_;
  QPushButton* wave_;
  QLabel* state_;
  QGridLayout* grid_;
  struct CameraPart {
    CoverageMap* map;
    QLabel* text;
  };
  std::vector<CameraPart> cameras_;
};

} // namespace dewpoint::ui
