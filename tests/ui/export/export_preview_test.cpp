// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialog shows before anything is written: numbers first, and how far the run goes.
#include "core/trajectory/export/export_catalog.h"
#include "tests/ui/export/dialog_fields.h"
#include "tests/ui/wait.h"
#include "tests/ui/window_test.h"
#include "ui/export/export_dialog.h"
#include "ui/export/export_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextCursor>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace dewpoint::tests {

class ExportPreviewTest : public QObject,
                          private test::Waiting,
                          private test::DialogFields<std::unique_ptr<ExportDialog>> {
  Q_OBJECT
private Q_SLOTS:
  void init();
  void cleanup() { dialog_.reset(); }
  void numbersAreSeenFirst();
  void aScrolledPreviewStaysWhereItIs();
  void aRangeBeyondTheRunSaysHowFarItGoes();

private:
  QPlainTextEdit* lines() const { return field<QPlainTextEdit>("exportPreview"); }
  /// The line at the top of the preview.
  QString firstSeen() const {
    return lines()->document()->findBlockByLineNumber(lines()->verticalScrollBar()->value()).text();
  }
  bool isSeen(const QString& start) const {
    for (QTextBlock block = lines()->document()->begin(); block.isValid(); block = block.next()) {
      if (block.text().startsWith(start)) {
        const QRect at = lines()->cursorRect(QTextCursor(block));
        return lines()->viewport()->rect().contains(at.center());
      }
    }
    return false;
  }
  bool isReady() const {
    return waitFor([this] { return !lines()->toPlainText().isEmpty(); });
  }

  Trajectory run_;
};

void ExportPreviewTest::init() {
  run_ = {};
  for (int k = 0; k < 30; ++k) {
    run_.header.entries.emplace_back("parameter " + std::to_string(k), "1");
  }
  for (std::int64_t frame = 0; frame <= 120; ++frame) { // 4 s
    TrajectorySample sample;
    sample.frame = frame;
    sample.time = static_cast<double>(frame) / 30.0;
    sample.target = "ball";
    sample.position = {0.1, 0.2, 0.3};
    sample.covariance = 1e-4 * Eigen::Matrix3d::Identity();
    sample.isValid = true;
    run_.samples.push_back(sample);
  }
  dialog_ = std::make_unique<ExportDialog>([this] { return run_; });
  dialog_->show();
  QVERIFY(QTest::qWaitForWindowExposed(dialog_.get()));
  field<QComboBox>("exportFormat")->setCurrentText(exportFormatName("csv"));
  field<QCheckBox>("exportHeader")->setChecked(true);
}

void ExportPreviewTest::numbersAreSeenFirst() {
  QVERIFY(isReady());
  QVERIFY(waitFor([this] { return isSeen(QStringLiteral("time_s,frame,target")); }));
  QVERIFY(isSeen(QStringLiteral("0.0333"))); // the second row
  QVERIFY2(firstSeen().startsWith(QStringLiteral("# ")), qPrintable(firstSeen()));
  QVERIFY(!isSeen(QStringLiteral("# dewpoint trajectory")));
  lines()->verticalScrollBar()->setValue(0);
  QVERIFY(isSeen(QStringLiteral("# dewpoint trajectory")));
  // Without notes it begins where the file does.
  field<QCheckBox>("exportHeader")->setChecked(false);
  QVERIFY(waitFor([this] { return firstSeen().startsWith(QStringLiteral("time_s")); }));
}

void ExportPreviewTest::aScrolledPreviewStaysWhereItIs() {
  QVERIFY(waitFor([this] { return isSeen(QStringLiteral("time_s,frame,target")); }));
  lines()->verticalScrollBar()->setValue(0);
  field<QDoubleSpinBox>("exportTo")->setValue(2.0);
  QVERIFY(waitFor(
      [this] { return field<QLabel>("exportSize")->text().contains(QStringLiteral("rows: 61")); }));
  QCOMPARE(lines()->verticalScrollBar()->value(), 0);
}

void ExportPreviewTest::aRangeBeyondTheRunSaysHowFarItGoes() {
  auto* to = field<QDoubleSpinBox>("exportTo");
  const auto* tracked = field<QLabel>("exportTrackedTo");
  QVERIFY(!tracked->isVisible()); // to the end
  to->setValue(4.0);
  QVERIFY(!tracked->isVisible());
  to->setValue(9.0);
  QVERIFY(tracked->isVisible());
  QCOMPARE(tracked->text(), QStringLiteral("tracked only up to 4.0 s"));
  to->setValue(4.02);
  QCOMPARE(tracked->text(), QStringLiteral("tracked only up to 4.000 s"));
  to->setValue(3.0);
  QVERIFY(!tracked->isVisible());
  dialog_->setSelectedRange(std::pair(1.0, 8.0));
  QVERIFY(tracked->isVisible());
  run_.samples.clear(); // nothing was tracked: nothing to compare with
  dialog_->refresh();
  QVERIFY(!tracked->isVisible());
}

DEWPOINT_WINDOW_TEST(ExportPreviewTest)

} // namespace dewpoint::tests

#include "export_preview_test.moc"
