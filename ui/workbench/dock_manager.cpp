// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/dock_manager.h"

#include "core/project/project.h"
#include "ui/document/document.h"
#include "ui/session/session_controller.h"
#include "ui/widgets/dock_title.h"
#include "ui/workbench/dock_name_placement.h"

#include <QKeyEvent>
#include <QMainWindow>
#include <QMouseEvent>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {
constexpr int kAdjustments = 2; ///< sizes given in a row: those of one row of docks change others
/// Versions of a layout: somebody has arranged the views, or they suit the size of the window.
constexpr int kByHand = 0;
constexpr int kForSize = 1;
} // namespace

DockManager::DockManager(QMainWindow& window, Document& document, const SessionController& session,
                         QObject* parent)
    : QObject(parent), window_(window), document_(document), session_(session),
      names_(new DockNamePlacement(window, this)), arrangement_(window, document),
      heightsBelow_(window) {
  window_.setDockNestingEnabled(true);
  window_.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  window_.installEventFilter(this);
}

ViewDock* DockManager::makeDock(const DockDeclaration& declaration) {
  auto* dock = new ViewDock(declaration, &window_);
  connect(dock, &ViewDock::maximizeRequested, this, [this, dock] { toggleMaximized(dock); });
  const auto movedByUser = [this] {
    suitsSize_ = suitsSize_ && arranging_;
    heightsBelow_.forgetHeights();
  };
  connect(dock, &QDockWidget::visibilityChanged, &heightsBelow_, &HeldHeights::forgetHeights);
  connect(dock, &QDockWidget::dockLocationChanged, this, movedByUser);
  connect(dock, &QDockWidget::visibilityChanged, this, &DockManager::distributeDockSizesSoon);
  connect(dock, &QDockWidget::topLevelChanged, this, [this, movedByUser] {
    if (suitsSize_ && !arranging_) { // its room is for the other views, not for the inspector
      QMetaObject::invokeMethod(
          this,
          [this] {
            ViewDock* inspector = arrangement_.firstDockAt(DockArea::Inspector);
            window_.resizeDocks({inspector}, {inspector->minimumSizeHint().width()},
                                Qt::Horizontal);
          },
          Qt::QueuedConnection);
    }
    movedByUser();
  });
  connect(dock, &ViewDock::toggledByUser, this, [this, dock](bool shown) {
    if (!shown && dock == maximized_) {
      restoreMaximized(); // or nothing would be left
    }
  });
  names_->addDock(dock);
  Q_EMIT dockCreated(dock);
  return dock;
}

void DockManager::removeDock(ViewDock* dock) {
  if (dock == maximized_) {
    restoreMaximized();
  }
  std::erase_if(hiddenBeforeMaximized_, [dock](const auto& one) { return one.first == dock; });
  window_.removeDockWidget(dock);
  delete dock;
  names_->updateNamesSoon();
}

bool DockManager::isBehindOtherDocks(const QWidget* widget) {
  for (; widget != nullptr; widget = widget->parentWidget()) {
    const auto* dock = qobject_cast<const ViewDock*>(widget);
    if (dock != nullptr && dock->isBehindOtherDocks()) {
      return true;
    }
  }
  return false;
}

void DockManager::layOut() {
  restoreMaximized();
  suitsSize_ = true;
  arrange();
  const auto layout =
      QByteArray::fromBase64(QByteArray::fromStdString(document_.project().windowLayout));
  suitsSize_ = layout.isEmpty() || restore(layout) == kForSize;
  if (suitsSize_ && !layout.isEmpty()) {
    // For this window: another one may have had another size.
    rearrange(arrangement_.cameraColumnCount());
    return;
  }
  Q_EMIT layoutChanged();
}

void DockManager::resetLayout() {
  document_.setLayout({});
  for (ViewDock* camera : arrangement_.docksAt(DockArea::Cameras)) {
    camera->setHiddenByUser(false);
  }
  layOut();
}

void DockManager::storeLayout() {
  // What the views were before one filled the window, or a page took their place.
  const QByteArray layout = maximized_ != nullptr          ? layoutBeforeMaximized_
                            : layoutBehindPages_.isEmpty() ? save()
                                                           : layoutBehindPages_;
  document_.setLayout(layout.toBase64().toStdString());
}

QByteArray DockManager::save() const {
  return window_.saveState(suitsSize_ ? kForSize : kByHand);
}

int DockManager::restore(const QByteArray& layout) {
  const bool before = std::exchange(arranging_, true);
  const int version = window_.restoreState(layout, kForSize) ? kForSize : kByHand;
  if (version == kByHand) {
    window_.restoreState(layout, kByHand);
  }
  arranging_ = before;
  distributeDockSizesSoon(); // the window may have another size by now
  return version;
}

void DockManager::arrange() {
  const bool before = std::exchange(arranging_, true);
  arrangement_.placeDocks();
  showViews(session_.isRunning());
  arrangement_.firstDockAt(DockArea::Inspector)->raise();
  arrangement_.firstDockAt(DockArea::Plots)->raise();
  arranging_ = before;
  distributeDockSizesSoon();
}

