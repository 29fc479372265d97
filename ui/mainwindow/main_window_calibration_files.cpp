// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations of other tools: in and out.
#include "ui/actions/action_registry.h"
#include "ui/calibration/exchange/calibration_export.h"
#include "ui/calibration/exchange/calibration_import.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/widgets/message_bar.h"

#include <QAction>

namespace dewpoint::ui {

void MainWindow::makeCalibrationFiles() {
  const auto open = [this]<class Dialog>(Dialog* dialog) {
    if (dialog == nullptr) {
      dialog = new Dialog(*document_, this);
      dialog->setAttribute(Qt::WA_DeleteOnClose);
      connect(dialog, &ExchangeDialog::failed, messages_, &MessageBar::showError);
      connect(dialog, &ExchangeDialog::done, messages_, &MessageBar::showNotice);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
  };
  connect(action("actionImportCalibration"), &QAction::triggered, this,
          [this, open] { open(findChild<CalibrationImportDialog*>()); });
  connect(action("actionExportCalibration"), &QAction::triggered, this,
          [this, open] { open(findChild<CalibrationExportDialog*>()); });
}

} // namespace dewpoint::ui
