// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration_exchange.h"
#include "ui/calibration/exchange/exchange_dialog.h"

#include <memory>

namespace dewpoint::ui {

class CameraListModel;
class Document;

/// Takes the calibration of any tool into the project: asks what the file leaves open, shows what
/// was decided and what would change, and makes it one step of the document.
class CalibrationImportDialog : public ExchangeDialog {
  Q_OBJECT
public:
  /// `cameras`: those of the document, from which one is chosen.
  CalibrationImportDialog(Document& document, const CameraListModel& cameras,
                          QWidget* parent = nullptr);

  void chooseFile() override;

protected:
  Preview preview() override;
  void accepted() override;
  void retranslateFields() override;

private:
  ImportRequest request() const;
  void applyResult(const Result<CalibrationImport>& made);
  void applyError(const Error& error);
  void mark(ImportQuestion question);
  void fillCameras();

  Document& document_;
  const CameraListModel& cameras_;
  QComboBox* format_;
  QComboBox* unit_;
  QComboBox* lens_;
  QLineEdit* size_;
  QComboBox* poses_;
  QComboBox* camera_;
  std::vector<QLabel*> labels_; ///< by ImportQuestion, from Format on
  QPushButton* folder_;
  std::shared_ptr<const CalibrationImport> made_;
};

} // namespace dewpoint::ui