void DockManager::rearrange(int columns) {
  std::vector<ViewDock*> inFront = docks();
  std::vector<ViewDock*> hidden = inFront;
  std::erase_if(
      inFront, [](const ViewDock* dock) { return dock->isHidden() || dock->isBehindOtherDocks(); });
  std::erase_if(hidden, [](const ViewDock* dock) { return !dock->isHidden(); });
  arrangement_.setCameraColumnCount(columns);
  arrange();
  for (ViewDock* dock : hidden) {
    dock->hide();
  }
  for (ViewDock* dock : inFront) {
    dock->raise();
  }
  Q_EMIT layoutChanged();
}

void DockManager::distributeDockSizesSoon() {
  if (suitsSize_ && std::exchange(adjustments_, kAdjustments) == 0) {
    // The sizes can be given only once the layout has settled.
    QMetaObject::invokeMethod(this, &DockManager::distributeDockSizes, Qt::QueuedConnection);
  }
}

void DockManager::distributeDockSizes() {
  if (--adjustments_ > 0) {
    QMetaObject::invokeMethod(this, &DockManager::distributeDockSizes, Qt::QueuedConnection);
  }
  if (!suitsSize_ || maximized_ != nullptr || !window_.centralWidget()->isHidden()) {
    return; // later, when the views are back
  }
  if (const int columns = arrangement_.bestCameraColumnCount();
      columns != arrangement_.cameraColumnCount()) {
    rearrange(columns);
    distributeDockSizesSoon();
    return;
  }
  arrangement_.distributeSizes();
}

void DockManager::lockLowerDockHeights(bool locked) {
  distributeDockSizesSoon();
  if (suitsSize_ || maximized_ != nullptr) {
    return;
  }
  locked ? heightsBelow_.holdHeights() : heightsBelow_.releaseHeights();
}

bool DockManager::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &window_) {
    return QObject::eventFilter(watched, event);
  }
  switch (event->type()) {
  case QEvent::Resize:
    heightsBelow_.forgetHeights();
    [[fallthrough]];
  case QEvent::Show:
  case QEvent::LanguageChange: // the names of tabs have other widths
    distributeDockSizesSoon();
    break;
  case QEvent::MouseButtonPress:
    // What is the window's own, between its docks.
    separator_ = window_.childAt(static_cast<QMouseEvent*>(event)->position().toPoint()) == nullptr;
    break;
  case QEvent::MouseButtonRelease:
    heightsBelow_.forgetHeights();
    break;
  case QEvent::MouseMove:
    suitsSize_ =
        suitsSize_ && !(separator_ && static_cast<QMouseEvent*>(event)->buttons() != Qt::NoButton);
    break;
  case QEvent::KeyPress: // that nobody else wanted
    if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && maximized_ != nullptr) {
      restoreMaximized();
      return true;
    }
    break;
  default:
    break;
  }
  return QObject::eventFilter(watched, event);
}

void DockManager::showViews(bool shown) {
  QWidget* pages = window_.centralWidget();
  if (!shown && session_.isRunning() && !pages->isVisible()) {
    layoutBehindPages_ = save();
  }
  if (shown) {
    pages->hide(); // whichever goes goes first: there is no room for both
  }
  Q_EMIT viewsAboutToChange(shown);
  for (ViewDock* dock : docks()) {
    if (!shown) {
      dock->hide();
    } else if (!dock->isHiddenByUser()) {
      dock->show();
    }
  }
  pages->setVisible(!shown);
  // What has just gone had the keys, and Qt gave them to the next widget. Space must play, so they
  // go to the window until the user chooses another place.
  if (QWidget* keys = window_.focusWidget(); shown && keys != nullptr) {
    keys->clearFocus();
  }
  if (shown && !layoutBehindPages_.isEmpty()) {
    restore(std::exchange(layoutBehindPages_, {}));
  } else if (shown) {
    distributeDockSizesSoon();
  }
  Q_EMIT viewsShownChanged(shown);
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
  layoutBeforeMaximized_ = save(); // before the others are hidden
  maximized_ = dock;
  dock->title().setMaximized(true);
  hiddenBeforeMaximized_.clear();
  for (ViewDock* other : docks()) {
    hiddenBeforeMaximized_.emplace_back(other, other->isHiddenByUser());
    if (other != dock && !other->isFloating()) {
      other->hide();
    }
  }
}

void DockManager::restoreMaximized() {
  ViewDock* dock = std::exchange(maximized_, nullptr);
  if (dock == nullptr) {
    return;
  }
  dock->title().setMaximized(false);
  restore(std::exchange(layoutBeforeMaximized_, {}));
  // What was wanted or put away meanwhile stays so.
  for (const auto& [other, hidden] : std::exchange(hiddenBeforeMaximized_, {})) {
    if (other->isHiddenByUser() != hidden) {
      other->setVisible(!other->isHiddenByUser());
    }
  }
}

} // namespace dewpoint::ui
