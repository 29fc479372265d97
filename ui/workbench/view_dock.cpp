// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/view_dock.h"

#include "ui/text/retranslation.h"
#include "ui/widgets/dock_title.h"

#include <QAction>
#include <QCloseEvent>
#include <QGuiApplication>
#include <QScrollArea>

namespace dewpoint::ui {

namespace {

constexpr QPoint kBesideItsPlace(40, 40); ///< of a view that floats, so that it is seen to
constexpr QSize kLeastImage(72, 48);      ///< of a camera view: the window may be small
constexpr QSize kLeastScene(160, 96);
constexpr int kLeastPlots = 48; ///< height; what does not fit scrolls

/// The content as a window that is small can show it: panels scroll, views of images shrink.
QWidget* shrinkable(QWidget* content, DockArea place, const QString& name) {
  switch (place) {
  case DockArea::Cameras:
    content->setMinimumSize(kLeastImage);
    return content;
  case DockArea::Scene:
    content->setMinimumSize(kLeastScene);
    return content;
  case DockArea::Plots:
    content->setMinimumHeight(kLeastPlots);
    return content;
  case DockArea::Inspector:
    break;
  case DockArea::History:
  case DockArea::Timeline:
    return content;
  }
  if (qobject_cast<QAbstractScrollArea*>(content) != nullptr) {
    return content;
  }
  auto* scroll = new QScrollArea;
  scroll->setObjectName(name + QStringLiteral("Scroll"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(content);
  return scroll;
}

} // namespace

ViewDock::ViewDock(const DockDeclaration& declaration, QWidget* window)
    : QDockWidget(window), area_(declaration.area), orderInArea_(declaration.orderInArea),
      hiddenByUser_(declaration.isHiddenAtFirst), openedByAction_(declaration.isOpenedByAction) {
  onRetranslate(this, [this, title = declaration.title] { setWindowTitle(title()); });
  setObjectName(declaration.name);
  setWidget(shrinkable(declaration.content, area_, declaration.name));
  setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable |
              QDockWidget::DockWidgetClosable);
  connect(toggleViewAction(), &QAction::triggered, this, [this](bool shown) {
    hiddenByUser_ = !shown;
    Q_EMIT toggledByUser(shown);
  });
  connect(this, &QDockWidget::visibilityChanged, this, [this](bool seen) { behind_ = !seen; });
  title_ = new DockTitle(this);
  setTitleBarWidget(title_);
  connect(title_, &DockTitle::maximizeRequested, this, &ViewDock::maximizeRequested);
  connect(title_, &DockTitle::floatRequested, this, &ViewDock::toggleFloating);
  connect(this, &QDockWidget::topLevelChanged, this, [this](bool floating) {
    if (floating && QGuiApplication::mouseButtons() == Qt::NoButton) {
      // Later: a layout that is being restored is not disturbed.
      QMetaObject::invokeMethod(this, &ViewDock::addWindowFrame, Qt::QueuedConnection);
    }
  });
}

void ViewDock::toggleFloating() {
  if (isFloating()) {
    setFloating(false);
    return;
  }
  const QPoint place = mapToGlobal(QPoint());
  const QSize before = size();
  setFloating(true);
  addWindowFrame(); // the button may count as pressed still
  resize(before);
  move(place + kBesideItsPlace);
  raise();
  activateWindow();
}

void ViewDock::addWindowFrame() {
  if (!isFloating() || !windowFlags().testFlag(Qt::FramelessWindowHint)) {
    return;
  }
  const bool shown = !isHidden();
  const QRect place = geometry();
  // A window, no tool: tools have no frame to maximize them with. Keys go to the actions of the
  // main window only from its tools, so the actions come along.
  addActions(parentWidget()->actions());
  setWindowFlags(Qt::Window);
  setGeometry(place);
  setVisible(shown);
}

bool ViewDock::event(QEvent* event) {
  const bool taken = QDockWidget::event(event);
  if (event->type() == QEvent::MouseButtonRelease) {
    addWindowFrame();
  }
  return taken;
}

void ViewDock::closeEvent(QCloseEvent* event) {
  QDockWidget::closeEvent(event);
  if (event->isAccepted() && isFloating()) {
    hiddenByUser_ = true;
    Q_EMIT toggledByUser(false);
  }
}

void ViewDock::setShownByUserChoice(bool wanted) {
  hiddenByUser_ = !wanted;
  setVisible(wanted);
}

void ViewDock::bringToFront() {
  setShownByUserChoice(true);
  raise();
}

} // namespace dewpoint::ui
