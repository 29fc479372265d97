// SPDX-License-Identifier: GPL-3.0-or-later
// Methods for people in the window, on the simulated office.
#include "core/base/text_file.h"
#include "core/session/people/people_overlay.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/saved_run.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/selection/selection.h"
#include "ui/view3d/birds_eye_view.h"

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTableWidget>
#include <QTimer>
#include <QUndoStack>

#include <filesystem>

namespace dewpoint::tests {

namespace {

constexpr std::int64_t kBothThere = 95; ///< frame of the office by which two people are inside

/// Pixels of about this color, which strokes of an identity have in views.
int pixelsLike(const QImage& picture, const QColor& color) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const QColor pixel = picture.pixelColor(x, y);
      const int apart = std::abs(pixel.red() - color.red()) +
                        std::abs(pixel.green() - color.green()) +
                        std::abs(pixel.blue() - color.blue());
      count += apart < 40 ? 1 : 0;
    }
  }
  return count;
}

QColor colorOf(int identity) {
  const cv::Scalar color = identityColor(identity);
  return {static_cast<int>(color[2]), static_cast<int>(color[1]), static_cast<int>(color[0])};
}

} // namespace

class PeopleTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void theMethodIsChosenAndUndone();
  void learningIsShown();
  void peopleAreSeenInAllViews();
  void theSameBitsAgainAndThePeopleOfThen();
  void peopleAreTakenAwayAndPlacedByKeys();
  void tablesAreWrittenOneAfterTheOther();
  void tablesOfARunThatIsOverAreNotWritten();

private:
  std::int64_t frame() const { return window_->shown() ? window_->shown()->frame : -1; }
  int there() const {
    int count = 0;
    for (const TargetSnapshot& target : window_->shown()->targets) {
      count += target.person() != nullptr ? 1 : 0;
    }
    return count;
  }
  void playTo(std::int64_t frame);
  /// Exports the tables into a folder, as far as choosing it.
  void exportTo(const QString& folder);
  std::string trajectory() {
    const QTemporaryDir folder;
    return test::savesRun(*window_, folder.path().toStdString())
               ? readTextFile(folder.filePath(QStringLiteral("trajectory.csv")).toStdString())
                     .value_or("")
               : std::string();
  }
};

void PeopleTest::init() {
  makeWindow({.size = {1400, 900}, .play = false});
  window_->openProject(std::filesystem::path(DEWPOINT_SOURCE_DIR) / "docs" / "examples" /
                       "people_office.toml");
  QVERIFY(waitFor([&] { return frame() >= 0; }));
}

void PeopleTest::playTo(std::int64_t wanted) {
  action("actionPlay")->trigger();
  QVERIFY(waitFor([&] { return frame() >= wanted; }));
  action("actionPlay")->trigger();
  QVERIFY(waitFor([&] { return window_->shown()->state == PlayState::Paused; }));
}

void PeopleTest::exportTo(const QString& folder) {
  QVERIFY(QDir().mkpath(folder));
  QTimer answer;
  connect(&answer, &QTimer::timeout, this, [&folder] {
    if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
      dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(folder);
      static_cast<QDialog*>(dialog)->accept();
    }
  });
  answer.start(20);
  action("actionExportPeople")->trigger();
}

