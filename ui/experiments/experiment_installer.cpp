// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/experiment_installer.h"

#include "ui/experiments/experiment_dialog.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

namespace dewpoint::ui {

void installExperiments(const Workbench& bench) {
  bench.onTriggered("actionExperiments", &bench.window, [bench] {
    auto* dialog = bench.window.findChild<ExperimentDialog*>();
    if (dialog == nullptr) {
      dialog = new ExperimentDialog(&bench.window);
      QObject::connect(dialog, &ExperimentDialog::failed, &bench.messages, &MessageBar::showError);
    }
    Workbench::presentDialog(dialog);
  });
}

} // namespace dewpoint::ui
