// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/dock_manager.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/session/session_controller.h"
#include "ui/widgets/dock_title.h"

#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

DockManager::DockManager(QMainWindow& window, Document& document, const SessionController& session,
                         QObject* parent)
    : QObject(parent), window_(window), document_(document), session_(session) {
  window_.setDockNestingEnabled(true);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
}

ViewDock* DockManager::make(const DockDeclaration& declaration) {
  auto* dock = new ViewDock(declaration, &window_);
  connect(dock, &ViewDock::maximizeWanted, this, [this, dock] { toggleMaximized(dock); });
  connect(dock, &ViewDock::toggledByUser, this, [this, dock](bool shown) {
    if (!shown && dock == maximized_) {
      restoreMaximized(); // or nothing would be left
    }
  });
  connect(dock, &QDockWidget::dockLocationChanged, this, &DockManager::showNamesSoon);
  connect(dock, &QDockWidget::topLevelChanged, this, &DockManager::showNamesSoon);
  connect(dock, &QDockWidget::visibilityChanged, this, &DockManager::showNamesSoon);
  Q_EMIT made(dock);
  return dock;
}

void DockManager::remove(ViewDock* dock) {
  if (dock == maximized_) {
    restoreMaximized();
  }
  std::erase_if(hiddenBeforeMaximized_, [dock](const auto& one) { return one.first == dock; });
  window_.removeDockWidget(dock);
  delete dock;
  showNamesSoon();
}

std::vector<ViewDock*> DockManager::docks() const {
  const auto found = window_.findChildren<ViewDock*>();
  return {found.begin(), found.end()};
}

bool DockManager::isBehind(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    const auto* dock = qobject_cast<const ViewDock*>(widget);
    if (dock != nullptr && dock->isBehind()) {
      return true;
    }
  }
  return false;
}

std::vector<ViewDock*> DockManager::at(DockPlace place) const {
  std::vector<ViewDock*> found = docks();
  std::erase_if(found, [place](const ViewDock* dock) { return dock->place() != place; });
  std::ranges::stable_sort(found, {}, &ViewDock::rank);
  return found;
}

ViewDock* DockManager::first(DockPlace place) const {
  const std::vector<ViewDock*> found = at(place);
  return found.empty() ? nullptr : found.front();
}

void DockManager::layOut() {
  restoreMaximized();
  arrange();
  const auto layout = QByteArray::fromBase64(QByteArray::fromStdString(document_.project().layout));
  if (!layout.isEmpty()) {
    window_.restoreState(layout);
  }
  Q_EMIT laidOut();
}

void DockManager::reset() {
  document_.setLayout({});
  for (ViewDock* camera : at(DockPlace::Cameras)) {
    camera->setHiddenByUser(false);
  }
  layOut();
}

void DockManager::storeLayout() {
  // What the views were before one filled the window, or a page took their place.
  const QByteArray layout = maximized_ != nullptr          ? layoutBeforeMaximized_
                            : layoutBehindPages_.isEmpty() ? window_.saveState()
                                                           : layoutBehindPages_;
  document_.setLayout(layout.toBase64().toStdString());
}

void DockManager::arrange() {
  for (ViewDock* dock : docks()) {
    dock->setFloating(false);
    window_.removeDockWidget(dock); // or splits and tabs would build on what was
  }
  const auto below = at(DockPlace::Plots);
  window_.addDockWidget(Qt::BottomDockWidgetArea, below.front());
  ViewDock* last = below.front();
  for (ViewDock* dock : at(DockPlace::Timeline)) {
    window_.splitDockWidget(last, dock, Qt::Vertical);
    last = dock;
  }
  for (std::size_t i = 1; i < below.size(); ++i) {
    window_.tabifyDockWidget(below.front(), below[i]);
  }
  ViewDock* scene = first(DockPlace::Scene);
  arrangeCameras(scene);
  const auto inspector = at(DockPlace::Inspector);
  window_.splitDockWidget(scene, inspector.front(), Qt::Horizontal);
  for (ViewDock* dock : at(DockPlace::History)) { // before there are tabs
    window_.splitDockWidget(inspector.front(), dock, Qt::Vertical);
  }
  // One tab for each kind of thing that can be looked into.
  for (std::size_t i = 1; i < inspector.size(); ++i) {
    window_.tabifyDockWidget(inspector.front(), inspector[i]);
  }
  showViews(session_.isRunning());
  inspector.front()->raise();
  below.front()->raise();
  distributeDockSizesSoon();
}