void PeopleTest::theMethodIsChosenAndUndone() {
  QCOMPARE(window_->document().project().method, std::string("people"));
  QVERIFY(find<QDockWidget>("peopleDock")->isVisibleTo(window_.get()));
  QVERIFY(!find<QDockWidget>("targetDock")->isVisibleTo(window_.get()));
  const auto choose = [&](const char* method) {
    auto* choice = find<QComboBox>("methodChoice");
    const int index = choice->findData(QLatin1String(method));
    QVERIFY2(index >= 0, method);
    choice->setCurrentIndex(index);
    Q_EMIT choice->activated(index);
  };
  choose("mohedano-ms");
  QCOMPARE(window_->document().project().method, std::string("mohedano-ms"));
  QVERIFY(waitFor([&] { return window_->shown()->family.targetSource == TargetSource::Images; }));
  QApplication::processEvents();
  choose("dewpoint");
  QVERIFY(waitFor([&] { return window_->shown()->family.targetSource != TargetSource::Images; }));
  QVERIFY(find<QDockWidget>("targetDock")->isVisibleTo(window_.get()));
  QVERIFY(!find<QDockWidget>("peopleDock")->isVisibleTo(window_.get()));
  QVERIFY(!action("actionPlacePerson")->isEnabled());
  action("actionUndo")->trigger();
  QCOMPARE(window_->document().project().method, std::string("mohedano-ms"));
  action("actionUndo")->trigger();
  QCOMPARE(window_->document().project().method, std::string("people"));
  QVERIFY(waitFor([&] { return window_->shown()->family.targetSource == TargetSource::Images; }));
  QVERIFY(find<QDockWidget>("peopleDock")->isVisibleTo(window_.get()));
  QVERIFY(action("actionPlacePerson")->isEnabled());
}

void PeopleTest::learningIsShown() {
  for (int k = 0; k < 4; ++k) { // 15 frames per second: learning takes 15
    action("actionNextFrame")->trigger();
  }
  QVERIFY(waitFor([&] { return frame() == 4; }));
  const double learned = window_->shown()->peopleCameras.at(0).learningProgress;
  QVERIFY(learned > 0.2 && learned < 0.5);
  auto* progress = find<QProgressBar>("learningProgress");
  QVERIFY(progress->isVisibleTo(window_.get()));
  QCOMPARE(progress->value(), qRound(100.0 * learned));
  QVERIFY(find<QLabel>("statusHeld")->text().contains(QStringLiteral("learning")));
  // The bar at the lower edge of the images.
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(draws(*view));
  QVERIFY(pixelsLike(view->grab().toImage(), QColor("#e6a100")) > 20);
}

void PeopleTest::peopleAreSeenInAllViews() {
  playTo(kBothThere);
  QVERIFY(waitFor([&] { return there() == 2; }));
  auto* table = find<QTableWidget>("peopleTable");
  QVERIFY(waitFor([&] { return table->rowCount() == 2; }));
  QCOMPARE(table->item(0, 0)->text(), QStringLiteral("1"));
  QCOMPARE(table->item(1, 0)->text(), QStringLiteral("2"));
  QVERIFY(!find<QProgressBar>("learningProgress")->isVisibleTo(window_.get()));

  auto* view = find<CameraView>("cameraView0");
  QVERIFY(draws(*view));
  QVERIFY(pixelsLike(view->grab().toImage(), colorOf(1)) > 50); // the outline is 2 pixels wide
  QVERIFY(pixelsLike(view->grab().toImage(), colorOf(2)) > 50);
  auto* birdsEye = find<BirdsEyeView>("birdsEyeView");
  if (birdsEye->hasImage()) {
    QVERIFY(pixelsLike(birdsEye->currentImage(), colorOf(1)) > 50); // badge and level curves
  }

  table->setCurrentCell(1, 0);
  QCOMPARE(window_->selection().target(), 1);
  window_->selection().selectTarget(0);
  QCOMPARE(table->currentRow(), 0);

  action("actionShowVolumes")->setChecked(false);
  QVERIFY(waitFor([&] { return !window_->shown()->targets.at(0).shape; }));
  action("actionShowVolumes")->setChecked(true);
  QVERIFY(waitFor([&] { return bool(window_->shown()->targets.at(0).shape); }));
  action("actionShowMask")->setChecked(true);
  QVERIFY(waitFor([&] { return window_->shown()->masks.size() == 4; }));
  QCOMPARE(window_->shown()->masks.at(0).cols, 320);
}

