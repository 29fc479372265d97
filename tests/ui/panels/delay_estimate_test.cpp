// SPDX-License-Identifier: GPL-3.0-or-later
// Delays of cameras that were estimated during a run, shown and kept in the panel of the cameras.
#include "core/project/project.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/panels/camera_panel.h"
#include "ui/panels/delay_estimate.h"

#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QUndoStack>

#include <memory>
#include <vector>

namespace dewpoint::tests {

class DelayEstimateTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void isShownForTheCamerasAfterTheFirst();
  void isKeptAsOneStep();
  void isHiddenIfNothingIsEstimated();

private:
  void show(const std::vector<ClockEstimate>& clocks) {
    auto snapshot = std::make_shared<TrackSnapshot>(*window_->shown());
    snapshot->clocks = clocks;
    window_->findChild<CameraPanel*>()->setSnapshot(snapshot);
  }
  void select(int camera) {
    auto* list = find<QListView>("cameraList");
    list->setCurrentIndex(list->model()->index(camera, 0));
  }
  DelayEstimate* row() const { return find<DelayEstimate>("cameraDelayEstimate"); }
  double delay() const { return window_->document().project().cameras[1].delay; }
};

void DelayEstimateTest::init() {
  folder_ = QTemporaryDir();
  makeWindow();
  QVERIFY(recordDesk(folder_.path().toStdString()));
  window_->openProject(path("desk.toml"));
  QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame >= 0; }));
}

void DelayEstimateTest::isShownForTheCamerasAfterTheFirst() {
  show({{}, {0.0124, 0.0006, 0.0, 1e-4}});
  select(1);
  QVERIFY(!row()->isHidden());
  const QString text = row()->findChild<QLabel*>()->text();
  QVERIFY2(text.contains(QStringLiteral("later than left")), qPrintable(text));
  QVERIFY2(text.contains(QStringLiteral("12")), qPrintable(text));
  show({{}, {-0.005, 0.0006, 0.0, 1e-4}});
  QVERIFY(row()->findChild<QLabel*>()->text().contains(QStringLiteral("earlier than left")));
  select(0);
  QVERIFY(row()->isHidden());
}

void DelayEstimateTest::isKeptAsOneStep() {
  select(1);
  show({{}, {0.0124, 0.0006, 0.0, 1e-4}});
  find<QPushButton>("cameraKeepDelay")->click();
  QCOMPARE(delay(), 0.0124);
  QCOMPARE(window_->document().undoStack()->count(), 1);
  action("actionUndo")->trigger();
  QCOMPARE(delay(), 0.0);
}

void DelayEstimateTest::isHiddenIfNothingIsEstimated() {
  select(1);
  show({{}, {0.0, 0.0, 0.0, 0.0}});
  QVERIFY(row()->isHidden());
  show({});
  QVERIFY(row()->isHidden());
}

DEWPOINT_WINDOW_TEST(DelayEstimateTest)

} // namespace dewpoint::tests

#include "delay_estimate_test.moc"
