// SPDX-License-Identifier: GPL-3.0-or-later
// A camera chosen in any place of the window is chosen in all of them; and the lists of cameras and
// targets, which all places share.
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/cameraview/image_pick_tool.h"
#include "ui/document/camera_list_model.h"
#include "ui/document/target_list_model.h"
#include "ui/people/add_person_tool.h"
#include "ui/selection/selection.h"
#include "ui/view3d/birds_eye_view.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSignalSpy>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace dewpoint::tests {

class CameraSelectionTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init() { openCalibration(); }
  void cleanup() { window_.reset(); }
  void aCameraChosenAnywhereIsChosenEverywhere();
  void aPlannedCameraStandsInItsPlace();
  void anotherProjectBeginsWithItsFirstCamera();
  void aNameThatChangesLeavesTheChoice();
  void targetsComeAndGoInTheirList();
  void thePaletteChoosesThem();
  void imagesAreCalledLikeTheirCameras();

private:
  QListView& list() { return *find<QListView>("cameraList"); }
  void chooseInImage(int k);
  void chooseInSpace(int k);
  /// Empty when all places show this camera as chosen; else the first that does not.
  QString placeWithout(int k);
};

void CameraSelectionTest::chooseInImage(int k) {
  auto* pick = find<ImagePickOverlay>(QStringLiteral("cameraView%1Pick").arg(k));
  QTest::mouseClick(pick, Qt::LeftButton, {}, pick->rect().center());
}

void CameraSelectionTest::chooseInSpace(int k) {
  auto* view = find<BirdsEyeView>("birdsEyeView");
  view->lookFromAbove();
  QVERIFY(waitFor([view] { return view->isDrawn(); }));
  const Eigen::Vector2d at =
      view->scene().projectToImage(camera(k).center()) / view->devicePixelRatioF();
  QTest::mouseClick(view, Qt::LeftButton, {},
                    QPointF(view->width() / 2.0 + at.x(), view->height() / 2.0 - at.y()).toPoint());
}

QString CameraSelectionTest::placeWithout(int k) {
  if (window_->selection().camera() != k) {
    return QStringLiteral("selection");
  }
  if (list().currentIndex().row() != k ||
      find<QLineEdit>("cameraName")->text() != list().currentIndex().data().toString()) {
    return QStringLiteral("panel of the cameras");
  }
  return find<QComboBox>("handCamera")->currentIndex() == k ? QString()
                                                            : QStringLiteral("calibration by hand");
}

void CameraSelectionTest::aCameraChosenAnywhereIsChosenEverywhere() {
  const std::vector<std::pair<const char*, std::function<void(int)>>> places{
      {"selection", [this](int k) { window_->selection().selectCamera(k); }},
      {"panel of the cameras",
       [this](int k) { list().setCurrentIndex(list().model()->index(k, 0)); }},
      {"calibration by hand", [this](int k) { find<QComboBox>("handCamera")->activated(k); }},
      {"grid over an image",
       [this](int k) {
         click(k, {20.0, 20.0});
       }},
      {"image", [this](int k) { chooseInImage(k); }},
      {"bird's-eye view", [this](int k) { chooseInSpace(k); }}};
  for (const auto& [place, choose] : places) {
    if (!find<BirdsEyeView>("birdsEyeView")->hasImage() && place == places.back().first) {
      QSKIP("no OpenGL");
    }
    for (const int k : {1, 0}) {
      choose(k);
      QVERIFY2(placeWithout(k).isEmpty(),
               qPrintable(QStringLiteral("chosen in %1, but not in %2")
                              .arg(QLatin1String(place), placeWithout(k))));
    }
  }
  QCOMPARE(history().count(), 0);
}

void CameraSelectionTest::aPlannedCameraStandsInItsPlace() {
  action("actionPlanCamera")->trigger();
  auto* planned = find<QComboBox>("planCamera");
  QCOMPARE(planned->currentIndex(), 0);
  QCOMPARE(window_->selection().plannedCamera(), 0);
  QVERIFY2(placeWithout(0).isEmpty(), qPrintable(placeWithout(0))); // the project's stays
  window_->selection().selectCamera(1);
  QCOMPARE(planned->currentIndex(), -1);
  planned->activated(0);
  QCOMPARE(window_->selection().plannedCamera(), 0);
  find<QPushButton>("planRemove")->click();
  QCOMPARE(window_->selection().plannedCamera(), -1);
}

