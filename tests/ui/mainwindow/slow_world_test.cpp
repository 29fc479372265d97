// SPDX-License-Identifier: GPL-3.0-or-later
// A disk that does not answer and a stream that hangs: the window opens, edits and closes all the
// same. A window that waits for one of its threads never gets to the end of these tests.
#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "core/session/run/background_images.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/gate.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/document/document.h"
#include "ui/document/project_saver.h"
#include "ui/jobs/job_thread.h"
#include "ui/panels/background_image_taker.h"
#include "ui/preferences/preferences.h"
#include "ui/start/new_project_page.h"
#include "ui/start/recent_projects.h"

#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QUndoStack>
#include <opencv2/core.hpp>

#include <atomic>
#include <chrono>
#include <fcntl.h>
#include <functional>
#include <memory>
#include <string>
#include <sys/stat.h>
#include <unistd.h>

namespace dewpoint::tests {

using test::Gate;

namespace {

constexpr int kFramesBeforeItHangs = 5;

/// A recording whose images stop coming, and whose reader does not return until the gate opens.
class HangingSource : public FrameSetSource {
public:
  HangingSource(std::unique_ptr<FrameSetSource> images, std::shared_ptr<Gate> gate)
      : images_(std::move(images)), gate_(std::move(gate)) {}

  std::optional<std::int64_t> frameCount() const override { return images_->frameCount(); }
  double framesPerSecond() const override { return images_->framesPerSecond(); }
  Result<FrameSetPtr> next() override {
    if (++read_ > kFramesBeforeItHangs) {
      gate_->pass();
    }
    return images_->next();
  }
  Status seek(std::int64_t frame) override { return images_->seek(frame); }

private:
  std::unique_ptr<FrameSetSource> images_;
  std::shared_ptr<Gate> gate_;
  int read_ = 0;
};

} // namespace

class SlowWorldTest : public QObject, private test::WindowFixture {
  Q_OBJECT
private Q_SLOTS:
  void init();
  void cleanup();
  void opensEditsAndClosesAllTheSame();
  void closesOnceItIsSaved();
  void whatIsChangedWhileItIsSavedIsStillUnsaved();
  void aDeadStreamDoesNotHoldUpTheNextProject();
  void aBoardThatIsLookedForHoldsNobodyUp();
  void recentProjectsAreOfferedUntilTheDiskAnswers();
  void footageComesInOrderOnceItIsRead();
  void footageThatIsGivenUpIsNotHeard();
  void aRunIsWrittenWhenTheWindowIsGone();
  void aBackgroundImageIsUsedOnceItIsWritten();

private:
  /// A project file of the demo, called so.
  std::filesystem::path demoFile(const char* name) const;
  bool isOpen(const std::string& name) {
    return waitFor([&] { return window_->shown() && window_->document().project().name == name; });
  }
  void trigger(const char* name) { action(name)->trigger(); }
  /// Answers the next question about unsaved changes.
  static void answer(QMessageBox::StandardButton button);
  double particlesIn(const std::filesystem::path& file) const;
  /// A recording whose name does not say what it is, and whose first bytes do not come: whoever
  /// looks at it waits until the file that this returns is closed. -1: nobody looks at it.
  int pipeThatIsRead() const;
  QString pipe() const { return file("pipe"); }

