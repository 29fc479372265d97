// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations of other tools in the real window: the golden files in, the project's cameras out
// and in again.
#include "core/calibration/formats/format_catalog.h"
#include "core/calibration/formats/read_calibration.h"
#include "core/setup/calibration/calibration_exchange.h"
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/exchange/calibration_export.h"
#include "ui/calibration/exchange/calibration_import.h"
#include "ui/document/camera_list_model.h"
#include "ui/widgets/message_bar.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>

namespace dewpoint::tests {
namespace {
const QString kGolden = QStringLiteral(DEWPOINT_SOURCE_DIR "/tests/calibration/golden/");
}

class CalibrationImportTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void goldenFilesAreTaken_data();
  void goldenFilesAreTaken();
  void asksWhatTheFileLeavesOpen();
  void aBrokenFileIsOneSentence();
  void whatIsExportedComesBack_data();
  void whatIsExportedComesBack();
  void theFileThatWasFoundIsTheOneNamed();
  void aCameraWithoutANameCanBeMeant();
  void anExportHasAFileAtOnce();
  void theButtonFollowsWhatIsTyped();
  void theListOfCamerasOpensTheSameDialog();

private:
  QString preview(const char* name) { return find<QPlainTextEdit>(name)->toPlainText(); }
  void type(const char* name, const QString& text) {
    auto* line = find<QLineEdit>(name);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
  }
  void choose(const char* name, const char* data) {
    auto* box = find<QComboBox>(name);
    const int index = box->findData(QLatin1String(data));
    QVERIFY2(index >= 0, data);
    box->setCurrentIndex(index);
  }
  /// Whether the file to import lacks what the field with this label says.
  bool asksFor(const char* label) {
    return preview("calibrationImportPreview")
        .contains(QStringLiteral("Set “%1”").arg(QLatin1String(label)));
  }
  bool waitReady(ExchangeDialog* dialog) {
    return waitFor([&] { return dialog->isReady(); });
  }
  bool waitText(const char* name, const QString& part) {
    return waitFor([&] { return preview(name).contains(part); });
  }
  CalibrationImportDialog* openImport() {
    find<QAction>("actionImportCalibration")->trigger();
    return window_->findChild<CalibrationImportDialog*>();
  }
};

void CalibrationImportTest::init() {
  openCalibration();
}

void CalibrationImportTest::cleanup() {
  window_.reset();
}

void CalibrationImportTest::goldenFilesAreTaken_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QString>("unit");
  QTest::addColumn<QString>("size");
  QTest::addColumn<int>("cameras");
  // Each golden file, and what it leaves open (tests/calibration/formats/format_golden_test.cpp).
  QTest::newRow("anipose") << "anipose_mm.toml"
                           << "mm"
                           << "" << 3;
  QTest::newRow("anipose fisheye") << "anipose_fisheye_mm.toml"
                                   << "mm"
                                   << "" << 2;
  QTest::newRow("pose2sim") << "pose2sim.toml"
                            << ""
                            << "" << 3;
  QTest::newRow("caliscope") << "camera_array.toml"
                             << ""
                             << "" << 3;
  QTest::newRow("opencv-stereo") << "intrinsics.yml"
                                 << "0.025"
                                 << "1280x720" << 2;
  QTest::newRow("opencv") << "opencv_sample.yml"
                          << "cm"
                          << "" << 1;
  QTest::newRow("ros") << "ros"
                       << ""
                       << "" << 2;
  QTest::newRow("kalibr") << "camchain.yaml"
                          << ""
                          << "" << 3;
  QTest::newRow("mrcal") << "mrcal"
                         << ""
                         << "" << 2;
  QTest::newRow("mc-calib") << "mc_calib.yml"
                            << "cm"
                            << "" << 3;
  QTest::newRow("qualisys") << "session.qca.txt"
                            << ""
                            << "" << 3;
  QTest::newRow("multical") << "multical.json"
                            << "m"
                            << "" << 3;
}

