// SPDX-License-Identifier: GPL-3.0-or-later
// Where exports go unless one chooses, and what stays as it was chosen.
#include "core/base/text_file.h"
#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/trajectory_reader.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/document/project_saver.h"
#include "ui/export/export_dialog.h"
#include "ui/export/export_text.h"
#include "ui/export/video_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

namespace dewpoint::tests {

class ExportDestinationTest : public QObject, private test::WindowFixture {
  Q_OBJECT
private Q_SLOTS:
  void initTestCase() { QVERIFY(recordDemo(folder_.path().toStdString())); }
  void init() { makeWindow({.play = false}); }
  void cleanup() { window_.reset(); }
  void aNewProjectIsExportedBesideItsVideos();
  void aSavedProjectIsExportedBesideItsFile();
  void theFolderOfTheLastExportIsProposedNext();
  void anEnteredFileStays();
  void notesCanBeLeftOut();
  void usualAxesAndUnitAreNamed();

private:
  void openVideos() {
    drop({file("left.mkv"), file("right.mkv"), file("calibration.toml")});
    QVERIFY(waitFor([this] {
      return find<QTableWidget>("newCameras")->rowCount() == 2 &&
             find<QPushButton>("newCreate")->isEnabled();
    }));
    QTest::mouseClick(find<QPushButton>("newCreate"), Qt::LeftButton);
    QVERIFY(isOpen(2));
  }
  ExportDialog* openDialog() {
    action("actionExportTrajectory")->trigger();
    return window_->findChild<ExportDialog*>();
  }
  QString proposedTrajectory() {
    openDialog();
    return find<QLineEdit>("exportFile")->text();
  }
  QString proposedVideo() {
    action("actionExportVideo")->trigger();
    return find<QLineEdit>("videoFile")->text();
  }
  bool exportsTo(const QString& name) {
    openDialog();
    find<QLineEdit>("exportFile")->setText(name);
    auto* start = find<QPushButton>("exportStart");
    start->click();
    return waitFor([&] { return start->isEnabled(); }) && QFileInfo::exists(name);
  }
};

void ExportDestinationTest::aNewProjectIsExportedBesideItsVideos() {
  openVideos();
  const QString name = QString::fromStdString(window_->document().project().name);
  QVERIFY(!name.isEmpty());
  QCOMPARE(proposedTrajectory(), folder_.filePath(name + QStringLiteral("-trajectory.csv")));
  QVERIFY2(proposedVideo().startsWith(folder_.filePath(name + QStringLiteral("-video"))),
           qPrintable(proposedVideo()));
}

void ExportDestinationTest::aSavedProjectIsExportedBesideItsFile() {
  openVideos();
  QVERIFY(QDir().mkpath(file("saved")));
  QCOMPARE(QFileInfo(proposedTrajectory()).dir(), QDir(folder_.path()));
  window_->saver().save(path("saved/mine.toml"));
  QVERIFY(waitFor([this] { return !window_->document().project().file.empty(); }));
  QCOMPARE(QFileInfo(proposedTrajectory()).dir(), QDir(file("saved")));
}

void ExportDestinationTest::theFolderOfTheLastExportIsProposedNext() {
  open();
  QVERIFY(waitFor([this] { return shown().iterationCount > 0; }));
  QVERIFY(QDir().mkpath(file("results")));
  QVERIFY(exportsTo(file("results/first.csv")));
  QCOMPARE(QFileInfo(proposedVideo()).dir(), QDir(file("results")));
  const auto demo = resolveProject("demo");
  QVERIFY(demo && saveProject(*demo, path("next.toml")));
  open(path("next.toml"));
  QVERIFY(waitFor([this] { return shown().iterationCount > 0; }));
  QCOMPARE(QFileInfo(proposedTrajectory()).dir(), QDir(file("results")));
  // Exported into the project's own folder, each project has its own again.
  QVERIFY(exportsTo(file("second.csv")));
  QCOMPARE(QFileInfo(proposedVideo()).dir(), QDir(folder_.path()));
}

void ExportDestinationTest::anEnteredFileStays() {
  openVideos();
  openDialog();
  auto* entered = find<QLineEdit>("exportFile");
  entered->setText(file("mine.csv"));
  QCOMPARE(proposedTrajectory(), file("mine.csv"));
  auto* formats = find<QComboBox>("exportFormat");
  formats->setCurrentText(exportFormatName("trc"));
  QCOMPARE(proposedTrajectory(), file("mine.trc"));
  // A proposal follows the format, and stays a proposal.
  open();
  formats->setCurrentText(exportFormatName("c3d"));
  QVERIFY(entered->text().endsWith(QStringLiteral("-trajectory.c3d")));
}

void ExportDestinationTest::notesCanBeLeftOut() {
  open();
  QVERIFY(waitFor([this] { return shown().iterationCount > 0; }));
  openDialog();
  auto* notes = find<QCheckBox>("exportHeader");
  QCOMPARE(notes->text(), QStringLiteral("Notes at the top of the file"));
  QVERIFY(notes->isChecked());
  QVERIFY(exportsTo(file("with.csv")));
  notes->setChecked(false);
  QVERIFY(exportsTo(file("without.csv")));
  const auto with = readTextFile(path("with.csv"));
  const auto without = readTextFile(path("without.csv"));
  QVERIFY(with && with->starts_with("# dewpoint trajectory\n"));
  QVERIFY(without && without->starts_with("time_s,frame,target,x_m,"));
  QVERIFY(with->ends_with(*without));
  QCOMPARE(readTrajectory(path("without.csv"))->samples.size(),
           readTrajectory(path("with.csv"))->samples.size());
  auto* formats = find<QComboBox>("exportFormat");
  formats->setCurrentText(exportFormatName("trc"));
  QVERIFY(!notes->isEnabled()); // such a file has no place for notes
  formats->setCurrentText(exportFormatName("csv"));
  QVERIFY(notes->isEnabled() && !notes->isChecked());
  // The choice is remembered.
  window_.reset();
  makeAnotherWindow({.play = false});
  open();
  openDialog();
  QVERIFY(!find<QCheckBox>("exportHeader")->isChecked());
}

void ExportDestinationTest::usualAxesAndUnitAreNamed() {
  open();
  openDialog();
  auto* axes = find<QComboBox>("exportAxes");
  auto* unit = find<QComboBox>("exportUnit");
  QCOMPARE(axes->currentText(), QStringLiteral("Z up (usual for this format)"));
  find<QComboBox>("exportFormat")->setCurrentText(exportFormatName("trc"));
  QCOMPARE(axes->currentText(), QStringLiteral("Y up (usual for this format)"));
  QCOMPARE(unit->currentText(), QStringLiteral("meters (usual for this format)"));
  find<QComboBox>("exportFormat")->setCurrentText(exportFormatName("c3d"));
  QCOMPARE(unit->currentText(), QStringLiteral("millimeters (usual for this format)"));
}

DEWPOINT_WINDOW_TEST(ExportDestinationTest)

} // namespace dewpoint::tests

#include "export_destination_test.moc"