  std::shared_ptr<Gate> disk_;
  std::shared_ptr<Gate> stream_;
  std::shared_ptr<std::atomic<bool>> opens_; ///< projects are opened at once
};

void SlowWorldTest::init() {
  folder_ = QTemporaryDir(); // with nothing of the last test
  disk_ = std::make_shared<Gate>();
  stream_ = std::make_shared<Gate>();
  opens_ = std::make_shared<std::atomic<bool>>(true);
  const auto opener = [stream = stream_, opens = opens_](const SessionRequest& request) {
    if (!*opens) {
      stream->pass(); // a camera that does not answer
    }
    return openProject(request).map([&](SessionInputs inputs) {
      inputs.source = std::make_unique<HangingSource>(std::move(inputs.source), stream);
      return inputs;
    });
  };
  makeWindow({.opener = opener});
  window_->saver().setWriter([disk = disk_](const Project& project, const auto& file) {
    disk->pass();
    return saveProject(project, file);
  });
}

void SlowWorldTest::cleanup() {
  disk_->open();
  stream_->open();
  window_.reset();
  QVERIFY(waitFor([] { return waitForDetachedJobs(std::chrono::milliseconds(0)); }));
}

std::filesystem::path SlowWorldTest::demoFile(const char* name) const {
  auto project = *resolveProject("demo");
  project.name = name;
  const auto made = path((std::string(name) + ".toml").c_str());
  if (!saveProject(project, made)) {
    qFatal("cannot write");
  }
  return made;
}

void SlowWorldTest::answer(QMessageBox::StandardButton button) {
  auto* timer = new QTimer(qApp);
  connect(timer, &QTimer::timeout, qApp, [timer, button] {
    if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      timer->deleteLater();
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    }
  });
  timer->start(20);
}

double SlowWorldTest::particlesIn(const std::filesystem::path& file) const {
  const auto project = loadProject(file);
  return project ? project->parameters.at("particles") : -1.0;
}

void SlowWorldTest::opensEditsAndClosesAllTheSame() {
  const auto one = demoFile("one");
  window_->enableRecovery(path("recovery"), [disk = disk_](const auto& file, const auto& text) {
    disk->pass();
    return writeTextFile(file, text);
  });
  window_->openProject(one);
  QVERIFY(isOpen("one"));
  QVERIFY(waitFor([this] { return stream_->waiting() == 1; })); // it plays, and hangs
  QVERIFY(window_->document().setParameter("particles", 777));
  QVERIFY(waitFor([this] { return disk_->waiting() == 1; })); // the copy of unsaved work
  trigger("actionSave");
  QVERIFY(waitFor([this] { return disk_->waiting() == 2; })); // and the file itself
  QVERIFY(window_->saver().isSaving());
  QVERIFY(window_->document().isUnsaved());
  // Other projects take the place of the one that hangs, and hang as well.
  window_->openProject(demoFile("two"));
  QVERIFY(isOpen("two"));
  QVERIFY(waitFor([this] { return stream_->waiting() == 2; }));
  window_->openProject(demoFile("three"));
  QVERIFY(isOpen("three"));
  QVERIFY(window_->document().setParameter("particles", 555));
  answer(QMessageBox::Discard);
  QVERIFY(window_->close());
  window_.reset();
  // Until here, nothing has moved.
  QVERIFY(disk_->waiting() >= 1);
  QVERIFY(stream_->waiting() >= 2);
  disk_->open();
  QVERIFY(waitFor([&] { return particlesIn(one) == 777.0; })); // what was begun is written
}

void SlowWorldTest::closesOnceItIsSaved() {
  const auto one = demoFile("one");
  window_->openProject(one);
  QVERIFY(isOpen("one"));
  QVERIFY(window_->document().setParameter("particles", 777));
  answer(QMessageBox::Save);
  QVERIFY(!window_->close());
  QVERIFY(waitFor([this] { return disk_->waiting() == 1; }));
  QVERIFY(window_->isVisible());
  disk_->open();
  QVERIFY(waitFor([this] { return !window_->isVisible(); }));
  QCOMPARE(particlesIn(one), 777.0);
}

void SlowWorldTest::whatIsChangedWhileItIsSavedIsStillUnsaved() {
  const auto one = demoFile("one");
  window_->openProject(one);
  QVERIFY(isOpen("one"));
  Document& document = window_->document();
  QVERIFY(document.setParameter("particles", 777));
  trigger("actionSave");
  document.endStepMerging();
  QVERIFY(document.setParameter("particles", 888));
  disk_->open();
  QVERIFY(waitFor([this] { return !window_->saver().isSaving(); }));
  QCOMPARE(particlesIn(one), 777.0);
  QVERIFY(document.isUnsaved());
  trigger("actionUndo");
  trigger("actionUndo"); // what was opened, which is not what is in the file now
  QVERIFY(document.isUnsaved());
  trigger("actionSave");
  QVERIFY(waitFor([&] { return !document.isUnsaved(); }));
}