void DockManager::arrangeCameras(ViewDock* scene) {
  window_.addDockWidget(Qt::LeftDockWidgetArea, scene);
  const std::vector<ViewDock*> cameras = at(DockPlace::Cameras);
  if (cameras.empty()) {
    return;
  }
  // Cameras stand to the left of the scene, in as many columns as keep them near square.
  const std::size_t count = cameras.size();
  const std::size_t columns = count <= 3 ? 1 : count <= 8 ? 2 : 3;
  window_.removeDockWidget(scene);
  window_.addDockWidget(Qt::LeftDockWidgetArea, cameras.front());
  window_.splitDockWidget(cameras.front(), scene, Qt::Horizontal);
  for (std::size_t i = 1; i < std::min(columns, count); ++i) {
    window_.splitDockWidget(cameras[i - 1], cameras[i], Qt::Horizontal);
  }
  for (std::size_t i = columns; i < count; ++i) {
    window_.splitDockWidget(cameras[i - columns], cameras[i], Qt::Vertical);
  }
}

void DockManager::distributeDockSizesSoon() {
  // The sizes can be given only once the layout has settled.
  QMetaObject::invokeMethod(this, &DockManager::distributeDockSizes, Qt::QueuedConnection);
}

void DockManager::distributeDockSizes() {
  ViewDock* inspector = first(DockPlace::Inspector);
  ViewDock* scene = first(DockPlace::Scene);
  const std::vector<ViewDock*> cameras = at(DockPlace::Cameras);
  const int narrow = inspector->minimumSizeHint().width();
  const int inner = window_.width() - narrow;
  QList<QDockWidget*> row{scene, inspector};
  QList<int> widths{inner, narrow};
  if (!cameras.empty() && scene->isHidden()) {
    row[0] = cameras.front();
  } else if (!cameras.empty()) {
    row.prepend(cameras.front());
    widths.prepend(inner * 38 / 100);
    widths[1] = inner - widths.front();
  }
  window_.resizeDocks(row, widths, Qt::Horizontal);
  const int height = window_.height();
  const int plotHeight = height * 29 / 100;
  ViewDock* timeline = first(DockPlace::Timeline);
  const int timelineHeight = timeline->sizeHint().height();
  window_.resizeDocks({row.front(), first(DockPlace::Plots), timeline},
                      {height - plotHeight - timelineHeight, plotHeight, timelineHeight},
                      Qt::Vertical);
  const QList<QDockWidget*> column(cameras.begin(), cameras.end());
  window_.resizeDocks(column, QList<int>(column.size(), height / 3), Qt::Vertical);
}

void DockManager::showNamesSoon() {
  if (!std::exchange(isNaming_, true)) {
    QMetaObject::invokeMethod(this, &DockManager::showNames, Qt::QueuedConnection);
  }
}

void DockManager::showNames() {
  isNaming_ = false;
  for (ViewDock* dock : docks()) {
    const auto neighbors = window_.tabifiedDockWidgets(dock);
    const bool hasTab =
        !dock->isFloating() && std::ranges::any_of(neighbors, [](const QDockWidget* neighbor) {
          return !neighbor->isHidden() && !neighbor->isFloating();
        });
    dock->title().setNameShown(!hasTab);
  }
}

void DockManager::showViews(bool shown) {
  QWidget* pages = window_.centralWidget();
  if (!shown && session_.isRunning() && !pages->isVisible()) {
    layoutBehindPages_ = window_.saveState();
  }
  if (shown) {
    pages->hide(); // whichever goes goes first: there is no room for both
  }
  Q_EMIT viewsShowing(shown);
  for (ViewDock* dock : docks()) {
    if (!shown) {
      dock->hide();
    } else if (!dock->isHiddenByUser()) {
      dock->show();
    }
  }
  pages->setVisible(!shown);
  if (shown && !layoutBehindPages_.isEmpty()) {
    window_.restoreState(std::exchange(layoutBehindPages_, {}));
  }
  Q_EMIT viewsShown(shown);
}

void DockManager::toggleMaximized(ViewDock* dock) {
  if (dock->isFloating()) {
    dock->setFloating(false);
  } else if (maximized_ != nullptr) {
    restoreMaximized();
  } else {
    maximize(dock);
  }
}

void DockManager::maximize(ViewDock* dock) {
  layoutBeforeMaximized_ = window_.saveState(); // before the others are hidden
  maximized_ = dock;
  hiddenBeforeMaximized_.clear();
  for (ViewDock* other : docks()) {
    hiddenBeforeMaximized_.emplace_back(other, other->isHiddenByUser());
    if (other != dock && !other->isFloating()) {
      other->hide();
    }
  }
}

void DockManager::restoreMaximized() {
  if (std::exchange(maximized_, nullptr) == nullptr) {
    return;
  }
  window_.restoreState(std::exchange(layoutBeforeMaximized_, {}));
  // What was wanted or put away meanwhile stays so.
  for (const auto& [dock, hidden] : std::exchange(hiddenBeforeMaximized_, {})) {
    if (dock->isHiddenByUser() != hidden) {
      dock->setVisible(!dock->isHiddenByUser());
    }
  }
}

} // namespace dewpoint::ui
