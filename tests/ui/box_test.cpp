// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that follow boxes, in the window: one video, no calibration, a click.
#include "app/wiring/open_project.h"
#include "core/base/text_file.h"
#include "core/capture/frame_writer.h"
#include "core/session/new_project.h"
#include "core/session/snapshot.h"
#include "tests/tracking/moving_patch.h"
#include "ui/birdseye/birds_eye_view.h"
#include "ui/camera/camera_view.h"
#include "ui/camera/pick_layer.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/mainwindow/message_bar.h"
#include "ui/selection/selection.h"
#include "ui/settings/theme.h"
#include "ui/trajectory/box_model.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include <functional>
#include <memory>

namespace dewpoint {

namespace {

constexpr int kPatienceMs = DEWPOINT_PATIENCE_MS;
constexpr int kFrames = 40;

} // namespace

class BoxTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void oneVideoWithoutACalibrationIsFollowedAfterAClick();
  void aDraggedBoxIsAStepThatCanBeUndone();
  void aBoxDraggedBeyondTheEdgeIsCutThere();
  void onlyTheFirstBoxStartsPlaying();
  void anAddedTargetThatIsUndoneLeavesNothing();
  void theBoxIsThereAfterARestart();
  void aBoxOutsideTheImageIsRefused();
  void whatIsSavedIsOpenedAgainWithItsBox();
  void lookingBackShowsTheBoxAsItWas();
  void boxesAreExported();
  void theMethodIsChosenInTheParameters();
  void theMenuHasTheStudies();
  void anExperimentIsRefusedAtOnceAndLeftAloneWhileItRuns();

private:
  template <class T> T* find(const char* name) {
    T* found = window_->findChild<T*>(QLatin1String(name));
    if (found == nullptr) {
      qFatal("no child named %s", name);
    }
    return found;
  }
  bool waitFor(const std::function<bool()>& holds) { return QTest::qWaitFor(holds, kPatienceMs); }
  QAction* action(const char* id) { return find<QAction>(id); }
  /// Opens the video as the page for new projects would, paused.
  void openVideo();
  QPoint placeOf(const Eigen::Vector2d& pixel);
  void clickAt(const Eigen::Vector2d& pixel);
  void dragTo(const QPoint& from, const QPoint& to);
  bool isTrackedTo(std::int64_t frame);
  std::size_t targetCount() { return window_->document().project().targets.size(); }
  const TargetSnapshot* first() const {
    const auto shown = window_->shown();
    return shown && !shown->targets.empty() ? &shown->targets.front() : nullptr;
  }
  bool hasBox() const { return first() != nullptr && first()->box.has_value(); }
  QString message() { return find<QLabel>("messageText")->text(); }

  QTemporaryDir folder_;
  std::filesystem::path video_;
  std::unique_ptr<MainWindow> window_;
};

void BoxTest::initTestCase() {
  video_ = folder_.filePath("patch.mkv").toStdString();
  auto writer = FrameWriter::video(video_.string(), 25.0);
  QVERIFY(writer);
  for (int frame = 0; frame < kFrames; ++frame) {
    QVERIFY(writer->write(MovingPatch{}.image(frame)));
  }
  QVERIFY(writer->finish());
}

void BoxTest::init() {
  QSettings().clear();
  window_ = std::make_unique<MainWindow>(&openProject);
  window_->resize(1400, 900);
  window_->setPlayOnOpen(false);
  window_->show();
  window_->activateWindow();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void BoxTest::openVideo() {
  NewProject wanted;
  wanted.cameras = {{"", SourceKind::Video, video_.string()}};
  const auto made = makeProject(wanted);
  QVERIFY(made);
  const auto file = folder_.filePath("one.toml").toStdString();
  QVERIFY(saveProject(made->project, file));
  window_->openProject(file);
  QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame == 0; }));
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(waitFor([&] { return !view->imageSize().isEmpty() && view->height() > 100; }));
  QTest::qWait(300); // the layout settles
}

QPoint BoxTest::placeOf(const Eigen::Vector2d& pixel) {
  const ImagePlacement& placement = find<CameraView>("cameraView0")->placement();
  return (placement.corner + QPointF(pixel.x(), pixel.y()) * placement.scale).toPoint();
}

void BoxTest::clickAt(const Eigen::Vector2d& pixel) {
  QTest::mouseClick(find<PickLayer>("cameraView0Pick"), Qt::LeftButton, Qt::NoModifier,
                    placeOf(pixel));
}