void SlowWorldTest::aDeadStreamDoesNotHoldUpTheNextProject() {
  *opens_ = false;
  window_->openProject(demoFile("one"));
  QVERIFY(waitFor([this] { return stream_->waiting() == 1; }));
  *opens_ = true;
  window_->openProject(demoFile("two"));
  QVERIFY(isOpen("two"));
  trigger("actionPlay"); // it pauses: what plays always has jobs
  stream_->open();       // the camera answers at last, and nobody wants it any more
  QVERIFY(jobsEnd());
  QCOMPARE(window_->document().project().name, std::string("two"));
}

// In an image of 12 megapixels full of noise the search takes long.
void SlowWorldTest::aBoardThatIsLookedForHoldsNobodyUp() {
  Project project;
  project.cameras.resize(1);
  project.cameras[0].camera.intrinsics = {4000, 3000, 4000.0, 4000.0, 1999.5, 1499.5};
  Document document;
  document.replaceProject(project);
  const auto opener = [](const SessionRequest&) -> Result<SessionInputs> {
    return failure(ErrorCode::FileMissing, "", "", "");
  };
  auto calibrator = std::make_unique<BoardCalibrator>(document, opener);
  cv::Mat noise(3000, 4000, CV_8UC3);
  cv::theRNG().state = 16;
  cv::randu(noise, 0, 256);
  FrameSet set;
  set.frames = {std::make_shared<const Frame>(Frame{0, timeStamp(0.0), noise})};
  TrackSnapshot snapshot; // of live cameras: their frames are not counted
  snapshot.frame = 0;
  snapshot.frames = std::make_shared<const FrameSet>(std::move(set));
  calibrator->startGuidance();
  calibrator->setSnapshot(std::make_shared<const TrackSnapshot>(std::move(snapshot)));
  QVERIFY(calibrator->isGuiding());
  calibrator.reset();
  // What was shown is looked at to the end, by a thread that nobody waits for, and wakes nobody.
  QVERIFY(!waitForDetachedJobs(std::chrono::milliseconds(0)));
  QVERIFY(waitFor([] { return waitForDetachedJobs(std::chrono::milliseconds(0)); }));
}

void SlowWorldTest::recentProjectsAreOfferedUntilTheDiskAnswers() {
  const QString one = QString::fromStdString(demoFile("one").string());
  Preferences().addRecentProject(QString::fromStdString(path("gone.toml").string()));
  Preferences().addRecentProject(one);
  window_->findChild<RecentProjects*>()->setExistsCheck([disk = disk_](const QString& file) {
    disk->pass();
    return QFile::exists(file);
  });
  trigger("actionNew");
  find<QPushButton>("newCancel")->click(); // to the start page
  auto* list = find<QListWidget>("startRecent");
  QCOMPARE(list->count(), 2);
  auto* menu = find<QMenu>("menuRecent");
  Q_EMIT menu->aboutToShow();
  QCOMPARE(menu->actions().size(), 4); // with the line, and what forgets them
  QVERIFY(waitFor([this] { return disk_->waiting() == 1; }));
  window_->openProject(one.toStdString());
  QVERIFY(isOpen("one"));
  QCOMPARE(disk_->waiting(), 1); // however often it is asked for
  QCOMPARE(list->count(), 2);
  disk_->open();
  const auto canBeOpened = [list](int row) {
    return list->item(row)->flags().testFlag(Qt::ItemIsEnabled);
  };
  QVERIFY(waitFor([&] { return list->count() == 2 && !canBeOpened(1); })); // gone, and gray
  QCOMPARE(list->item(0)->toolTip(), one);
  QVERIFY(canBeOpened(0));
  Q_EMIT menu->aboutToShow();
  QCOMPARE(menu->actions().size(), 3);
}

int SlowWorldTest::pipeThatIsRead() const {
  int writer = -1;
  const std::string name = pipe().toStdString();
  const bool read = waitFor([&] {
    writer = ::open(name.c_str(), O_WRONLY | O_NONBLOCK); // only once somebody reads
    return writer >= 0;
  });
  return read ? writer : -1;
}

