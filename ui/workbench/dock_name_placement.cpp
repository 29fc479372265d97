// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/dock_name_placement.h"

#include "ui/widgets/dock_title.h"
#include "ui/workbench/view_dock.h"

#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

DockNamePlacement::DockNamePlacement(QMainWindow& window, QObject* parent)
    : QObject(parent), window_(window) {}

void DockNamePlacement::addDock(ViewDock* dock) {
  connect(dock, &QDockWidget::dockLocationChanged, this, &DockNamePlacement::updateNamesSoon);
  connect(dock, &QDockWidget::topLevelChanged, this, &DockNamePlacement::updateNamesSoon);
  connect(dock, &QDockWidget::visibilityChanged, this, &DockNamePlacement::updateNamesSoon);
}

void DockNamePlacement::updateNamesSoon() {
  if (!std::exchange(isScheduled_, true)) {
    QMetaObject::invokeMethod(this, &DockNamePlacement::show, Qt::QueuedConnection);
  }
}

void DockNamePlacement::show() {
  isScheduled_ = false;
  for (ViewDock* dock : window_.findChildren<ViewDock*>()) {
    const auto neighbors = window_.tabifiedDockWidgets(dock);
    const bool hasTab =
        !dock->isFloating() && std::ranges::any_of(neighbors, [](const QDockWidget* neighbor) {
          return !neighbor->isHidden() && !neighbor->isFloating();
        });
    dock->title().setNameShown(!hasTab);
  }
}

} // namespace dewpoint::ui