void BoxTest::dragTo(const QPoint& from, const QPoint& to) {
  auto* layer = find<PickLayer>("cameraView0Pick");
  QTest::mousePress(layer, Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(layer, (from + to) / 2);
  QTest::mouseRelease(layer, Qt::LeftButton, Qt::NoModifier, to);
}

bool BoxTest::isTrackedTo(std::int64_t frame) {
  return waitFor([&] { return window_->shown() && window_->shown()->history.head >= frame; });
}

void BoxTest::oneVideoWithoutACalibrationIsFollowedAfterAClick() {
  openVideo();
  QCOMPARE(window_->document().project().method, std::string("histogram"));
  QVERIFY(find<QDockWidget>("birdsEyeDock")->isHidden()); // there is nothing in space
  QVERIFY(!action("actionShowMask")->isEnabled());
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(kFrames - 1)); // the first click starts tracking
  QVERIFY(hasBox());
  const ImageBox truth = MovingPatch{}.box(kFrames - 1);
  const ImageBox found = first()->box->estimate.box;
  QVERIFY((found.center() - truth.center()).norm() < 12.0); // of a patch of 30 px
  QCOMPARE(window_->document().undoStack()->undoText(), QStringLiteral("Box of target 1"));
  // It is drawn in the color of the first target.
  auto* view = find<CameraView>("cameraView0");
  const QImage picture = view->grab().toImage();
  const QPoint corner = placeOf({found.x, found.center().y()});
  const QColor expected = targetColor(0);
  bool drawn = false;
  for (int dx = -2; dx <= 2; ++dx) {
    const QColor there = picture.pixelColor(corner + QPoint(dx, 3));
    drawn = drawn || (std::abs(there.red() - expected.red()) < 40 &&
                      std::abs(there.green() - expected.green()) < 40 &&
                      std::abs(there.blue() - expected.blue()) < 40);
  }
  QVERIFY(drawn);
  QVERIFY(find<QLabel>("targetBox")->text().contains(QStringLiteral("Similarity")));
  QVERIFY(find<QLabel>("statusPosition")->text().contains(QStringLiteral("px")));
}

void BoxTest::aDraggedBoxIsAStepThatCanBeUndone() {
  openVideo();
  const ImageBox box = MovingPatch{}.box(0);
  dragTo(placeOf({box.x, box.y}), placeOf({box.x + box.width, box.y + box.height}));
  QVERIFY(waitFor([this] { return !window_->document().project().targets.empty(); }));
  const auto taken = window_->document().project().targets.front().box;
  QVERIFY(taken);
  QVERIFY(overlap(taken->box, box) > 0.8); // a widget pixel is not one of the image
  QCOMPARE(taken->frame, std::int64_t{0});
  QVERIFY(isTrackedTo(kFrames - 1));
  action("actionUndo")->trigger();
  QVERIFY(window_->document().project().targets.empty());
  QVERIFY(waitFor([this] { return window_->shown()->targets.empty(); }));
  action("actionRedo")->trigger();
  QVERIFY(waitFor([this] { return hasBox() && !window_->shown()->rerun; }));
}

void BoxTest::aBoxDraggedBeyondTheEdgeIsCutThere() {
  openVideo(); // 320 x 240
  const QPoint far = find<CameraView>("cameraView0")->rect().bottomRight() + QPoint(40, 40);
  dragTo(placeOf({290.0, 200.0}), far);
  QVERIFY(waitFor([this] { return targetCount() == 1; }));
  ImageBox box = window_->document().project().targets[0].box->box;
  const double widgetPixel = 1.0 / find<CameraView>("cameraView0")->placement().scale;
  QVERIFY(std::abs(box.x - 290.0) <= widgetPixel && std::abs(box.y - 200.0) <= widgetPixel);
  QCOMPARE(box.x + box.width, 320.0);
  QCOMPARE(box.y + box.height, 240.0);
  // From the other corner, too.
  action("actionLearnColor")->trigger();
  dragTo(placeOf({40.0, 30.0}), QPoint(-30, -30));
  QVERIFY(waitFor([&] { return window_->document().project().targets[0].box->box != box; }));
  box = window_->document().project().targets[0].box->box;
  QCOMPARE(box.x, 0.0);
  QCOMPARE(box.y, 0.0);
  QVERIFY(std::abs(box.width - 40.0) <= widgetPixel && std::abs(box.height - 30.0) <= widgetPixel);
}