void CalibrationImportTest::goldenFilesAreTaken() {
  QFETCH(QString, file);
  QFETCH(QString, unit);
  QFETCH(QString, size);
  QFETCH(int, cameras);
  CalibrationHints hints;
  if (!unit.isEmpty()) {
    hints.metersPerUnit = parseLengthUnit(unit.toStdString());
  }
  if (!size.isEmpty()) {
    hints.imageSize = {1280, 720};
  }
  const auto expected = readCalibration((kGolden + file).toStdString(), hints);
  QVERIFY(expected);
  QCOMPARE(expected->rig.size(), static_cast<std::size_t>(cameras));
  // A project of as many cameras, with names of its own: they are taken in the file's order.
  Document document;
  Project project = window_->document().project();
  project.cameras.resize(static_cast<std::size_t>(cameras), project.cameras.front());
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    project.cameras[k].camera.name = "eye " + std::to_string(k);
  }
  document.replaceProject(project);
  const CameraListModel cameraList(document);
  CalibrationImportDialog dialog(document, cameraList);
  dialog.show();
  dialog.setFile(kGolden + file);
  if (!size.isEmpty()) {
    auto* field = dialog.findChild<QLineEdit*>("calibrationImportSize");
    field->setText(size);
    Q_EMIT field->editingFinished();
  }
  auto* units = dialog.findChild<QComboBox*>("calibrationImportUnit");
  if (const int index = units->findData(unit); index >= 0 && !unit.isEmpty()) {
    units->setCurrentIndex(index);
  } else if (!unit.isEmpty()) {
    units->lineEdit()->setText(unit);
    Q_EMIT units->lineEdit()->editingFinished();
  }
  QVERIFY2(
      waitReady(&dialog),
      qPrintable(dialog.findChild<QPlainTextEdit*>("calibrationImportPreview")->toPlainText()));
  dialog.findChild<QPushButton*>("calibrationImportAccept")->click();
  QCOMPARE(document.undoStack()->count(), 1);
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    Camera taken = document.project().cameras[k].camera;
    QCOMPARE(taken.name, "eye " + std::to_string(k));
    taken.name = expected->rig[k].name;
    QVERIFY(taken == expected->rig[k]); // whose pixels the golden test compares with the tool's
  }
  document.undoStack()->undo();
  QVERIFY(document.project().cameras == project.cameras);
}

void CalibrationImportTest::asksWhatTheFileLeavesOpen() {
  auto* dialog = openImport();
  type("calibrationImportFile", kGolden + QStringLiteral("anipose_mm.toml"));
  QVERIFY(waitText("calibrationImportPreview", QStringLiteral("Unit")));
  QVERIFY(!dialog->isReady());
  QVERIFY(!find<QPushButton>("calibrationImportAccept")->isEnabled());
  const QString said = find<MessageBar>("messageBar")->text();
  QVERIFY2(said.contains(QStringLiteral("unit")) && said.contains(QStringLiteral("probably mm")),
           qPrintable(said));
  QVERIFY2(!said.contains(QStringLiteral("--")), qPrintable(said));
  type("calibrationImportSize", QStringLiteral("640x480")); // another question than the one asked
  QVERIFY(!dialog->isReady());
  // The meters of one unit, as typed.
  auto* unit = find<QComboBox>("calibrationImportUnit");
  unit->setFocus();
  unit->lineEdit()->selectAll();
  QTest::keyClicks(unit->lineEdit(), QStringLiteral("0.001"));
  QTest::keyClick(unit->lineEdit(), Qt::Key_Return);
  // The unit is answered; what is asked next is which of the file's three cameras the demo's two
  // are.
  QVERIFY(waitText("calibrationImportPreview", QStringLiteral("3 cameras")));
  QVERIFY(preview("calibrationImportPreview").contains(QStringLiteral("Names in the file")));
  choose("calibrationImportName0", "right");
  choose("calibrationImportName1", "left");
  QVERIFY2(waitReady(dialog), qPrintable(preview("calibrationImportPreview")));
  const QString matched = preview("calibrationImportPreview");
  const auto first = matched.indexOf(QStringLiteral("(in the file: right)"));
  const auto second = matched.indexOf(QStringLiteral("(in the file: left)"));
  QVERIFY2(first >= 0 && first < second, qPrintable(matched));
  QVERIFY(QApplication::activeModalWidget() == nullptr);
}

void CalibrationImportTest::aBrokenFileIsOneSentence() {
  auto* dialog = openImport();
  const QString file = folder_.filePath(QStringLiteral("broken.toml"));
  QFile out(file);
  QVERIFY(out.open(QIODevice::WriteOnly));
  out.write("[cam_0]\nname = \"a\"\nsize = [640, 480]\n");
  out.close();
  const Camera before = camera(0);
  type("calibrationImportFile", file);
  QVERIFY(waitText("calibrationImportPreview", QStringLiteral("broken.toml")));
  QVERIFY(!dialog->isReady());
  const QString said = find<MessageBar>("messageBar")->text();
  QVERIFY2(said.contains(QStringLiteral("broken.toml")), qPrintable(said));
  QVERIFY(camera(0) == before);
  QCOMPARE(history().count(), 0);
}

