// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_guide.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace dewpoint::ui {

class BoardCalibrator;
class BoardMap;

/// Guidance for live cameras: buttons and, for each camera, its coverage, sharpness, accuracy and
/// the view to show next.
class BoardLive : public QWidget {
  Q_OBJECT
public:
  explicit BoardLive(BoardCalibrator& calibrator, QWidget* parent = nullptr);

private:
  /// Widgets for one camera.
  struct Row {
    BoardMap* map;
    QLabel* name;
    QLabel* advice;
    QLabel* accuracy;
    QLabel* sharpness;
    QProgressBar* holdProgress;
  };
  void createWidgets();
  void retranslateUi();
  void refresh();
  void followGuide();
  void makeRows(std::size_t count);
  void fillRow(const Row& row, const BoardGuideState& state, std::size_t camera);

  BoardCalibrator& calibrator_;
  QPushButton* start_;
  QPushButton* capture_;
  QPushButton* floor_;
  QPushButton* next_;
  QPushButton* display_;
  QPushButton* finish_;
  QLabel* overall_;
  QWidget* list_;
  QGridLayout* grid_;
  std::vector<Row> rows_;
};

} // namespace dewpoint::ui