void BoxTest::onlyTheFirstBoxStartsPlaying() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(5)); // the first one
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->state != PlayState::Playing; }));
  action("actionRestart")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0; }));
  QVERIFY(window_->shown()->state != PlayState::Playing);
  for (const std::size_t count : {2U, 3U}) {
    action("actionAddTarget")->trigger();
    clickAt({60.0 * double(count), 40.0});
    QVERIFY(waitFor([&] { return targetCount() == count; }));
    QTest::qWait(300); // as long as a run that plays would take for some frames
    QCOMPARE(window_->shown()->state, PlayState::Paused);
    QCOMPARE(window_->shown()->frame, std::int64_t{0});
    QCOMPARE(window_->document().project().targets.back().box->frame, std::int64_t{0});
  }
}

void BoxTest::anAddedTargetThatIsUndoneLeavesNothing() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(kFrames - 1));
  window_->selection().wantMoment(12);
  QVERIFY(waitFor([this] { return window_->shown()->frame == 12; }));
  action("actionAddTarget")->trigger();
  clickAt(MovingPatch{}.box(12).center());
  QVERIFY(waitFor([this] { return targetCount() == 2; }));
  QVERIFY(waitFor([this] {
    return !window_->shown()->rerun && window_->shown()->history.head == kFrames - 1;
  }));
  window_->selection().wantMoment(5);
  QVERIFY(waitFor([this] { return window_->shown()->frame == 5; }));
  QCOMPARE(window_->shown()->targets.size(), std::size_t{2});
  QCOMPARE(window_->shown()->targets[1].status, TargetStatus::Gone); // not lost: not there yet
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->targets.size() == 1; }));
  QCOMPARE(window_->shown()->frame, std::int64_t{5});
  QVERIFY(
      waitFor([this] { return find<QLabel>("statusHeld")->text() == holdText(HoldState::Held); }));
  action("actionRedo")->trigger();
  QVERIFY(waitFor([this] { return targetCount() == 2 && !window_->shown()->rerun; }));
}

void BoxTest::theBoxIsThereAfterARestart() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(waitFor([this] { return window_->shown()->state == PlayState::Ended; }));
  action("actionRestart")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0 && hasBox(); }));
  QVERIFY(window_->shown()->history.head < 0); // nothing was tracked yet
  QVERIFY(find<QLabel>("targetBox")->text().contains(QStringLiteral("Similarity")));
  auto* choice = find<QComboBox>("methodChoice");
  const int row = choice->findData(QStringLiteral("sugandi"));
  choice->setCurrentIndex(row);
  Q_EMIT choice->activated(row);
  QCOMPARE(window_->document().project().method, std::string("sugandi"));
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0 && hasBox(); }));
}

void BoxTest::aBoxOutsideTheImageIsRefused() {
  const auto file = folder_.filePath("far.toml").toStdString();
  QVERIFY(writeTextFile(file, "format = 2\nname = \"far\"\nmethod = \"histogram\"\n"
                              "scene = \"occluder\"\n[[target]]\nname = \"ball\"\nbox = "
                              "{camera = 1, x = 900, y = 97, width = 46, height = 46}\n"));
  window_->openProject(file);
  QVERIFY(waitFor([this] { return message().contains(QStringLiteral("target 1.box")); }));
  QVERIFY(message().contains(QStringLiteral("far.toml")));
}

void BoxTest::whatIsSavedIsOpenedAgainWithItsBox() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(10));
  QVERIFY(window_->document().save());
  const auto targets = window_->document().project().targets;
  window_->openProject(folder_.filePath("one.toml").toStdString());
  QVERIFY(waitFor([this] { return hasBox() && window_->shown()->frame == 0; }));
  QVERIFY(window_->document().project().targets == targets);
}

void BoxTest::lookingBackShowsTheBoxAsItWas() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(20));
  window_->selection().wantMoment(0);
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0 && window_->shown()->past; }));
  QVERIFY(hasBox());
  QCOMPARE(first()->box->estimate.box, window_->document().project().targets[0].box->box);
}

