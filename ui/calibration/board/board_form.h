// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace dewpoint::ui {

class BoardCalibrator;

/// Fields that describe the board (kind, squares, sizes, markers), and a button to print it.
class BoardForm : public QWidget {
  Q_OBJECT
public:
  explicit BoardForm(BoardCalibrator& calibrator, QWidget* parent = nullptr);

  /// Asks the user for a file and writes the board to it as PDF at actual size.
  void print();

private:
  void createWidgets();
  void connectFields();
  void retranslateUi();
  void refresh();
  void edit(const std::function<void(BoardDescription&)>& change);
  double metersPerUnit() const;

  BoardCalibrator& calibrator_;
  QLabel* kindLabel_;
  QComboBox* kind_;
  QLabel* squaresLabel_;
  QSpinBox* columns_;
  QSpinBox* rows_;
  QLabel* sizeLabel_;
  QDoubleSpinBox* size_;
  QComboBox* unit_;
  QLabel* markerLabel_;
  QLabel* dictionaryLabel_;
  QDoubleSpinBox* marker_;
  QComboBox* dictionary_;
  QCheckBox* legacy_;
  QCheckBox* inverted_;
  QLabel* summary_;
  QPushButton* print_;
  QComboBox* paper_;
};

} // namespace dewpoint::ui
