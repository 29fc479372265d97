// SPDX-License-Identifier: GPL-3.0-or-later
// Taking the trajectory home from the window, while tracking goes on.
#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/export/export_catalog.h"
#include "tests/ui/export/dialog_fields.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/export/export_dialog.h"
#include "ui/export/export_text.h"
#include "ui/export/trajectory_figure.h"
#include "ui/export/view_picture.h"
#include "ui/mainwindow/view_pictures.h"
#include "ui/selection/selection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSvgRenderer>

namespace dewpoint::tests {

class ExportTest : public QObject,
                   private test::WindowFixture,
                   private test::DialogFields<ExportDialog*> {
  Q_OBJECT
private Q_SLOTS:
  void initTestCase();
  void cleanupTestCase() { window_.reset(); }
  void formatsHaveNames();
  void isNotModal();
  void previewFollowsTheChoices();
  void writesInTheBackground();
  void saysWhatFailed();
  void asksBeforeAFileIsReplaced();
  void whoCancelsIsNotAsked();
  void asksBeforeOneOfSeveralFilesIsReplaced();
  void theRangeIsTheSelectedOne();
  void itsKeyWorksWhileAFieldHasTheFocus();
  void aLongPreviewCanBeStopped();
  void theNextProjectIsExportedAnew();
  void enterInAFieldExportsNothing();
  void drawsAFigure();
  void takesPicturesOfEveryView();

private:
  QString preview() const { return field<QPlainTextEdit>("exportPreview")->toPlainText(); }
  void chooseFormat(std::string_view id) const {
    field<QComboBox>("exportFormat")->setCurrentText(exportFormatName(id));
  }
};

namespace {

Trajectory smallRun() {
  Trajectory trajectory;
  for (std::int64_t frame = 0; frame < 30; ++frame) {
    TrajectorySample sample;
    sample.frame = frame;
    sample.time = static_cast<double>(frame) / 30.0;
    sample.target = "ball";
    sample.position = {std::cos(0.2 * static_cast<double>(frame)), 0.1, 0.5};
    sample.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    sample.isValid = frame < 10 || frame > 14;
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

} // namespace

void ExportTest::initTestCase() {
  makeWindow({.size = {1400, 900}});
  window_->openProject({});
  QTRY_VERIFY_WITH_TIMEOUT(window_->shown() != nullptr && window_->shown()->frame > 20, kTimeoutMs);
  window_->findChild<QAction*>(QStringLiteral("actionExportTrajectory"))->trigger();
  dialog_ = window_->findChild<ExportDialog*>();
  QVERIFY(dialog_ != nullptr);
  QVERIFY(QTest::qWaitForWindowExposed(dialog_));
}

void ExportTest::formatsHaveNames() {
  for (const ExportFormat& format : exportFormats()) {
    // In the language of the source the window says what the core says.
    QCOMPARE(exportFormatName(format.id).toStdString(), std::string(format.title));
  }
}

void ExportTest::isNotModal() {
  QVERIFY(!dialog_->isModal());
  const auto before = window_->shown()->frame;
  QTRY_VERIFY_WITH_TIMEOUT(window_->shown()->frame > before, kTimeoutMs);
}

void ExportTest::previewFollowsTheChoices() {
  QTRY_VERIFY_WITH_TIMEOUT(preview().contains(QStringLiteral("time_s,frame,target,x_m")),
                           kTimeoutMs);
  chooseFormat("trc");
  QTRY_VERIFY_WITH_TIMEOUT(preview().startsWith(QStringLiteral("PathFileType")), kTimeoutMs);
  QVERIFY(field<QLabel>("exportUnits")->text().contains(QStringLiteral("Y points up")));
  QVERIFY(field<QLineEdit>("exportFile")->text().endsWith(QStringLiteral("trajectory.trc")));
  field<QComboBox>("exportUnit")->setCurrentIndex(2);
  QTRY_VERIFY_WITH_TIMEOUT(preview().contains(QStringLiteral("\tmm\t")), kTimeoutMs);
  field<QDoubleSpinBox>("exportTo")->setValue(0.1);
  QTRY_VERIFY_WITH_TIMEOUT(field<QLabel>("exportSize")->text().contains(QStringLiteral("rows: 4")),
                           kTimeoutMs);
  field<QComboBox>("exportEstimates")->setCurrentIndex(1);
  field<QComboBox>("exportUnit")->setCurrentIndex(0);
  chooseFormat("csv");
  QTRY_VERIFY_WITH_TIMEOUT(preview().contains(QStringLiteral("estimates: smoothed")), kTimeoutMs);
}

void ExportTest::writesInTheBackground() {
  const int place = field<QComboBox>("exportUnit")->y();
  for (const ExportFormat& format : exportFormats()) {
    chooseFormat(format.id);
    const QString file =
        folder_.filePath(QStringLiteral("out-") + QString::fromUtf8(format.id.data()) +
                         QString::fromUtf8(format.suffix.data()));
    field<QLineEdit>("exportFile")->setText(file);
    auto* start = field<QPushButton>("exportStart");
    QTest::mouseClick(start, Qt::LeftButton);
    QVERIFY(!start->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
    QVERIFY2(QFileInfo(file).size() > 0, qPrintable(file));
    // Where the user looks, not behind the dialog.
    const QString said = field<QLabel>("exportOutcome")->text();
    QVERIFY2(said.contains(file), qPrintable(said));
    QVERIFY(field<QPushButton>("exportShowFolder")->isVisible());
    QVERIFY(!messageText().contains(file));
    QVERIFY(keepsItsSize(field<QPushButton>("exportShowFolder")));
    QCOMPARE(field<QComboBox>("exportUnit")->y(), place); // the fields stay where they are
  }
}

void ExportTest::saysWhatFailed() {
  chooseFormat("csv");
  field<QLineEdit>("exportFile")->setText(folder_.filePath(QStringLiteral("no/folder/a.csv")));
  auto* start = field<QPushButton>("exportStart");
  QTest::mouseClick(start, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
  QVERIFY(field<QLabel>("exportOutcome")->text().contains(QStringLiteral("no/folder/a.csv")));
  QVERIFY(field<QLabel>("exportOutcome")->isVisible());
  QVERIFY(!field<QPushButton>("exportShowFolder")->isVisible());
}

void ExportTest::asksBeforeAFileIsReplaced() {
  const QString file = folder_.filePath(QStringLiteral("precious.csv"));
  QVERIFY(writeTextFile(file.toStdString(), "precious"));
  chooseFormat("csv");
  field<QLineEdit>("exportFile")->setText(file);
  auto* start = field<QPushButton>("exportStart");
  auto* question = field<QLabel>("exportQuestion");
  // Whether there is such a file is found out beside the window.
  const auto isAsked = [&] {
    return waitFor([&] { return question->isVisible() && start->isEnabled(); });
  };
  QTest::mouseClick(start, Qt::LeftButton);
  QVERIFY(isAsked());
  QVERIFY(question->text().contains(QStringLiteral("precious.csv")));
  QCOMPARE(start->text(), QStringLiteral("Replace"));
  // Any change, and closing, take the question back: then the next press asks again.
  field<QCheckBox>("exportHeader")->toggle();
  QVERIFY(!question->isVisible());
  QTest::mouseClick(start, Qt::LeftButton);
  QVERIFY(isAsked());
  dialog_->close();
  dialog_->show();
  QVERIFY(!question->isVisible());
  QTest::mouseClick(start, Qt::LeftButton);
  QVERIFY(isAsked());
  QCOMPARE(*readTextFile(file.toStdString()), std::string("precious"));
  QTest::mouseClick(start, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
  QVERIFY(QFileInfo(file).size() > 100);
  QVERIFY(writeTextFile(file.toStdString(), "precious")); // by another program, since
  QTest::mouseClick(start, Qt::LeftButton);
  QVERIFY(isAsked());
  field<QCheckBox>("exportHeader")->toggle();
  // What changes before the answer is there is not what was asked about: it is reported.
  const QSignalSpy failed(dialog_, &ExportDialog::failed);
  QTest::mouseClick(start, Qt::LeftButton);
  QVERIFY(!start->isEnabled());
  field<QLineEdit>("exportFile")->setText(folder_.filePath(QStringLiteral("other.csv")));
  QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
  QVERIFY(!question->isVisible());
  QCOMPARE(failed.count(), 1);
  QVERIFY(failed[0][0].toString().contains(QStringLiteral("precious.csv")));
  QCOMPARE(*readTextFile(file.toStdString()), std::string("precious"));
  QVERIFY(!QFileInfo::exists(folder_.filePath(QStringLiteral("other.csv"))));
  // In a dialog that was closed nobody would see the question.
  field<QLineEdit>("exportFile")->setText(file);
  QTest::mouseClick(start, Qt::LeftButton);
  dialog_->close();
  QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
  QCOMPARE(failed.count(), 2);
  dialog_->show();
  QVERIFY(!question->isVisible());
  QCOMPARE(start->text(), QStringLiteral("Export"));
}

void ExportTest::whoCancelsIsNotAsked() {
  const QString file = folder_.filePath(QStringLiteral("kept.csv"));
  QVERIFY(writeTextFile(file.toStdString(), "precious"));
  field<QLineEdit>("exportFile")->setText(file);
  auto* start = field<QPushButton>("exportStart");
  const QSignalSpy done(dialog_, &ExportDialog::completed);
  start->click();
  QVERIFY(!start->isEnabled());
  field<QPushButton>("exportCancel")->click();
  QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
  QVERIFY(!field<QLabel>("exportQuestion")->isVisible());
  QCOMPARE(done.count(), 1);
  QVERIFY(done[0][0].toString().contains(QStringLiteral("canceled")));
  QCOMPARE(*readTextFile(file.toStdString()), std::string("precious"));
}

void ExportTest::asksBeforeOneOfSeveralFilesIsReplaced() {
  // The file itself is not there, but one of the frames that go beside it.
  QVERIFY(QDir(folder_.path()).mkpath(QStringLiteral("film-frames")));
  const QString frame = folder_.filePath(QStringLiteral("film-frames/00000.vtp"));
  QVERIFY(writeTextFile(frame.toStdString(), "precious"));
  chooseFormat("pvd");
  field<QLineEdit>("exportFile")->setText(folder_.filePath(QStringLiteral("film.pvd")));
  auto* question = field<QLabel>("exportQuestion");
  auto* start = field<QPushButton>("exportStart");
  QTest::mouseClick(start, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
  QVERIFY2(question->isVisible() && question->text().contains(QStringLiteral("00000.vtp")),
           qPrintable(question->text()));
  QCOMPARE(*readTextFile(frame.toStdString()), std::string("precious"));
  QVERIFY(!QFileInfo::exists(folder_.filePath(QStringLiteral("film.pvd"))));
  QTest::mouseClick(start, Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(start->isEnabled(), kTimeoutMs);
  QVERIFY(QFileInfo::exists(folder_.filePath(QStringLiteral("film.pvd"))));
  QVERIFY(readTextFile(frame.toStdString())->find("precious") == std::string::npos);
  chooseFormat("csv");
}

void ExportTest::theRangeIsTheSelectedOne() {
  auto* from = field<QDoubleSpinBox>("exportFrom");
  auto* to = field<QDoubleSpinBox>("exportTo");
  const auto open = [this] {
    window_->findChild<QAction*>(QStringLiteral("actionExportTrajectory"))->trigger();
  };
  // Frames 2 to 4 at 30 frames a second: 0.0666.. to 0.1333.. s, outwards to the milliseconds
  // shown.
  window_->selection().selectRange(SelectedRange{2, 4});
  open();
  QCOMPARE(from->value(), 0.066);
  QCOMPARE(to->value(), 0.134);
  QTRY_VERIFY_WITH_TIMEOUT(field<QLabel>("exportSize")->text().contains(QStringLiteral("rows: 3")),
                           kTimeoutMs);
  window_->selection().selectRange(std::nullopt);
  open();
  QCOMPARE(from->value(), from->minimum()); // the beginning
  QCOMPARE(to->value(), to->minimum());     // the end
  from->setValue(0.1);
  open();
  QCOMPARE(from->value(), 0.1); // typed by hand: it stays
  from->setValue(from->minimum());
}

void ExportTest::itsKeyWorksWhileAFieldHasTheFocus() {
  dialog_->close();
  window_->activateWindow();
  for (const char* name : {"targetName", "box_particles"}) {
    auto* edit = window_->findChild<QWidget*>(QLatin1String(name));
    QVERIFY(edit != nullptr);
    for (QWidget* one = edit; one != nullptr; one = one->parentWidget()) {
      if (auto* dock = qobject_cast<QDockWidget*>(one)) {
        dock->raise();
      }
    }
    edit->setFocus();
    QTRY_VERIFY_WITH_TIMEOUT(edit->hasFocus(), kTimeoutMs);
    QTest::keyClick(edit, Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(dialog_->isVisible(), kTimeoutMs);
    dialog_->close();
    window_->activateWindow();
  }
  dialog_->show();
}

void ExportTest::aLongPreviewCanBeStopped() {
  // Smoothing so many frames takes many seconds on any machine: it does not end by itself here.
  Trajectory run;
  for (std::int64_t k = 0; k < 60'000; ++k) {
    const double time = static_cast<double>(k) / 30.0;
    TrajectorySample sample = smallRun().samples.front();
    sample.frame = k;
    sample.time = time;
    sample.position = {std::cos(time), std::sin(time), 0.5};
    run.samples.push_back(sample);
  }
  ExportDialog dialog([&run] { return run; });
  dialog.findChild<QComboBox*>(QStringLiteral("exportEstimates"))->setCurrentIndex(1);
  dialog.show();
  auto* cancel = dialog.findChild<QPushButton*>(QStringLiteral("exportCancel"));
  auto* size = dialog.findChild<QLabel*>(QStringLiteral("exportSize"));
  QTRY_VERIFY_WITH_TIMEOUT(cancel->isVisible(), kTimeoutMs);
  QTRY_VERIFY_WITH_TIMEOUT(size->text().contains(QLatin1Char('%')), kTimeoutMs);
  QTest::mouseClick(cancel, Qt::LeftButton);
  QVERIFY(!cancel->isVisible());
  QVERIFY(size->text().contains(QStringLiteral("stopped")));
  letTimePass();
  QVERIFY(size->text().contains(QStringLiteral("stopped"))); // and it stays so
  // What is chosen next is shown; a stopped one is in nobody's way.
  dialog.findChild<QComboBox*>(QStringLiteral("exportEstimates"))->setCurrentIndex(0);
  QTRY_VERIFY_WITH_TIMEOUT(size->text().contains(QStringLiteral("rows: 60")), kTimeoutMs);
}

void ExportTest::theNextProjectIsExportedAnew() {
  QVERIFY(dialog_->isVisible());
  field<QLineEdit>("exportFile")->setText(folder_.filePath(QStringLiteral("of-the-demo.csv")));
  field<QDoubleSpinBox>("exportRate")->setValue(1500.0);
  auto project = *resolveProject("demo");
  const QString file = folder_.filePath(QStringLiteral("next.toml"));
  QVERIFY(saveProject(project, file.toStdString()));
  open(file.toStdString());
  QCOMPARE(field<QDoubleSpinBox>("exportRate")->value(), 0.0);
  QCOMPARE(QFileInfo(field<QLineEdit>("exportFile")->text()).dir(), QDir(folder_.path()));
  QVERIFY(!field<QLineEdit>("exportFile")->text().contains(QStringLiteral("of-the-demo")));
}

void ExportTest::enterInAFieldExportsNothing() {
  auto* name = field<QLineEdit>("exportFile");
  name->setText(folder_.filePath(QStringLiteral("entered.csv")));
  name->setFocus();
  QTest::keyClick(name, Qt::Key_Return);
  QVERIFY(field<QPushButton>("exportStart")->isEnabled());
  letTimePass(100);
  QVERIFY(!QFileInfo::exists(name->text()));
  QVERIFY(dialog_->isVisible());
}

void ExportTest::drawsAFigure() {
  const auto table = makeExportTable(smallRun(), {}, {});
  QVERIFY(table);
  const FigureTexts texts{"title", "time (s)", "from above"};
  const std::filesystem::path svg = folder_.filePath(QStringLiteral("f.svg")).toStdString();
  QVERIFY(writeTrajectoryFigure(*table, texts, svg));
  QSvgRenderer renderer(QString::fromStdString(svg.string()));
  QVERIFY(renderer.isValid());
  QCOMPARE(renderer.viewBox(), QRect(0, 0, 1000, 707));
  QVERIFY(readTextFile(svg)->find("from above") != std::string::npos);
  const std::filesystem::path pdf = folder_.filePath(QStringLiteral("f.pdf")).toStdString();
  QVERIFY(writeTrajectoryFigure(*table, texts, pdf));
  QVERIFY(readTextFile(pdf)->starts_with("%PDF-"));
}

void ExportTest::takesPicturesOfEveryView() {
  int taken = 0;
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
    if (!dock->isVisible() || dock->visibleRegion().isEmpty()) {
      continue;
    }
    const QImage picture = grabView(dock->widget());
    QVERIFY(picture.width() > 50 && picture.height() > 30);
    const QString file = folder_.filePath(dock->objectName() + QStringLiteral(".png"));
    QVERIFY(writePng(picture, file.toStdString()));
    QCOMPARE(QImage(file).size(), picture.size());
    ++taken;
  }
  QVERIFY(taken >= 4); // two cameras, the bird's-eye view, the plot
  // As the menus do: written beside the window, which shows how it went.
  auto* pictures = window_->findChild<ViewPictures*>();
  const QImage picture = window_->grab().toImage();
  const QString file = folder_.filePath(QStringLiteral("window.png"));
  pictures->write(picture, file);
  QVERIFY(waitFor([&] { return messageText().contains(QStringLiteral("window.png")); }));
  QCOMPARE(QImage(file).size(), picture.size());
  pictures->write(picture, QStringLiteral("/proc/none/window.png"));
  QVERIFY(waitFor([&] { return messageText().contains(QStringLiteral("/proc/none")); }));
}

DEWPOINT_WINDOW_TEST(ExportTest)

} // namespace dewpoint::tests

#include "export_test.moc"