void BoxTest::boxesAreExported() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(kFrames - 1));
  auto* dock = find<QDockWidget>("trajectoryDock");
  dock->show();
  dock->raise();
  auto* table = find<QTableView>("boxTable");
  QVERIFY(waitFor([&] { return table->model()->rowCount() == kFrames; }));
  action("actionExportTrajectory")->trigger();
  auto* folder = find<QLineEdit>("boxExportFolder");
  QVERIFY(waitFor([&] { return folder->isVisible(); }));
  const QString out = folder_.filePath("taken home");
  folder->setText(out);
  find<QPushButton>("boxExportExport")->click();
  QVERIFY(waitFor([&] { return message().contains(QStringLiteral("boxes.csv")); }));
  const auto csv = readTextFile((out + "/boxes.csv").toStdString());
  QVERIFY(csv);
  QVERIFY(csv->find("target 1") != std::string::npos);
  QVERIFY(readTextFile((out + "/boxes_mot.txt").toStdString()));
}

void BoxTest::theMethodIsChosenInTheParameters() {
  window_->openProject({}); // the demo: two calibrated cameras, a color
  QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame >= 0; }));
  auto* choice = find<QComboBox>("methodChoice");
  const int row = choice->findData(QStringLiteral("histogram"));
  QVERIFY(row >= 0);
  QVERIFY(choice->findData(QStringLiteral("sugandi")) >= 0);
  choice->setCurrentIndex(row);
  Q_EMIT choice->activated(row);
  QCOMPARE(window_->document().project().method, std::string("histogram"));
  QCOMPARE(message(),
           QStringLiteral("Click the thing or drag a box around it in any camera view."));
  QVERIFY(waitFor([this] { return window_->shown()->family == MethodFamily::Boxes; }));
  QVERIFY(find<QDockWidget>("birdsEyeDock")->isHidden());
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->family == MethodFamily::Targets; }));
  QVERIFY(!find<QDockWidget>("birdsEyeDock")->isHidden());
}

void BoxTest::theMenuHasTheStudies() {
  action("actionExperiments")->trigger();
  auto* list = find<QListWidget>("experimentList");
  QVERIFY(waitFor([&] { return list->isVisible(); }));
  const auto choose = [&](const char* name) {
    for (int row = 0; row < list->count(); ++row) {
      if (list->item(row)->data(Qt::UserRole).toString() == QLatin1String(name)) {
        list->setCurrentRow(row);
        return true;
      }
    }
    return false;
  };
  QVERIFY(choose("sugandi-rmse"));
  QVERIFY(find<QLineEdit>("experimentRecordings")->isVisible());
  QVERIFY(!find<QComboBox>("experimentClothes")->isVisible());
  for (const char* name : {"people-crossing", "people-meet-and-turn", "people-side-by-side",
                           "people-enter-leave", "people-apart"}) {
    QVERIFY(choose(name));
  }
  QVERIFY(!find<QLineEdit>("experimentRecordings")->isVisible());
  QVERIFY(find<QComboBox>("experimentClothes")->isVisible());
  QVERIFY(choose("barrera-fig3"));
  QVERIFY(!find<QComboBox>("experimentClothes")->isVisible());
}

void BoxTest::anExperimentIsRefusedAtOnceAndLeftAloneWhileItRuns() {
  action("actionExperiments")->trigger();
  auto* list = find<QListWidget>("experimentList");
  QVERIFY(waitFor([&] { return list->isVisible(); }));
  const auto rowOf = [&](const char* name) {
    int row = 0;
    while (list->item(row)->data(Qt::UserRole).toString() != QLatin1String(name)) {
      ++row;
    }
    return row;
  };
  auto* folder = find<QLineEdit>("experimentFolder");
  auto* state = find<QLabel>("experimentState");
  list->setCurrentRow(rowOf("people-crossing"));
  folder->setText(QStringLiteral("/proc/dewpoint"));
  find<QPushButton>("experimentRun")->click();
  QVERIFY(waitFor([&] { return state->text().contains(QStringLiteral("/proc/dewpoint")); }));
  QVERIFY(folder->isEnabled());
  folder->setText(folder_.filePath(QStringLiteral("people")));
  find<QPushButton>("experimentRun")->click();
  for (const char* name : {"experimentList", "experimentFolder", "experimentRuns",
                           "experimentClothes", "experimentBrowse", "experimentRun"}) {
    QVERIFY2(!find<QWidget>(name)->isEnabled(), name);
  }
  find<QPushButton>("experimentCancel")->click();
  QVERIFY(waitFor([&] { return folder->isEnabled(); }));
  QVERIFY(list->isEnabled());
}

} // namespace dewpoint

int main(int argc, char** argv) {
  dewpoint::BirdsEyeView::prepareSurfaceFormat();
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("dewpoint-test"));
  QApplication::setApplicationName(QStringLiteral("box"));
  dewpoint::BoxTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "box_test.moc"