void CalibrationImportTest::whatIsExportedComesBack_data() {
  QTest::addColumn<QString>("format");
  for (const CalibrationFormat& format : calibrationFormats()) {
    if (format.write != nullptr && !format.firstCameraIsWorld) { // the world stays
      QTest::newRow(format.name) << QString::fromLatin1(format.name);
    }
  }
}

void CalibrationImportTest::whatIsExportedComesBack() {
  QFETCH(QString, format);
  const CameraRig before = {camera(0), camera(1)};
  find<QAction>("actionExportCalibration")->trigger();
  auto* out = window_->findChild<CalibrationExportDialog*>();
  QVERIFY(out != nullptr && !out->isModal());
  choose("calibrationExportFormat", qPrintable(format));
  type("calibrationExportFile", folder_.filePath(QStringLiteral("out-%1").arg(format)));
  QVERIFY2(waitReady(out), qPrintable(preview("calibrationExportPreview")));
  QVERIFY(!QFileInfo::exists(out->file())); // a preview leaves nothing
  const QString file = out->file();
  QTest::mouseClick(find<QPushButton>("calibrationExportAccept"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return QFileInfo::exists(file); }));
  QVERIFY(waitFor(
      [&] { return find<MessageBar>("messageBar")->text().contains(QStringLiteral("Saved")); }));
  QVERIFY(out->isVisible()); // for another format, as the export of a trajectory
  QVERIFY(preview("calibrationExportPreview").contains(QStringLiteral("Saved")));
  QCOMPARE(find<QLabel>("calibrationExportPreviewTitle")->text(), QStringLiteral("Result"));
  // Cameras elsewhere; then they come back from the file.
  QVERIFY(window_->document().edit(QStringLiteral("elsewhere"), [](Project& project) {
    for (ProjectCamera& one : project.cameras) {
      one.hasOwnCalibration = true;
      one.camera.cameraFromWorld.translation() += Eigen::Vector3d(0.1, 0.0, 0.0);
    }
  }));
  auto* in = openImport();
  type("calibrationImportFile", file);
  QVERIFY2(waitFor([&] { return in->isReady() || asksFor("Unit") || asksFor("Format"); }),
           qPrintable(preview("calibrationImportPreview")));
  if (asksFor("Unit")) {
    choose("calibrationImportUnit", format == QLatin1String("anipose") ? "mm" : "m");
  }
  QVERIFY2(waitFor([&] { return in->isReady() || asksFor("Format"); }),
           qPrintable(preview("calibrationImportPreview")));
  if (asksFor("Format")) {
    choose("calibrationImportFormat", qPrintable(format)); // dialects that share their keys
  }
  QVERIFY2(waitReady(in), qPrintable(preview("calibrationImportPreview")));
  QTest::mouseClick(find<QPushButton>("calibrationImportAccept"), Qt::LeftButton);
  QCOMPARE(history().count(), 2);
  for (std::size_t k = 0; k < 2; ++k) {
    const Camera after = camera(static_cast<int>(k));
    QVERIFY((after.center() - before[k].center()).norm() < 1e-6);
    // A point of the room is seen at the same pixel.
    const Eigen::Vector3d point = before[k].center() + 1.3 * before[k].opticalAxis();
    const auto was = Projector(before[k]).project(point);
    const auto is = Projector(after).project(point);
    QVERIFY(was && is && (*was - *is).norm() < 1e-4);
  }
}

void CalibrationImportTest::theFileThatWasFoundIsTheOneNamed() {
  find<QAction>("actionExportCalibration")->trigger();
  auto* out = window_->findChild<CalibrationExportDialog*>();
  QVERIFY(out != nullptr);
  choose("calibrationExportFormat", "dewpoint");
  QVERIFY2(waitReady(out), qPrintable(preview("calibrationExportPreview")));
  const QString there = folder_.filePath(QStringLiteral("there.toml"));
  QFile file(there);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.close();
  out->setFile(there);
  // Changed while the preview is made, and not yet entered.
  find<QLineEdit>("calibrationExportFile")->setText(folder_.filePath(QStringLiteral("other.toml")));
  QVERIFY(waitText("calibrationExportPreview", QStringLiteral("there.toml exists")));
}

