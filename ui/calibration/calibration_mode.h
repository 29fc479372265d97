// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QPointer>
#include <QString>

#include <functional>
#include <vector>

namespace dewpoint::ui {

class CalibrationDock;
class ManualCalibration;
class ViewDock;

/// Calibration mode of the window. The views next to the page stay live. Each calibration method
/// adds a page, and opening a page starts the mode.
class CalibrationMode : public QObject {
  Q_OBJECT
public:
  explicit CalibrationMode(const Workbench& bench);

  ManualCalibration& manualCalibration() const { return *manual_; }
  /// Adds a page to the calibration panel. The objectName of the page identifies it. `title`
  /// returns the page's title, and is called again when the language changes.
  void addPage(QWidget* page, const std::function<QString()>& title);
  /// Sets a widget that is shown above the pages of the calibration panel.
  void setHeader(QWidget* header);
  /// Starts the calibration mode with the page that has this objectName.
  void open(const QString& page);

Q_SIGNALS:
  /// Emitted when another page is shown.
  void pageChanged();
  /// Emitted when the mode starts or ends, or another page is shown, with the objectName of the
  /// page; empty if the mode has ended.
  void pageShown(const QString& page);
  /// Emitted when another tool begins to use the clicks in the images. Pages must then stop using
  /// these clicks.
  void imageClicksTakenOver();

private:
  void show(bool isShown);
  /// Returns the visible docks that no other dock covers, without the panel.
  std::vector<ViewDock*> docksInFront() const;

  Workbench bench_;
  ManualCalibration* manual_;
  CalibrationDock* pages_;
  ViewDock* dock_;
  QPointer<ViewDock> dockBefore_; ///< dock in front before the panel was opened
  bool isReturning_ = false;      ///< true while a change of page switches the mode on again
  QString page_;                  ///< last page that pageShown() was emitted for
};

} // namespace dewpoint::ui
