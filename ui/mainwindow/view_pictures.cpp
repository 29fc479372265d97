// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/view_pictures.h"

#include "ui/export/view_picture.h"
#include "ui/text/error_sentence.h"
#include "ui/widgets/dock_title.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QMainWindow>
#include <QMenu>

namespace dewpoint::ui {

ViewPictures::ViewPictures(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
  connect(&bench_.docks, &DockManager::dockCreated, this, &ViewPictures::addMenu);
  bench_.onTriggered("actionSavePicture", this, [this] { choose(); });
  bench_.requireRun({"actionSavePicture"});
}

void ViewPictures::addMenu(ViewDock* dock) {
  // On the title: a right click into the view itself belongs to the view.
  QWidget* title = &dock->title();
  title->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(title, &QWidget::customContextMenuRequested, this, [this, dock, title](QPoint place) {
    QMenu menu;
    menu.setObjectName(QStringLiteral("menuPicture"));
    connect(menu.addAction(tr("Save picture as PNG…")), &QAction::triggered, this,
            [this, dock] { save(dock); });
    connect(menu.addAction(tr("Copy picture")), &QAction::triggered, this,
            [dock] { QApplication::clipboard()->setImage(grabView(dock->widget())); });
    menu.exec(title->mapToGlobal(place));
  });
}

void ViewPictures::choose() {
  QMenu menu;
  menu.setObjectName(QStringLiteral("menuPictures"));
  for (ViewDock* dock : bench_.docks.docks()) {
    if (dock->isVisible() && !dock->visibleRegion().isEmpty()) {
      connect(menu.addAction(dock->windowTitle()), &QAction::triggered, this,
              [this, dock] { save(dock); });
    }
  }
  menu.exec(bench_.window.mapToGlobal(bench_.window.rect().center()));
}

void ViewPictures::save(ViewDock* dock) {
  const QImage picture = grabView(dock->widget()); // as it is now, not after the question
  const QString file = QFileDialog::getSaveFileName(
      &bench_.window, tr("Save a picture of %1").arg(dock->windowTitle()),
      QDir::home().filePath(dock->windowTitle() + QStringLiteral(".png")), tr("Pictures (*.png)"));
  if (!file.isEmpty()) {
    write(picture, file);
  }
}

void ViewPictures::write(const QImage& picture, const QString& file) {
  files_.add([this, picture, file]() -> std::function<void()> {
    const Status written = writePng(picture, file.toStdString());
    return [this, file, written] {
      if (written) {
        bench_.messages.showNotice(tr("Saved the picture %1.").arg(file));
      } else {
        bench_.messages.showError(errorText(written.error()));
      }
    };
  });
}

} // namespace dewpoint::ui