void CameraSelectionTest::anotherProjectBeginsWithItsFirstCamera() {
  window_->selection().selectCamera(1);
  open();
  QVERIFY2(placeWithout(0).isEmpty(), qPrintable(placeWithout(0)));
}

void CameraSelectionTest::aNameThatChangesLeavesTheChoice() {
  list().setCurrentIndex(list().model()->index(1, 0));
  const QSignalSpy reset(list().model(), &QAbstractItemModel::modelReset);
  QVERIFY(window_->document().edit(QStringLiteral("name"), [](Project& project) {
    project.cameras[1].camera.name = "by the door";
  }));
  QCOMPARE(list().model()->index(1, 0).data().toString(), QStringLiteral("by the door"));
  QCOMPARE(find<QComboBox>("handCamera")->currentText(), QStringLiteral("by the door"));
  QVERIFY2(placeWithout(1).isEmpty(), qPrintable(placeWithout(1)));
  QCOMPARE(reset.count(), 0);
  QVERIFY(find<QComboBox>("handCamera")->model() == list().model()); // one list
}

void CameraSelectionTest::targetsComeAndGoInTheirList() {
  Document document;
  const TargetListModel targets(document);
  const CameraListModel cameras(document);
  document.replaceProject(project());
  QCOMPARE(targets.rowCount(), static_cast<int>(project().targets.size()));
  QCOMPARE(cameras.rowCount(), static_cast<int>(project().cameras.size()));
  const int before = targets.rowCount();
  QVERIFY(document.edit(QStringLiteral("add"), [](Project& project) {
    project.targets.push_back(project.targets.front());
    project.targets.back().name = "other";
  }));
  QCOMPARE(targets.rowCount(), before + 1);
  QCOMPARE(targets.index(before).data().toString(), QStringLiteral("other"));
  QVERIFY(!targets.index(before).data(Qt::DecorationRole).isNull());
  document.undoStack()->undo();
  QCOMPARE(targets.rowCount(), before);
  Project nameless = project();
  nameless.cameras[1].camera.name.clear();
  document.replaceProject(nameless);
  QCOMPARE(cameras.index(1).data().toString(), QStringLiteral("camera 2"));
}

void CameraSelectionTest::thePaletteChoosesThem() {
  const auto run = [this](const QString& name) {
    action("actionPalette")->trigger();
    auto* search = find<QLineEdit>("paletteSearch");
    search->setText(name);
    QTest::keyClick(search, Qt::Key_Return);
  };
  run(QStringLiteral("cameras ") + list().model()->index(1, 0).data().toString());
  QVERIFY2(placeWithout(1).isEmpty(), qPrintable(placeWithout(1)));
  QVERIFY(window_->document().edit(QStringLiteral("add"), [](Project& project) {
    project.targets.push_back(project.targets.front());
    project.targets.back().name = "other";
  }));
  run(QStringLiteral("targets other"));
  QCOMPARE(window_->selection().target(), static_cast<int>(project().targets.size()) - 1);
  QCOMPARE(find<QLineEdit>("targetName")->text(), QStringLiteral("other"));
}

void CameraSelectionTest::imagesAreCalledLikeTheirCameras() {
  Project nameless = project();
  nameless.cameras[0].camera.name = "left";
  nameless.cameras[1].camera.name.clear();
  Document document;
  const CameraListModel cameras(document);
  document.replaceProject(nameless);
  ImagePickTool pick(cameras);
  AddPersonTool person(find<BirdsEyeView>("birdsEyeView"), cameras, nullptr);
  CameraView left(0);
  CameraView right(1);
  const auto isCalled = [](const CameraView& view, const QString& name) {
    const auto layers = view.findChildren<ImagePickOverlay*>();
    return layers.size() == 2 && std::ranges::all_of(layers, [&](const ImagePickOverlay* layer) {
             return layer->accessibleName().startsWith(name);
           });
  };
  for (CameraView* view : {&left, &right}) {
    pick.attach(view == &left ? 0 : 1, view);
    person.attachView(view == &left ? 0 : 1, view);
  }
  QVERIFY(isCalled(left, QStringLiteral("Image of left: ")));
  QVERIFY(isCalled(right, QStringLiteral("Image of camera 2: ")));
  QVERIFY(document.edit(QStringLiteral("name"),
                        [](Project& project) { project.cameras[1].camera.name = "by the door"; }));
  QVERIFY(isCalled(right, QStringLiteral("Image of by the door: ")));
}

DEWPOINT_WINDOW_TEST(CameraSelectionTest)

} // namespace dewpoint::tests

#include "camera_selection_test.moc"
