// SPDX-License-Identifier: GPL-3.0-or-later
// A project whose files were moved: it opens once one of them was located.
#include "core/project/project.h"
#include "core/project/project_load.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>

#include <fstream>

namespace dewpoint::tests {

class MovedFilesTest : public QObject, private test::WindowFixture {
  Q_OBJECT
private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void opensOnceOneVideoIsLocated();
  void aMovedCalibrationIsLocated();
  void whoCancelsIsAskedAgain();

private:
  /// Answers the next file dialog with this file, or cancels it.
  void choose(const QString& chosen);
  bool offersToLocate() {
    return waitFor([this] {
      const auto* answer = window_->findChild<QPushButton*>(QStringLiteral("messageAnswer0"));
      return answer != nullptr && answer->text() == QStringLiteral("Locate…");
    });
  }
};

void MovedFilesTest::init() {
  folder_ = QTemporaryDir();
  QVERIFY(recordDesk(folder_.path().toStdString()));
  makeWindow({.size = {1400, 900}, .play = false});
}

void MovedFilesTest::choose(const QString& chosen) {
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, [timer, chosen] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) {
      return;
    }
    timer->stop();
    timer->deleteLater();
    if (chosen.isEmpty()) {
      dialog->reject();
      return;
    }
    dialog->setDirectory(QFileInfo(chosen).path());
    dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(chosen);
    dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open)->click();
  });
  timer->start(50);
}

void MovedFilesTest::opensOnceOneVideoIsLocated() {
  QVERIFY(QDir(folder_.path()).mkdir(QStringLiteral("elsewhere")));
  QVERIFY(QFile::rename(file("left.mkv"), file("elsewhere/left.mkv")));
  QVERIFY(QFile::rename(file("right.mkv"), file("elsewhere/right.mkv")));
  window_->openProject(path("desk.toml"));
  QVERIFY(offersToLocate());
  // All of them in one message, with their cameras.
  QVERIFY(messageText().contains(QStringLiteral("left.mkv")));
  QVERIFY(messageText().contains(QStringLiteral("right.mkv")));
  choose(file("elsewhere/left.mkv"));
  find<QPushButton>("messageAnswer0")->click();
  QVERIFY(isOpen(2));
  const Project& project = window_->document().project();
  QCOMPARE(project.cameras[0].location, file("elsewhere/left.mkv").toStdString());
  QCOMPARE(project.cameras[1].location, file("elsewhere/right.mkv").toStdString());
  QCOMPARE(project.file, path("desk.toml"));
  // In the file only when the user saves it.
  QVERIFY(window_->document().isUnsaved());
  QVERIFY(loadProject(path("desk.toml"))->cameras[0].location == file("left.mkv").toStdString());
  action("actionSave")->trigger();
  QVERIFY(waitFor([this] { return !window_->document().isUnsaved(); }));
  QVERIFY(loadProject(path("desk.toml"))->cameras[0].location ==
          file("elsewhere/left.mkv").toStdString());
}

void MovedFilesTest::aMovedCalibrationIsLocated() {
  const CameraRig rig = demoScene().cameras;
  std::ofstream(path("byhand.toml"))
      << "format = 2\ncalibration = \"calibration.toml\"\n"
      << "[[camera]]\nname = \"" << rig[0].name << "\"\nvideo = \"left.mkv\"\n"
      << "[[camera]]\nname = \"" << rig[1].name << "\"\nvideo = \"right.mkv\"\n";
  QVERIFY(QFile::rename(file("calibration.toml"), file("rig.toml")));
  window_->openProject(path("byhand.toml"));
  QVERIFY(offersToLocate());
  QVERIFY(messageText().contains(QStringLiteral("calibration.toml")));
  choose(file("rig.toml"));
  find<QPushButton>("messageAnswer0")->click();
  QVERIFY(isOpen(2));
  QVERIFY(window_->document().isUnsaved());
}

void MovedFilesTest::whoCancelsIsAskedAgain() {
  QVERIFY(QFile::rename(file("left.mkv"), file("moved.mkv")));
  window_->openProject(path("desk.toml"));
  QVERIFY(offersToLocate());
  choose({});
  find<QPushButton>("messageAnswer0")->click();
  QVERIFY(offersToLocate());
  QVERIFY(messageText().contains(QStringLiteral("left.mkv")));
}

DEWPOINT_WINDOW_TEST(MovedFilesTest)

} // namespace dewpoint::tests

#include "moved_files_test.moc"
