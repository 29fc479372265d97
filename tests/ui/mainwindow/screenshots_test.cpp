// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of every view in both themes, as the manual shows them: into the folder that
// DEWPOINT_SCREENSHOTS names, or beside the test.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/exchange/calibration_import.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/export/export_dialog.h"
#include "ui/export/view_picture.h"
#include "ui/selection/selection.h"
#include "ui/widgets/message_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QUndoStack>

#include <set>

namespace dewpoint::tests {

namespace {

constexpr qint64 kShownFrame = 120; ///< by then the demo's ball has left a path
constexpr std::size_t kColors = 8;  ///< fewer are an empty picture

/// How many colors a picture has, up to kColors.
std::size_t colorsOf(const QImage& picture) {
  std::set<QRgb> colors;
  for (int y = 0; y < picture.height() && colors.size() < kColors; y += 3) {
    for (int x = 0; x < picture.width() && colors.size() < kColors; x += 3) {
      colors.insert(picture.pixel(x, y));
    }
  }
  return colors.size();
}

} // namespace

class ScreenshotsTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void everyView_data();
  void everyView();

private:
  void keep(const QImage& picture, const QString& name);
  /// The whole window, once nothing in it changes any more.
  void keepWindow(const QString& name);
  bool rests() const { return shown().state != PlayState::Playing; }
  void keepCalibration();
  void keepWaving();
  void keepPlan();
  void keepPeople();
  void keepBoxes();
  /// The dialog that an action opens.
  void keepDialog(const char* id, const char* dialog);

  QString theme_;
};

void ScreenshotsTest::everyView_data() {
  QTest::addColumn<int>("theme");
  QTest::newRow("light") << static_cast<int>(Theme::Light);
  QTest::newRow("dark") << static_cast<int>(Theme::Dark);
}

void ScreenshotsTest::keep(const QImage& picture, const QString& name) {
  QVERIFY2(colorsOf(picture) >= kColors, qPrintable(name + QStringLiteral(" is empty")));
  const QString folder =
      qEnvironmentVariable("DEWPOINT_SCREENSHOTS", QStringLiteral("screenshots"));
  QVERIFY(QDir().mkpath(folder));
  const QString file = QStringLiteral("%1/%2-%3.png").arg(folder, name, theme_);
  QVERIFY2(picture.save(file), qPrintable(file));
}

void ScreenshotsTest::keepWindow(const QString& name) {
  QVERIFY(settles(*window_));
  keep(window_->grab().toImage(), name);
}

void ScreenshotsTest::keepCalibration() {
  action("actionShowMask")->setChecked(false);
  action("actionCalibrateByHand")->setChecked(true);
  keepWindow(QStringLiteral("calibration-hand"));
  // Two measured points, one clicked three pixels beside.
  const auto& cameras = window_->document().project().cameras;
  const Eigen::Vector3d ball = window_->shown()->targets.at(0).truth.value();
  std::vector<MeasuredPoint> points;
  for (const auto& [name, offset] : {std::pair("table corner", Eigen::Vector3d(0.05, 0.05, -0.04)),
                                     std::pair("door frame", Eigen::Vector3d(-0.06, 0.04, 0.03))}) {
    MeasuredPoint& point = points.emplace_back();
    point.name = name;
    point.world = ball + offset;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      if (const auto seen = Projector(cameras[k].camera).project(point.world)) {
        const double beside = points.size() == 2 && k == 0 ? 3.0 : 0.2;
        point.clicks.push_back({static_cast<int>(k), *seen + Eigen::Vector2d(beside, 0.0)});
      }
    }
  }
  QVERIFY(window_->document().edit(QStringLiteral("points"),
                                   [&](Project& project) { project.measuredPoints = points; }));
  auto* list = find<QTableWidget>("pointsList");
  list->setCurrentCell(1, 0);
  find<QPushButton>("pointClick")->click();
  find<QCheckBox>("gridEdges")->setChecked(true);
  scrollTo(find<QWidget>("pointSolve"));
  QVERIFY(settles(*window_)); // the edges too
  auto* layer = find<QWidget>("gridLayer0");
  // On the second point, a little beside its click.
  const ImagePlacement& image = find<CameraView>("cameraView0")->placement();
  const Eigen::Vector2d click = points[1].clicks.at(0).pixel;
  const QPointF pointer = image.topLeft + image.scale * QPointF(click.x() + 3.0, click.y() + 2.0);
  QMouseEvent move(QEvent::MouseMove, pointer, layer->mapToGlobal(pointer), Qt::NoButton,
                   Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(layer, &move);
  keep(window_->grab().toImage(), QStringLiteral("calibration-points"));
  find<QCheckBox>("gridEdges")->setChecked(false);
  find<QPushButton>("pointClick")->setChecked(false);
  keepWaving();
  action("actionCalibrateByHand")->setChecked(false);
}

