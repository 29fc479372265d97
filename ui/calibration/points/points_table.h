// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace dewpoint::ui {

class ManualCalibration;
class PointCalibrator;

/// Table of the measured points, with editable names and positions and with residuals in pixels and
/// millimeters. Has buttons to click the points in images and to compute the cameras from them.
class PointsTable : public QWidget {
  Q_OBJECT
public:
  /// Columns of the table.
  enum Column { Name, X, Y, Z, Clicks, Pixels, Millimeters, ColumnCount };

  PointsTable(PointCalibrator& points, ManualCalibration& manual, QWidget* parent = nullptr);

private:
  void createWidgets();
  void retranslateUi();
  void refresh();
  void fillRow(int row);
  void widenColumns();
  void showResult();
  void setCell(int row, int column, const QString& text, bool editable);
  void edited(int row, int column);
  void showResiduals();

  PointCalibrator& points_;
  ManualCalibration& manual_;
  QTableWidget* table_;
  QPushButton* add_;
  QPushButton* remove_;
  QPushButton* click_;
  QPushButton* forget_;
  QCheckBox* focal_;
  QPushButton* solve_;
  QLabel* resultText_;
  QPushButton* accept_;
  bool filling_ = false;
};

} // namespace dewpoint::ui