void SlowWorldTest::footageComesInOrderOnceItIsRead() {
  QCOMPARE(::mkfifo(pipe().toStdString().c_str(), 0600), 0);
  const QString address = QStringLiteral("rtsp://camera.example/1");
  auto* page = window_->findChild<NewProjectPage*>();
  auto* rows = find<QTableWidget>("newCameras");
  auto* create = find<QPushButton>("newCreate");
  trigger("actionNew");
  page->addFiles({pipe()});
  page->addFiles({address});
  const int writer = pipeThatIsRead();
  QVERIFY(writer >= 0);
  QCOMPARE(rows->rowCount(), 0);
  QVERIFY(!create->isEnabled());
  QCOMPARE(::write(writer, "\x1A\x45\xDF\xA3", 4), ssize_t{4}); // as Matroska files begin
  ::close(writer);
  QVERIFY(waitFor([&] { return create->isEnabled(); }));
  QCOMPARE(rows->rowCount(), 2);
  QCOMPARE(rows->item(0, 1)->text(), pipe());
  QCOMPARE(rows->item(1, 1)->text(), address);
}

void SlowWorldTest::footageThatIsGivenUpIsNotHeard() {
  QCOMPARE(::mkfifo(pipe().toStdString().c_str(), 0600), 0);
  const QString address = QStringLiteral("rtsp://camera.example/1");
  auto* page = window_->findChild<NewProjectPage*>();
  auto* rows = find<QTableWidget>("newCameras");
  trigger("actionNew");
  page->addFiles({pipe()});
  const int writer = pipeThatIsRead();
  QVERIFY(writer >= 0);
  find<QPushButton>("newCancel")->click();
  trigger("actionNew");
  page->addFiles({address});
  QVERIFY(waitFor([&] { return rows->rowCount() == 1; }));
  QVERIFY(find<QPushButton>("newCreate")->isEnabled());
  ::close(writer);
  QVERIFY(jobsEnd());
  QCOMPARE(rows->rowCount(), 1);
  QCOMPARE(rows->item(0, 1)->text(), address);
  QVERIFY(!find<QLabel>("messageText")->isVisible());
}

void SlowWorldTest::aRunIsWrittenWhenTheWindowIsGone() {
  window_->openProject(demoFile("one"));
  QVERIFY(isOpen("one"));
  window_->saveRun(path("first"), [disk = disk_](bool) { disk->pass(); });
  window_->saveRun(path("second"));
  QVERIFY(waitFor([this] { return disk_->waiting() == 1; }));
  window_.reset();
  QVERIFY(std::filesystem::exists(path("first") / "run.json"));
  QVERIFY(!std::filesystem::exists(path("second")));
  disk_->open();
  QVERIFY(waitFor([this] { return std::filesystem::exists(path("second") / "run.json"); }));
}

void SlowWorldTest::aBackgroundImageIsUsedOnceItIsWritten() {
  QVERIFY(recordDesk(folder_.path().toStdString()));
  window_->openProject(path("desk.toml"));
  auto* take = find<QPushButton>("cameraBackgroundImageTake");
  auto* field = find<QLineEdit>("cameraBackgroundImage");
  QVERIFY(waitFor([&] { return take->isEnabled(); }));
  window_->findChild<BackgroundImageTaker*>()->setWriter([disk = disk_](const auto&... order) {
    disk->pass();
    return saveBackgroundImage(order...);
  });
  take->click();
  QVERIFY(waitFor([this] { return disk_->waiting() == 1; }));
  Document& document = window_->document();
  QVERIFY(document.setParameter("particles", 777)); // nobody waits
  QVERIFY(field->text().isEmpty());
  disk_->open();
  QVERIFY(waitFor([&] { return !field->text().isEmpty(); }));
  QVERIFY(QFile::exists(field->text()));
  document.undoStack()->undo(); // a step of its own
  QVERIFY(document.project().cameras[0].backgroundImageFile.empty());
  QCOMPARE(document.project().parameters.at("particles"), 777.0);
}

DEWPOINT_WINDOW_TEST(SlowWorldTest)

} // namespace dewpoint::tests

#include "slow_world_test.moc"