void CalibrationImportTest::anExportHasAFileAtOnce() {
  QVERIFY(window_->document().edit(QStringLiteral("name"),
                                   [](Project& project) { project.name = "take 1.5"; }));
  const Project saved = project();
  window_->document().markSaved(saved, path("saved.toml"));
  find<QAction>("actionExportCalibration")->trigger();
  auto* out = window_->findChild<CalibrationExportDialog*>();
  QCOMPARE(out->file(), file("take 1.5-calibration.toml"));
  QVERIFY(waitReady(out));
  // Another format: another ending, and the same name.
  choose("calibrationExportFormat", "qualisys");
  const std::string ending = (*findCalibrationFormat("qualisys"))->extension;
  QCOMPARE(out->file(), file("take 1.5-calibration") + QString::fromStdString(ending));
  choose("calibrationExportFormat", "dewpoint");
  QCOMPARE(out->file(), file("take 1.5-calibration.toml"));
  // What rounding costs is no news.
  QVERIFY(waitText("calibrationExportPreview", QStringLiteral("No accuracy is lost")));
  QVERIFY(!preview("calibrationExportPreview").contains(QStringLiteral("move by")));
}

void CalibrationImportTest::theButtonFollowsWhatIsTyped() {
  find<QAction>("actionExportCalibration")->trigger();
  auto* out = window_->findChild<CalibrationExportDialog*>();
  QVERIFY(waitReady(out));
  auto* line = find<QLineEdit>("calibrationExportFile");
  const auto* accept = find<QPushButton>("calibrationExportAccept");
  line->setFocus();
  line->selectAll();
  QTest::keyClick(line, Qt::Key_Backspace);
  QVERIFY(waitFor([&] { return !accept->isEnabled(); }));
  QTest::keyClicks(line, file("typed.toml")); // and neither Tab nor Enter
  QVERIFY(waitFor([&] { return accept->isEnabled(); }));
  QTest::mouseClick(find<QPushButton>("calibrationExportAccept"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return QFileInfo::exists(file("typed.toml")); }));
}

void CalibrationImportTest::theListOfCamerasOpensTheSameDialog() {
  auto* button = find<QPushButton>("cameraLoadCalibration");
  QCOMPARE(button->text(), find<QAction>("actionImportCalibration")->text());
  QVERIFY(window_->findChild<CalibrationImportDialog*>() == nullptr);
  button->click();
  QVERIFY(window_->findChild<CalibrationImportDialog*>() != nullptr);
}

void CalibrationImportTest::aCameraWithoutANameCanBeMeant() {
  Document document;
  Project nameless = window_->document().project();
  nameless.cameras[0].camera.name = "left";
  nameless.cameras[1].camera.name.clear();
  document.replaceProject(nameless);
  const CameraListModel cameras(document);
  CalibrationImportDialog dialog(document, cameras);
  auto* meant = dialog.findChild<QComboBox*>("calibrationImportCamera");
  QCOMPARE(meant->count(), 3);
  QVERIFY(!meant->itemData(0).isValid()); // as the names say
  QCOMPARE(meant->itemText(1), QStringLiteral("import only for left"));
  QCOMPARE(meant->itemData(1), QVariant(0));
  QCOMPARE(meant->itemText(2), QStringLiteral("import only for camera 2"));
  QCOMPARE(meant->itemData(2), QVariant(1));
  // Named meanwhile: the list follows, and what was chosen stays.
  meant->setCurrentIndex(2);
  QVERIFY(document.edit(QStringLiteral("name"),
                        [](Project& project) { project.cameras[1].camera.name = "by the door"; }));
  QCOMPARE(meant->currentText(), QStringLiteral("import only for by the door"));
  // With another camera, row 2 need not be the one that was chosen.
  QVERIFY(document.editSources(QStringLiteral("add"), [](Project& project) {
    project.cameras.push_back(project.cameras.front());
    project.cameras.back().camera.name = "third";
  }));
  QCOMPARE(meant->count(), 4);
  QCOMPARE(meant->itemText(3), QStringLiteral("import only for third"));
  QCOMPARE(meant->currentIndex(), 0);
  document.undoStack()->undo();
  QCOMPARE(meant->count(), 3);
}

DEWPOINT_WINDOW_TEST(CalibrationImportTest)

} // namespace dewpoint::tests

#include "calibration_import_test.moc"
