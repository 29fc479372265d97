// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_installer.h"

#include "ui/calibration/calibration_mode.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/wand/wand_calibration_page.h"
#include "ui/calibration/wand/wand_calibrator.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

namespace dewpoint::ui {

void installWandCalibration(const Workbench& bench, CalibrationMode& mode) {
  auto* wand = new WandCalibrator({bench.document, mode.manualCalibration(), bench.selection,
                                   bench.targets, bench.session.opener(),
                                   [run = &bench.session] { return run->session(); }},
                                  &mode);
  mode.addPage(new WandCalibrationPage(*wand), [] { return WandCalibrationPage::tr("Wand"); });
  bench.onTriggered("actionCalibrateWand", wand,
                    [&mode] { mode.open(QStringLiteral("wandPage")); });
  bench.requireRun({"actionCalibrateWand"});
  bench.connectView(wand);
  MessageBar* messages = &bench.messages;
  QObject::connect(wand, &WandCalibrator::failed, messages, &MessageBar::showError);
  QObject::connect(wand, &WandCalibrator::saved, messages, [messages](const QString& file) {
    messages->showNotice(WandCalibrationPage::tr("Saved %1.").arg(file));
  });
}

} // namespace dewpoint::ui
