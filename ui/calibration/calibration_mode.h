// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QString>

#include <functional>

namespace dewpoint::ui {

class CalibrationDock;
class ManualCalibration;
class ViewDock;

/// Calibration mode of the window; the views beside it stay live. Each calibration method adds a
/// page, and opening a page starts the mode.
class CalibrationMode : public QObject {
  Q_OBJECT
public:
  explicit CalibrationMode(const Workbench& bench);

  ManualCalibration& manual() const { return *manual_; }
  /// `title` is called again when the language changes; the page's objectName tells it from others.
  void addPage(QWidget* page, const std::function<QString()>& title);
  /// Starts the mode with the page that has this objectName.
  void open(const QString& page);

Q_SIGNALS:
  /// Another page is in front.
  void pageChanged();

private:
  void show(bool shown);

  Workbench bench_;
  ManualCalibration* manual_;
  CalibrationDock* place_;
  ViewDock* dock_;
};

} // namespace dewpoint::ui