void ScreenshotsTest::keepWaving() {
  action("actionCalibrateWand")->trigger();
  QVERIFY(window_->document().edit(QStringLiteral("nudge"), [](Project& project) {
    project.cameras[1].hasOwnCalibration = true;
    project.cameras[1].camera.cameraFromWorld.translation() += Eigen::Vector3d(0.02, 0.01, 0.0);
  }));
  window_->selection().selectRange(SelectedRange{60, 199});
  find<QCheckBox>("wandSpan")->click();
  find<QPushButton>("wandTake")->click();
  find<QPushButton>("wandRefine")->click();
  auto* progress = find<QWidget>("wandProgress");
  QVERIFY(waitFor([&] { return !progress->isVisible(); }));
  if (auto* apply = find<QPushButton>("wandApply"); apply->isVisible()) {
    apply->click();
  }
  scrollTo(find<QWidget>("wandReport"));
  keepWindow(QStringLiteral("calibration-wave"));
  action("actionImportCalibration")->trigger();
  auto* import = window_->findChild<CalibrationImportDialog*>();
  const QString here = QDir::currentPath(); // no folder of this machine in the manual
  QVERIFY(QDir::setCurrent(QStringLiteral(DEWPOINT_SOURCE_DIR "/tests/calibration/golden")));
  import->setFile(QStringLiteral("anipose_mm.toml"));
  const auto* preview = find<QPlainTextEdit>("calibrationImportPreview");
  QVERIFY(waitFor([&] { return !preview->toPlainText().isEmpty(); }));
  QVERIFY(settles(*import));
  QVERIFY(QDir::setCurrent(here));
  keep(import->grab().toImage(), QStringLiteral("calibration-import"));
  import->close();
  window_->findChild<MessageBar*>()->dismiss();
  window_->document().undoStack()->undo();
  window_->document().undoStack()->undo();
}

void ScreenshotsTest::keepPlan() {
  action("actionPlanRig")->trigger();
  action("actionShowMap")->setChecked(true);
  action("actionFindPlace")->trigger();
  auto* list = find<QComboBox>("planCamera");
  const auto* plan = window_->findChild<RigPlanner*>();
  const std::size_t cameras = window_->document().project().cameras.size() + 1;
  QVERIFY(waitFor([&] { return list->count() == 1; }));
  QVERIFY(waitFor([&] { return plan->map() != nullptr && plan->map()->cameraCount == cameras; }));
  keepWindow(QStringLiteral("calibration-plan"));
  find<QCheckBox>("mapVolume")->click();
  action("actionLookFree")->trigger();
  keepWindow(QStringLiteral("calibration-plan-volume"));
  find<QCheckBox>("mapVolume")->click();
  action("actionLookFromAbove")->trigger();
  action("actionShowMap")->setChecked(false);
  find<QPushButton>("planRemove")->click();
  action("actionCalibrateByHand")->setChecked(false);
}

void ScreenshotsTest::keepPeople() {
  open(DEWPOINT_SOURCE_DIR "/docs/examples/people_office.toml");
  static constexpr qint64 kMeeting = 118; // two have met in the middle
  QVERIFY(waitFor([this] { return shown().frame >= kMeeting; }));
  action("actionPlay")->trigger();
  window_->selection().requestFrame(kMeeting);
  action("actionLookFree")->trigger();
  QVERIFY(waitFor([this] { return rests() && shown().frame == kMeeting; }));
  keepWindow(QStringLiteral("people"));
}

void ScreenshotsTest::keepDialog(const char* id, const char* dialog) {
  action(id)->trigger();
  auto* shown = find<QWidget>(dialog);
  QVERIFY2(waitFor([shown] { return shown->isVisible(); }), dialog);
  QVERIFY(settles(*shown));
  keep(shown->grab().toImage(), QLatin1String(dialog));
  shown->close();
}

void ScreenshotsTest::keepBoxes() {
  open(DEWPOINT_SOURCE_DIR "/docs/examples/histogram.toml");
  static constexpr qint64 kMiddle = 45; // before the bar hides the ball
  QVERIFY(waitFor([this] { return shown().frame >= kMiddle; }));
  action("actionPlay")->trigger();
  window_->selection().requestFrame(kMiddle);
  find<QDockWidget>("targetDock")->raise();
  QVERIFY(waitFor([this] { return rests() && shown().frame == kMiddle; }));
  keepWindow(QStringLiteral("boxes"));
  action("actionExportTrajectory")->trigger();
  find<QLineEdit>("boxExportFolder")->setText(QStringLiteral("boxes"));
  keepDialog("actionExportTrajectory", "boxExportDialog");
}

void ScreenshotsTest::everyView() {
  QFETCH(int, theme);
  theme_ = QLatin1String(QTest::currentDataTag());
  makeWindow({.size = {1400, 900}, .theme = static_cast<Theme>(theme)});
  keep(window_->grab().toImage(), QStringLiteral("start"));
  action("actionNew")->trigger();
  keepWindow(QStringLiteral("new-project"));

  open();
  QVERIFY(waitFor([this] { return shown().frame >= kShownFrame; }));
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return rests(); }));
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QVERIFY(settles(*dock));
    if (dock->isVisible() && dock->width() > 50 && dock->height() > 30) {
      keep(grabView(dock->widget()), dock->objectName());
    }
  }
  action("actionResetLayout")->trigger();
  keepWindow(QStringLiteral("window"));
  find<QDockWidget>("colorDock")->raise();
  action("actionShowMask")->setChecked(true);
  QVERIFY(waitFor([this] { return !shown().masks.empty(); }));
  keepWindow(QStringLiteral("window-color"));
  keepCalibration();
  keepPlan();
  keepDialog("actionShortcuts", "shortcutEditor");
  keepDialog("actionExperiments", "experimentDialog");
  keepDialog("actionPalette", "commandPalette");
  action("actionExportTrajectory")->trigger();
  find<QLineEdit>("exportFile")->setText(QStringLiteral("trajectory.csv"));
  const auto* preview = find<QPlainTextEdit>("exportPreview");
  QVERIFY(waitFor([&] { return !preview->toPlainText().isEmpty(); }));
  keepDialog("actionExportTrajectory", "exportDialog");
  action("actionShowMask")->setChecked(false);
  keepPeople();
  keepBoxes();
}

DEWPOINT_WINDOW_TEST(ScreenshotsTest)

} // namespace dewpoint::tests

#include "screenshots_test.moc"
