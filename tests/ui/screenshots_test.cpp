// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of every view in both themes, as the manual shows them: into the folder that
// DEWPOINT_SCREENSHOTS names, or beside the test.
#include "app/wiring/open_project.h"
#include "core/session/run/snapshot.h"
#include "ui/calibration/exchange/calibration_import.h"
#include "ui/cameraview/camera_view.h"
#include "ui/color/color_panel.h"
#include "ui/document/document.h"
#include "ui/export/export_dialog.h"
#include "ui/export/view_picture.h"
#include "ui/mainwindow/main_window.h"
#include "ui/selection/selection.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include <memory>
#include <set>

namespace dewpoint::tests {

namespace {

constexpr int kPatienceMs =
    DEWPOINT_PATIENCE_MS;          ///< software OpenGL, a loaded machine, a sanitizer
constexpr int kSettleMs = 1500;    ///< the bird's-eye view and the plots draw at rates of their own
constexpr qint64 kFrame = 120;     ///< by then the demo's ball has left a path
constexpr std::size_t kColors = 8; ///< fewer are an empty picture

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

class ScreenshotsTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void everyView_data();
  void everyView();

private:
  void keep(const QImage& picture, const QString& name);
  void keepCalibration(MainWindow& window);
  void keepWaving(MainWindow& window);
  void keepPlan(MainWindow& window);
  void keepPeople(MainWindow& window);
  void keepBoxes(MainWindow& window);
  /// The dialog that an action opens.
  void keepDialog(MainWindow& window, const char* action, const char* dialog);

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

void ScreenshotsTest::keepCalibration(MainWindow& window) {
  window.findChild<QAction*>("actionShowMask")->setChecked(false);
  window.findChild<QAction*>("actionCalibrateByHand")->setChecked(true);
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("calibration-hand"));
  // Two measured points, one clicked three pixels beside.
  const auto& cameras = window.document().project().cameras;
  const Eigen::Vector3d ball = window.shown()->targets.at(0).truth.value();
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
  QVERIFY(window.document().edit(QStringLiteral("points"),
                                 [&](Project& project) { project.points = points; }));
  auto* list = window.findChild<QTableWidget*>("pointsList");
  list->setCurrentCell(1, 0);
  window.findChild<QPushButton*>("pointClick")->click();
  window.findChild<QCheckBox*>("gridEdges")->setChecked(true);
  for (QWidget* parent = list; parent != nullptr; parent = parent->parentWidget()) {
    if (auto* scroll = qobject_cast<QScrollArea*>(parent)) {
      scroll->ensureWidgetVisible(window.findChild<QWidget*>("pointSolve"));
    }
  }
  auto* layer = window.findChild<QWidget*>("gridLayer0");
  // On the second point, a little beside its click.
  const ImagePlacement& image = window.findChild<CameraView*>("cameraView0")->placement();
  const Eigen::Vector2d click = points[1].clicks.at(0).pixel;
  const QPointF pointer = image.corner + image.scale * QPointF(click.x() + 3.0, click.y() + 2.0);
  QMouseEvent move(QEvent::MouseMove, pointer, layer->mapToGlobal(pointer), Qt::NoButton,
                   Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(layer, &move);
  keep(window.grab().toImage(), QStringLiteral("calibration-points"));
  window.findChild<QCheckBox*>("gridEdges")->setChecked(false);
  window.findChild<QPushButton*>("pointClick")->setChecked(false);
  keepWaving(window);
  window.findChild<QAction*>("actionCalibrateByHand")->setChecked(false);
}

void ScreenshotsTest::keepWaving(MainWindow& window) {
  window.findChild<QAction*>("actionCalibrateWand")->trigger();
  QVERIFY(window.document().edit(QStringLiteral("nudge"), [](Project& project) {
    project.cameras[1].adjusted = true;
    project.cameras[1].camera.cameraFromWorld.translation() += Eigen::Vector3d(0.02, 0.01, 0.0);
  }));
  window.selection().selectSpan(FrameSpan{60, 199});
  window.findChild<QCheckBox*>("wandSpan")->click();
  window.findChild<QPushButton*>("wandTake")->click();
  window.findChild<QPushButton*>("wandRefine")->click();
  auto* progress = window.findChild<QWidget*>("wandProgress");
  QVERIFY(QTest::qWaitFor([&] { return !progress->isVisible(); }, kPatienceMs));
  if (auto* apply = window.findChild<QPushButton*>("wandApply"); apply->isVisible()) {
    apply->click();
  }
  auto* report = window.findChild<QWidget*>("wandReport");
  for (QWidget* parent = report; parent != nullptr; parent = parent->parentWidget()) {
    if (auto* scroll = qobject_cast<QScrollArea*>(parent)) {
      scroll->ensureWidgetVisible(report);
    }
  }
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("calibration-wave"));
  window.findChild<QAction*>("actionImportCalibration")->trigger();
  auto* import = window.findChild<CalibrationImportDialog*>();
  const QString here = QDir::currentPath(); // no folder of this machine in the manual
  QVERIFY(QDir::setCurrent(QStringLiteral(DEWPOINT_SOURCE_DIR "/tests/calibration/golden")));
  import->setFile(QStringLiteral("anipose_mm.toml"));
  QTest::qWait(kSettleMs);
  QVERIFY(QDir::setCurrent(here));
  keep(import->grab().toImage(), QStringLiteral("calibration-import"));
  import->close();
  window.findChild<MessageBar*>()->close();
  window.document().undoStack()->undo();
  window.document().undoStack()->undo();
}

void ScreenshotsTest::keepPlan(MainWindow& window) {
  window.findChild<QAction*>("actionPlanRig")->trigger();
  window.findChild<QAction*>("actionShowMap")->setChecked(true);
  window.findChild<QAction*>("actionFindPlace")->trigger();
  auto* list = window.findChild<QComboBox*>("planCamera");
  QVERIFY(QTest::qWaitFor([&] { return list->count() == 1; }, kPatienceMs));
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("calibration-plan"));
  window.findChild<QCheckBox*>("mapVolume")->click();
  window.findChild<QAction*>("actionLookFree")->trigger();
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("calibration-plan-volume"));
  window.findChild<QCheckBox*>("mapVolume")->click();
  window.findChild<QAction*>("actionLookFromAbove")->trigger();
  window.findChild<QAction*>("actionShowMap")->setChecked(false);
  window.findChild<QPushButton*>("planRemove")->click();
  window.findChild<QAction*>("actionCalibrateByHand")->setChecked(false);
}

