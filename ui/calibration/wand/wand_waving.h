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

/// Waving before live cameras: the button that begins and ends it, how long, and what each camera
/// saw so far.
class WandWaving : public QWidget {
  Q_OBJECT
public:
  explicit WandWaving(WandCalibrator& calibrator, QWidget* parent = nullptr);

private:
  void retranslateUi();
  void refresh();
  void showCameras();
  void makeCameras(std::size_t count);

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
