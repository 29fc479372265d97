// SPDX-License-Identifier: GPL-3.0-or-later
// The first minutes of a new user, by mouse alone, with every press counted: from launch to a 3D
// track and a CSV file of the demo, and from two videos beside a calibration file to the same.
#include "core/session/snapshot/snapshot.h"
#include "core/trajectory/trajectory_reader.h"
#include "tests/ui/event_loop_probe.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QMouseEvent>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include <memory>

namespace dewpoint::tests {

/// Counts the presses of mouse buttons in the whole application.
class ClickCounter : public QObject {
public:
  ClickCounter() { qApp->installEventFilter(this); }
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::MouseButtonPress && watched->isWidgetType() &&
        static_cast<QMouseEvent*>(event)->timestamp() != last_) {
      last_ = static_cast<QMouseEvent*>(event)->timestamp(); // parents get the same press again
      ++clicks;
    }
    return false;
  }
  int clicks = 0;

private:
  quint64 last_ = 0;
};

class FirstRunTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void fromLaunchToACsvOfTheDemo();
  void fromTwoVideosAndACalibrationToACsv();
  void fromTwoVideosToTheCalibrationGuide();

private:
  void click(QWidget* widget) { QTest::mouseClick(widget, Qt::LeftButton); }
  bool isHeld() {
    return waitFor([this] {
      const auto shown = window_->shown();
      return shown && shown->frame >= 3 && !shown->targets.empty() &&
             std::get<SphereEstimate>(shown->targets[0].estimate).isValid;
    });
  }
  /// Clicks these files in the next file dialog, and its "Open".
  void chooseFiles(const QStringList& names);

  std::unique_ptr<ClickCounter> counter_;
  std::unique_ptr<EventLoopProbe> probe_;
};

void FirstRunTest::init() {
  QDir::setCurrent(folder_.path());
  counter_ = std::make_unique<ClickCounter>();
  makeWindow({.size = {1400, 900}});
  probe_ = std::make_unique<EventLoopProbe>();
}

void FirstRunTest::cleanup() {
  qInfo("%d clicks, longest stall of the event loop %.0f ms", counter_->clicks,
        probe_->takeLongest());
  probe_.reset();
  window_.reset();
  counter_.reset();
  QDir::setCurrent(QDir::tempPath());
}

void FirstRunTest::chooseFiles(const QStringList& names) {
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, [this, names, timer] {
    auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
    auto* list = dialog == nullptr ? nullptr : dialog->findChild<QListView*>("listView");
    if (list == nullptr) {
      return;
    }
    std::vector<QModelIndex> wanted;
    for (int row = 0; row < list->model()->rowCount(list->rootIndex()); ++row) {
      const QModelIndex index = list->model()->index(row, 0, list->rootIndex());
      if (names.contains(index.data().toString())) {
        wanted.push_back(index);
      }
    }
    if (wanted.size() != static_cast<std::size_t>(names.size())) {
      return; // the folder is still being read
    }
    timer->stop();
    timer->deleteLater();
    Qt::KeyboardModifiers more = Qt::NoModifier;
    for (const QModelIndex& index : wanted) {
      QTest::mouseClick(list->viewport(), Qt::LeftButton, more, list->visualRect(index).center());
      more = Qt::ControlModifier;
    }
    click(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open));
  });
  timer->start(50);
}

void FirstRunTest::fromLaunchToACsvOfTheDemo() {
  click(find<QToolButton>("startDemo"));
  QVERIFY(isHeld());
  click(find<QToolButton>("actionExportTrajectoryButton"));
  auto* start = find<QPushButton>("exportStart");
  QVERIFY(waitFor([&] { return start->isVisible() && start->isEnabled(); }));
  find<QLineEdit>("exportFile")->setText(folder_.filePath("demo.csv")); // typed, not clicked
  click(start);
  QVERIFY(
      waitFor([&] { return QFile::exists(folder_.filePath("demo.csv")) && start->isEnabled(); }));
  const auto track = readTrajectory(folder_.filePath("demo.csv").toStdString());
  QVERIFY(track);
  QVERIFY(!track->samples.empty());
  QVERIFY2(counter_->clicks <= 10, "launch to a CSV of the demo"); // the promise to a new user
}

void FirstRunTest::fromTwoVideosAndACalibrationToACsv() {
  QVERIFY(recordDemo(folder_.path().toStdString(), 20));
  chooseFiles({"left.mkv", "right.mkv"});
  click(find<QToolButton>("startVideos"));
  auto* create = find<QPushButton>("newCreate");
  QVERIFY(waitFor([&] { return create->isEnabled(); })); // the calibration was found beside them
  click(create);
  QVERIFY2(waitFor([this] { return window_->shown() && window_->shown()->frame >= 0; }),
           qPrintable(find<QLabel>("messageText")->text()));
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(waitFor([&] { return !view->imageSize().isEmpty() && view->height() > 100; }));
  // The ball of the demo's first frame, as the first camera sees it: (0.5, 0.5, 0.15) m.
  const auto at = Projector(demoRig()[0]).project({0.5, 0.5, 0.15});
  QVERIFY(keepsItsSize(view)); // a person looks before the click
  const ImagePlacement& placement = view->placement();
  const QPointF place =
      placement.topLeft + (QPointF(at->x(), at->y()) + QPointF(0.5, 0.5)) * placement.scale;
  QTest::mouseClick(find<ImagePickOverlay>("cameraView0Pick"), Qt::LeftButton, Qt::NoModifier,
                    place.toPoint());
  QVERIFY(isHeld());
  QVERIFY(!hasGuessedPose(window_->document().project()));
  // The export goes beside the videos, unless one chooses another place.
  click(find<QToolButton>("actionExportTrajectoryButton"));
  auto* start = find<QPushButton>("exportStart");
  QVERIFY(waitFor([&] { return start->isVisible() && start->isEnabled(); }));
  const QString exported = find<QLineEdit>("exportFile")->text();
  QCOMPARE(QFileInfo(exported).dir(), QDir(folder_.path()));
  click(start);
  QVERIFY(waitFor([&] { return QFile::exists(exported) && start->isEnabled(); }));
  const auto track = readTrajectory(exported.toStdString());
  QVERIFY(track && !track->samples.empty());
  QVERIFY2(counter_->clicks <= 10, "two videos and a calibration file to a CSV of the track");
}

void FirstRunTest::fromTwoVideosToTheCalibrationGuide() {
  QVERIFY(recordDemo(folder_.path().toStdString(), 20));
  chooseFiles({"left.mkv", "right.mkv"});
  click(find<QToolButton>("startGuide"));
  auto* create = find<QPushButton>("newCreate");
  QVERIFY(waitFor([&] { return create->isEnabled(); }));
  click(create);
  QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame >= 0; }));
  QVERIFY(waitFor([this] { return find<QWidget>("guidePage")->isVisible(); }));
}

DEWPOINT_WINDOW_TEST(FirstRunTest)

} // namespace dewpoint::tests

#include "first_run_test.moc"
