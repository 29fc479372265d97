// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/view_dock.h"

#include "ui/text/retranslation.h"
#include "ui/widgets/dock_title.h"

#include <QAction>

namespace dewpoint::ui {

ViewDock::ViewDock(const DockDeclaration& declaration, QWidget* window)
    : QDockWidget(window), place_(declaration.place), rank_(declaration.rank),
      hiddenByUser_(declaration.hiddenAtFirst), openedByAction_(declaration.openedByAction) {
  onRetranslate(this, [this, title = declaration.title] { setWindowTitle(title()); });
  setObjectName(declaration.name);
  setWidget(declaration.content);
  setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable |
              QDockWidget::DockWidgetClosable);
  connect(toggleViewAction(), &QAction::triggered, this, [this](bool shown) {
    hiddenByUser_ = !shown;
    Q_EMIT toggledByUser(shown);
  });
  connect(this, &QDockWidget::visibilityChanged, this, [this](bool seen) { behind_ = !seen; });
  title_ = new DockTitle(this);
  setTitleBarWidget(title_);
  connect(title_, &DockTitle::maximizeWanted, this, &ViewDock::maximizeWanted);
}

void ViewDock::setWanted(bool wanted) {
  hiddenByUser_ = !wanted;
  setVisible(wanted);
}

void ViewDock::bringToFront() {
  setWanted(true);
  raise();
}

} // namespace dewpoint::ui
