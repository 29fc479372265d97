// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the empty room, given to a camera in the window.
#include "core/project/project_save.h"
#include "core/session/run/snapshot.h"
#include "core/setup/new_project.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "ui/document/document.h"

#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QUndoStack>

#include <filesystem>

namespace dewpoint::tests {

class EmptyRoomTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void theEmptyRoomIsAStepThatCanBeUndone();
};

void EmptyRoomTest::theEmptyRoomIsAStepThatCanBeUndone() {
  QVERIFY(recordDemo(folder_.path().toStdString()));
  NewProject wanted;
  wanted.cameras = {{"left", SourceKind::Video, file("left.mkv").toStdString()},
                    {"right", SourceKind::Video, file("right.mkv").toStdString()}};
  wanted.calibration = file("calibration.toml").toStdString();
  const auto made = makeProject(wanted);
  QVERIFY(made);
  QVERIFY(saveProject(made->project, file("desk.toml").toStdString()));
  window_->openProject(file("desk.toml").toStdString());
  QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame >= 0; }));
  Document& document = window_->document();
  auto* list = find<QListView>("cameraList");
  list->setCurrentIndex(list->model()->index(1, 0));
  auto* take = find<QPushButton>("cameraEmptyRoomTake");
  auto* field = find<QLineEdit>("cameraEmptyRoom");
  QVERIFY(waitFor([&] { return take->isEnabled(); }));
  QVERIFY(window_->shown()->emptyRooms[1].empty());
  take->click();
  const std::string kept = document.project().cameras[1].emptyRoom;
  QVERIFY(std::filesystem::exists(kept));
  QVERIFY(std::filesystem::path(kept).parent_path() == folder_.path().toStdString());
  QCOMPARE(field->text(), QString::fromStdString(kept));
  QVERIFY(waitFor([&] {
    return window_->shown() && window_->shown()->frames &&
           window_->shown()->emptyRooms.size() == 2 && !window_->shown()->emptyRooms[1].empty();
  }));
  QVERIFY(window_->shown()->emptyRooms[0].empty());
  QCOMPARE(window_->shown()->emptyRooms[1].cols, window_->shown()->frames->frames[1]->image.cols);

  document.undoStack()->undo();
  QVERIFY(document.project().cameras[1].emptyRoom.empty());
  QVERIFY(field->text().isEmpty());
  QVERIFY(std::filesystem::exists(kept)); // it can be redone
  QVERIFY(waitFor([&] { return window_->shown() && window_->shown()->frames; }));

  field->setText(file("gone.png"));
  QTest::keyClick(field, Qt::Key_Return);
  QVERIFY(waitFor(
      [this] { return find<QLabel>("messageText")->text().contains(QStringLiteral("gone.png")); }));
  QVERIFY(find<QLabel>("messageText")->text().contains(QStringLiteral("right")));
}

} // namespace dewpoint::tests

int main(int argc, char** argv) {
  return dewpoint::tests::test::runWindowTest<dewpoint::tests::EmptyRoomTest>(argc, argv,
                                                                              "empty-room");
}

#include "empty_room_test.moc"
