// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_exchange.h"
#include "ui/calibration/exchange/exchange_dialog.h"

#include <QStringList>

#include <memory>
#include <vector>

namespace dewpoint::ui {

class CameraListModel;
class Document;

/// Dialog that imports a calibration from another tool into the project. Asks for anything the file
/// does not define, shows the choices made and the resulting changes, and applies them to the
/// project in one undoable step.
class CalibrationImportDialog : public ExchangeDialog {
  Q_OBJECT
public:
  /// Creates the dialog. The user can select a camera from `cameras`, the list of the document's
  /// cameras.
  CalibrationImportDialog(Document& document, const CameraListModel& cameras,
                          QWidget* parent = nullptr);

  void chooseFile() override;

protected:
  Preview makePreview() override;
  void performExchange() override;
  void retranslateFields() override;

private:
  ImportRequest request() const;
  void applyResult(const Result<CalibrationImport>& made);
  void applyError(const Error& error);
  void highlightQuestion(ImportQuestion question);
  void fillCameras();
  /// If the names in the file do not match the cameras of the project, shows a combo box for each
  /// camera of the project. `inFile` are the names in the file; empty if they are not known.
  void fillNames(const QStringList& inFile);

  Document& document_;
  const CameraListModel& cameras_;
  QComboBox* format_;
  QComboBox* unit_;
  QComboBox* lens_;
  QLineEdit* size_;
  QComboBox* poses_;
  QComboBox* camera_; ///< follows `cameras_`; not its view, because each row is a sentence
  QComboBox* fit_;
  QWidget* names_;                      ///< holds `nameChoices_`
  std::vector<QComboBox*> nameChoices_; ///< for each camera of the project, the one in the file
  QStringList namesInFile_;             ///< offered by `nameChoices_`
  std::vector<QLabel*> labels_;         ///< indexed by ImportQuestion, starting at Format
  QPushButton* folder_;
  std::shared_ptr<const CalibrationImport> import_;
};

} // namespace dewpoint::ui
