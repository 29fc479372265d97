// SPDX-License-Identifier: GPL-3.0-or-later
// Background images, taken for a camera in the window.
#include "core/project/project.h"
#include "core/session/run/background_images.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/gate.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/panels/background_image_taker.h"
#include "ui/panels/camera_panel.h"

#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QUndoStack>

#include <filesystem>
#include <memory>

namespace dewpoint::tests {

class BackgroundImageTakerTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void theBackgroundImageIsAStepThatCanBeUndone();
  void aPictureThatCannotBeWrittenIsSaid();
  void aPictureOfAnotherProjectIsNotUsed();
  void whatWasChosenMeanwhileStays();

private:
  /// Takes the image shown, which is not written before the gate opens.
  void takeAtTheGate();
  const std::string& backgroundImage() const {
    return window_->document().project().cameras[1].backgroundImageFile;
  }
  QPushButton* take() const { return find<QPushButton>("cameraBackgroundImageTake"); }
  QLineEdit* field() const { return find<QLineEdit>("cameraBackgroundImage"); }
  CameraPanel* panel() const { return window_->findChild<CameraPanel*>(); }

  std::shared_ptr<test::Gate> gate_;
};

void BackgroundImageTakerTest::init() {
  gate_ = std::make_shared<test::Gate>();
  folder_ = QTemporaryDir(); // with nothing of the last test
  makeWindow();
  QVERIFY(recordDesk(folder_.path().toStdString()));
  window_->openProject(path("desk.toml"));
  QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame >= 0; }));
  auto* list = find<QListView>("cameraList");
  list->setCurrentIndex(list->model()->index(1, 0));
  QVERIFY(waitFor([this] { return take()->isEnabled(); }));
}

void BackgroundImageTakerTest::cleanup() {
  gate_->open();
  window_.reset();
}

void BackgroundImageTakerTest::takeAtTheGate() {
  panel()->backgroundImageTaker().setWriter([gate = gate_](const auto&... order) {
    gate->pass();
    return saveBackgroundImage(order...);
  });
  take()->click();
  QVERIFY(waitFor([this] { return gate_->waiting() == 1; }));
  QVERIFY(!take()->isEnabled());
}

void BackgroundImageTakerTest::theBackgroundImageIsAStepThatCanBeUndone() {
  Document& document = window_->document();
  QVERIFY(window_->shown()->backgroundImages[1].empty());
  take()->click();
  QVERIFY(waitFor([this] { return !backgroundImage().empty(); }));
  const std::string kept = backgroundImage();
  QCOMPARE(document.undoStack()->count(), 1);
  QVERIFY(std::filesystem::exists(kept));
  QVERIFY(std::filesystem::path(kept).parent_path() == folder_.path().toStdString());
  QCOMPARE(field()->text(), QString::fromStdString(kept));
  QVERIFY(waitFor([&] {
    return window_->shown() && window_->shown()->frames &&
           window_->shown()->backgroundImages.size() == 2 &&
           !window_->shown()->backgroundImages[1].empty();
  }));
  QVERIFY(window_->shown()->backgroundImages[0].empty());
  QCOMPARE(window_->shown()->backgroundImages[1].cols,
           window_->shown()->frames->frames[1]->image.cols);

  document.undoStack()->undo();
  QVERIFY(backgroundImage().empty());
  QVERIFY(field()->text().isEmpty());
  QVERIFY(std::filesystem::exists(kept)); // it can be redone
  QVERIFY(waitFor([&] { return window_->shown() && window_->shown()->frames; }));

  field()->setText(file("gone.png"));
  QTest::keyClick(field(), Qt::Key_Return);
  QVERIFY(waitFor(
      [this] { return find<QLabel>("messageText")->text().contains(QStringLiteral("gone.png")); }));
  QVERIFY(find<QLabel>("messageText")->text().contains(QStringLiteral("right")));
}

void BackgroundImageTakerTest::aPictureThatCannotBeWrittenIsSaid() {
  panel()->backgroundImageTaker().setWriter([](const auto&...) -> Result<std::filesystem::path> {
    return failure(ErrorCode::FileUnwritable, "desk-empty-right.png", "", "the disk is full");
  });
  take()->click();
  QVERIFY(
      waitFor([this] { return messageText().contains(QStringLiteral("desk-empty-right.png")); }));
  QVERIFY(backgroundImage().empty());
  QCOMPARE(window_->document().undoStack()->count(), 0);
  QVERIFY(take()->isEnabled());
}

void BackgroundImageTakerTest::aPictureOfAnotherProjectIsNotUsed() {
  takeAtTheGate();
  Project other = window_->document().project();
  other.name = "other";
  window_->document().replaceProject(other);
  QVERIFY(take()->isEnabled()); // what hangs is not the other one's
  gate_->open();
  QVERIFY(jobsEnd());
  QCOMPARE(QDir(folder_.path()).entryList({QStringLiteral("*-empty-right.png")}).size(), 1);
  QVERIFY(backgroundImage().empty());
  QCOMPARE(window_->document().undoStack()->count(), 0);
}

void BackgroundImageTakerTest::whatWasChosenMeanwhileStays() {
  takeAtTheGate();
  const std::string chosen = file("chosen.png").toStdString();
  QVERIFY(window_->document().edit(QStringLiteral("Choose"), [&](Project& project) {
    project.cameras[1].backgroundImageFile = chosen;
  }));
  gate_->open();
  QVERIFY(waitFor([&] { return messageText().contains(QStringLiteral("-empty-right.png")); }));
  QCOMPARE(backgroundImage(), chosen);
  QCOMPARE(window_->document().undoStack()->count(), 1);
  QVERIFY(take()->isEnabled());
}

DEWPOINT_WINDOW_TEST(BackgroundImageTakerTest)

} // namespace dewpoint::tests

#include "background_image_taker_test.moc"