void ScreenshotsTest::keepPeople(MainWindow& window) {
  QSignalSpy opened(&window, &MainWindow::projectOpened);
  window.openProject(DEWPOINT_SOURCE_DIR "/docs/examples/people_office.toml");
  QVERIFY(opened.wait(kPatienceMs));
  constexpr qint64 kMeeting = 118; // two have met in the middle
  QVERIFY(QTest::qWaitFor([&] { return window.shown() && window.shown()->frame >= kMeeting; },
                          kPatienceMs));
  window.findChild<QAction*>("actionPlay")->trigger();
  window.selection().wantMoment(kMeeting);
  window.findChild<QAction*>("actionLookFree")->trigger();
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("people"));
}

void ScreenshotsTest::keepDialog(MainWindow& window, const char* action, const char* dialog) {
  window.findChild<QAction*>(QLatin1String(action))->trigger();
  QTest::qWait(kSettleMs);
  auto* shown = window.findChild<QWidget*>(QLatin1String(dialog));
  QVERIFY2(shown != nullptr, dialog);
  keep(shown->grab().toImage(), QLatin1String(dialog));
  shown->close();
}

void ScreenshotsTest::keepBoxes(MainWindow& window) {
  QSignalSpy opened(&window, &MainWindow::projectOpened);
  window.openProject(DEWPOINT_SOURCE_DIR "/docs/examples/histogram.toml");
  QVERIFY(opened.wait(kPatienceMs));
  constexpr qint64 kMiddle = 45; // before the bar hides the ball
  QVERIFY(QTest::qWaitFor([&] { return window.shown() && window.shown()->frame >= kMiddle; },
                          kPatienceMs));
  window.findChild<QAction*>("actionPlay")->trigger();
  window.selection().wantMoment(kMiddle);
  window.findChild<QDockWidget*>("targetDock")->raise();
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("boxes"));
  window.findChild<QAction*>("actionExportTrajectory")->trigger();
  window.findChild<QLineEdit*>("boxExportFolder")->setText(QStringLiteral("boxes"));
  keepDialog(window, "actionExportTrajectory", "boxExportDialog");
}

void ScreenshotsTest::everyView() {
  QFETCH(int, theme);
  theme_ = QLatin1String(QTest::currentDataTag());
  QSettings().clear();
  MainWindow window(&openProject);
  window.setTheme(static_cast<Theme>(theme));
  window.resize(1400, 900);
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  keep(window.grab().toImage(), QStringLiteral("start"));
  window.findChild<QAction*>("actionNew")->trigger();
  QTest::qWait(100);
  keep(window.grab().toImage(), QStringLiteral("new-project"));

  QSignalSpy opened(&window, &MainWindow::projectOpened);
  window.openProject({});
  QVERIFY(opened.wait(kPatienceMs));
  QVERIFY(QTest::qWaitFor([&] { return window.shown() && window.shown()->frame >= kFrame; },
                          kPatienceMs));
  window.findChild<QAction*>("actionPlay")->trigger();
  for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
    dock->show();
    dock->raise();
    QTest::qWait(200);
    if (dock->isVisible() && dock->width() > 50 && dock->height() > 30) {
      keep(pictureOf(dock->widget()), dock->objectName());
    }
  }
  window.findChild<QAction*>("actionResetLayout")->trigger();
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("window"));
  window.findChild<QDockWidget*>("colorDock")->raise();
  window.findChild<QAction*>("actionShowMask")->setChecked(true);
  QTest::qWait(kSettleMs);
  keep(window.grab().toImage(), QStringLiteral("window-color"));
  keepCalibration(window);
  keepPlan(window);
  keepDialog(window, "actionShortcuts", "shortcutEditor");
  keepDialog(window, "actionExperiments", "experimentDialog");
  keepDialog(window, "actionPalette", "commandPalette");
  window.findChild<QAction*>("actionExportTrajectory")->trigger();
  window.findChild<QLineEdit*>("exportFile")->setText(QStringLiteral("trajectory.csv"));
  keepDialog(window, "actionExportTrajectory", "exportDialog");
  window.findChild<QAction*>("actionShowMask")->setChecked(false);
  keepPeople(window);
  keepBoxes(window);
}

} // namespace dewpoint::tests

int main(int argc, char** argv) {
  dewpoint::ui::BirdsEyeView::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("dewpoint-test"));
  QApplication::setApplicationName(QStringLiteral("screenshots"));
  dewpoint::tests::ScreenshotsTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "screenshots_test.moc"
