// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QString>

#include <functional>

namespace dewpoint::ui {

class CalibrationDock;
class ManualCalibration;
class ViewDock;

/// Calibrating: a mode of the window, beside views that stay live. Each way to calibrate adds its
/// page; opening one begins the mode.
class CalibrationMode : public QObject {
  Q_OBJECT
public:
  explicit CalibrationMode(const Workbench& bench);

  ManualCalibration& hand() const { return *hand_; }
  /// `title` is called again when the language changes; the page's objectName tells it from others.
  void addPage(QWidget* page, const std::function<QString()>& title);
  /// Begins the mode with the page of this objectName.
  void open(const QString& page);

Q_SIGNALS:
  /// Another page is in front.
  void pageChanged();

private:
  void show(bool shown);

  Workbench bench_;
  ManualCalibration* hand_;
  CalibrationDock* place_;
  ViewDock* dock_;
};

} // namespace dewpoint::ui
