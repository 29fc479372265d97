// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/exchange/exchange_installer.h"

#include "ui/calibration/exchange/calibration_export.h"
#include "ui/calibration/exchange/calibration_import.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

namespace dewpoint::ui {

namespace {

/// `parts`: what the dialog is made of.
template <class Dialog, class... Parts> void open(const Workbench& bench, Parts&... parts) {
  auto* dialog = bench.window.findChild<Dialog*>();
  if (dialog == nullptr) {
    dialog = new Dialog(parts..., &bench.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &ExchangeDialog::failed, &bench.messages, &MessageBar::showError);
    QObject::connect(dialog, &ExchangeDialog::completed, &bench.messages, &MessageBar::showNotice);
  }
  Workbench::presentDialog(dialog);
}

} // namespace

void installCalibrationExchange(const Workbench& bench) {
  bench.onTriggered("actionImportCalibration", &bench.window, [bench] {
    open<CalibrationImportDialog>(bench, bench.document, bench.cameras);
  });
  bench.onTriggered("actionExportCalibration", &bench.window,
                    [bench] { open<CalibrationExportDialog>(bench, bench.document); });
  bench.requireRun({"actionImportCalibration", "actionExportCalibration"});
}

} // namespace dewpoint::ui
