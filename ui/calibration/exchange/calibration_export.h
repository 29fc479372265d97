// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_exchange.h"
#include "ui/calibration/exchange/exchange_dialog.h"

namespace dewpoint::ui {

class Document;

/// Dialog that exports the calibration of the project's cameras in the format of another tool. A
/// preview shows the choices made and any information that is lost.
class CalibrationExportDialog : public ExchangeDialog {
  Q_OBJECT
public:
  explicit CalibrationExportDialog(Document& document, QWidget* parent = nullptr);

  void chooseFile() override;

protected:
  Preview makePreview() override;
  void performExchange() override;
  void retranslateFields() override;

private:
  const CalibrationFormat& format() const;
  CalibrationOutput target() const;
  bool isFolder() const;
  /// Returns the ending of a file in the chosen format; empty if the format is a folder.
  QString ending() const;
  QString proposedFile() const;
  void formatChanged();
  /// Shows a conversion. `replaced` is the existing file that would be overwritten, or empty if
  /// there is none.
  void applyResult(const Result<CalibrationConversion>& outcome, const QString& replaced);
  void finish(const Result<CalibrationConversion>& written);
  QString textOf(const CalibrationConversion& conversion, const QString& replaced) const;

  Document& document_;
  QComboBox* format_;
  QComboBox* unit_;
  QLabel* formatLabel_;
  QLabel* unitLabel_;
};

} // namespace dewpoint::ui