void PeopleTest::theSameBitsAgainAndThePeopleOfThen() {
  playTo(kBothThere);
  const std::int64_t head = frame();
  const std::string before = trajectory();
  QVERIFY(before.size() > 1000);
  window_->selection().requestFrame(3);
  QVERIFY(waitFor([&] { return frame() == 3; }));
  QCOMPARE(there(), 0);
  QCOMPARE(find<QTableWidget>("peopleTable")->rowCount(), 0);
  window_->selection().requestFrame(head - 10);
  QVERIFY(waitFor([&] { return frame() == head - 10; }));
  QCOMPARE(there(), 2);
  action("actionRerun")->trigger();
  QVERIFY(waitFor([&] {
    return frame() == head && !window_->shown()->rerun &&
           window_->shown()->state == PlayState::Paused;
  }));
  QVERIFY(trajectory() == before);
}

void PeopleTest::peopleAreTakenAwayAndPlacedByKeys() {
  playTo(kBothThere);
  QVERIFY(waitFor([&] { return there() == 2; }));
  const Eigen::Vector3d place = positionOf(window_->shown()->targets.at(0).estimate)->mean;
  find<QTableWidget>("peopleTable")->setCurrentCell(0, 0);
  action("actionRemovePerson")->trigger();
  QVERIFY(waitFor([&] { return there() == 1; }));
  QVERIFY(window_->shown()->targets.at(0).person() == nullptr);

  action("actionPlacePerson")->setChecked(true);
  auto* layer = find<QWidget>("cameraView0Person");
  QVERIFY(layer->isVisible());
  auto* view = find<CameraView>("cameraView0");
  const Camera& camera = window_->shown()->rig->at(0);
  const auto pixel = Projector(camera).project(place);
  QVERIFY(pixel.has_value());
  const ImagePlacement& image = view->placement();
  const QPointF position =
      image.topLeft + image.scale * QPointF(pixel->x() + 0.5, pixel->y() + 0.5);
  QTest::mouseClick(layer, Qt::LeftButton, {}, position.toPoint());
  QVERIFY(waitFor([&] { return there() == 2; }));
  QVERIFY(!action("actionPlacePerson")->isChecked());
  QVERIFY(!layer->isVisible());
  const Eigen::Vector3d found = positionOf(window_->shown()->targets.back().estimate)->mean;
  QVERIFY((found - place).head<2>().norm() < 0.4);
  // Both are steps of the document: taken back, and in its file.
  QCOMPARE(window_->document().project().personCorrections.size(), std::size_t{2});
  action("actionUndo")->trigger();
  QVERIFY(waitFor([&] { return there() == 1 && !window_->shown()->rerun; }));
  action("actionUndo")->trigger();
  QVERIFY(
      waitFor([&] { return there() == 2 && window_->shown()->targets.at(0).person() != nullptr; }));
  QVERIFY(window_->document().project().personCorrections.empty());
  action("actionRedo")->trigger();
  QVERIFY(waitFor([&] { return there() == 1; }));

  action("actionPlacePerson")->setChecked(true); // and away again by Esc
  QTest::keyClick(layer, Qt::Key_Escape);
  QVERIFY(!action("actionPlacePerson")->isChecked());
}

void PeopleTest::tablesAreWrittenOneAfterTheOther() {
  playTo(20);
  const QString one = folder_.filePath(QStringLiteral("one"));
  const QString other = folder_.filePath(QStringLiteral("other"));
  exportTo(one);
  QVERIFY(waitFor([&] {
    return messageText().startsWith(QStringLiteral("Saving")) || messageText().contains(one);
  }));
  exportTo(other); // perhaps while the first ones are still written
  QVERIFY(waitFor([&] { return messageText().contains(other); }));
  for (const QString& folder : {one, other}) {
    QVERIFY(QDir(folder).exists(QStringLiteral("volumes.csv")));
    QVERIFY(QDir(folder).exists(QStringLiteral("trajectory.csv")));
  }
}

void PeopleTest::tablesOfARunThatIsOverAreNotWritten() {
  const QString folder = folder_.filePath(QStringLiteral("late"));
  exportTo(folder);
  action("actionCloseProject")->trigger(); // before it is known whether there are tables already
  QVERIFY(waitFor([&] { return messageText().contains(QStringLiteral("were not saved")); }));
  QVERIFY(QDir(folder).isEmpty());
}

DEWPOINT_WINDOW_TEST(PeopleTest)

} // namespace dewpoint::tests

#include "people_test.moc"
