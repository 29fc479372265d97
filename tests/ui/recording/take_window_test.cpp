// SPDX-License-Identifier: GPL-3.0-or-later
// Live cameras recorded from the real window: the button, what the status bar says, and the take
// that opens as a project.
#include "core/broadcast/transport/file_descriptor.h"
#include "core/capture/gstreamer/encoded_feed.h"
#include "core/project/project_save.h"
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/capture/mjpeg_server.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/broadcast/output_controller.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/recording/take_controller.h"
#include "ui/session/session_controller.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QDialog>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <memory>
#include <netinet/in.h>
#include <optional>
#include <string>
#include <sys/socket.h>

namespace dewpoint::tests {

class TakeWindowTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void cleanup();
  void aTakeOpensAsAProject();
  void closingTheProjectCompletesTheTake();
  void aFolderThatCannotBeMadeIsSaid();
  void recordingsHaveNoButton();
  void numberAndNotesAreThoseOfTheUser();
  void aTakeBeginsBeforeItsStart();
  void aTakeIsComparedWithTheLiveRun();
  void aRemoteCommandNamesTheTake();

private:
  /// The notes in the take.json of a take.
  QString notesOf(const char* take) const;
  TakeController& takes() { return *window_->findChild<TakeController*>(); }
  /// Opens a project of two network cameras.
  void openLive();
  /// Records until each camera has sent so many images.
  bool records(std::int64_t images);

  Scene scene_ = demoScene();
  std::array<cv::Mat, 2> pictures_;
  std::unique_ptr<test::MjpegServer> left_;
  std::unique_ptr<test::MjpegServer> right_;
};

void TakeWindowTest::initTestCase() {
  QVERIFY(folder_.isValid());
  const SceneRenderer renderer(scene_);
  pictures_ = {renderer.render(0, 0), renderer.render(1, 0)};
}

void TakeWindowTest::cleanup() {
  window_.reset(); // before its cameras are gone
  left_.reset();
  right_.reset();
}

void TakeWindowTest::openLive() {
  left_ = std::make_unique<test::MjpegServer>([this](auto&&...) { return pictures_[0]; });
  right_ = std::make_unique<test::MjpegServer>([this](auto&&...) { return pictures_[1]; });
  Project project = makeSceneProject(scene_, "");
  project.cameras[0].source = project.cameras[1].source = SourceKind::Stream;
  project.cameras[0].location = left_->address();
  project.cameras[1].location = right_->address();
  QVERIFY(saveProject(project, path("live.toml")));
  makeWindow({.play = false});
  open(path("live.toml"));
}

bool TakeWindowTest::records(std::int64_t images) {
  QTest::mouseClick(find<QToolButton>("actionRecordButton"), Qt::LeftButton);
  return waitFor([&] {
    const TakeStatus take = takes().status();
    return !take.cameras.empty() && std::ranges::all_of(take.cameras, [&](const auto& camera) {
      return camera.counts.imageCount >= images;
    });
  });
}

void TakeWindowTest::aTakeOpensAsAProject() {
  openLive();
  QVERIFY(records(20));
  auto* label = find<QLabel>("takeLabel");
  QVERIFY(waitFor([&] { return label->isVisible(); }));
  QVERIFY2(label->text().contains(QStringLiteral("take 1")), qPrintable(label->text()));
  QVERIFY(find<QAction>("actionRecord")->isChecked());
  QSignalSpy stopped(&takes(), &TakeController::stopped);
  QTest::mouseClick(find<QToolButton>("actionRecordButton"), Qt::LeftButton);
  QVERIFY(stopped.wait(kTimeoutMs));
  QVERIFY(!label->isVisible());
  QVERIFY(!find<QAction>("actionRecord")->isChecked());
  QVERIFY2(messageText().contains(QStringLiteral("live-takes")), qPrintable(messageText()));
  QTest::mouseClick(find<QPushButton>("messageAnswer0"), Qt::LeftButton);
  QVERIFY(waitFor([&] {
    const auto shown = window_->shown();
    return shown != nullptr && shown->frameCount.value_or(0) >= 15;
  }));
  const Project& take = window_->workbench().document.project();
  QCOMPARE(take.targets.size(), scene_.balls.size());
  QCOMPARE(take.cameras.size(), std::size_t(2));
  // The next take has the next number.
  QVERIFY(QFile::exists(file("live-takes/take-001/take.json")));
}

void TakeWindowTest::closingTheProjectCompletesTheTake() {
  openLive();
  QVERIFY(records(5));
  QSignalSpy stopped(&takes(), &TakeController::stopped);
  action("actionCloseProject")->trigger();
  QVERIFY(stopped.wait(kTimeoutMs));
  const auto take = stopped.first().first().value<TakeStatus>();
  QVERIFY(std::filesystem::exists(take.folder / "project.toml"));
  QVERIFY(!action("actionRecord")->isEnabled());
}

void TakeWindowTest::aFolderThatCannotBeMadeIsSaid() {
  openLive();
  std::filesystem::remove_all(path("live-takes"));
  QFile inTheWay(file("live-takes"));
  QVERIFY(inTheWay.open(QIODevice::WriteOnly));
  QTest::mouseClick(find<QToolButton>("actionRecordButton"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return messageText().contains(QStringLiteral("live-takes")); }));
  QVERIFY(!takes().isRecording());
  QVERIFY(!action("actionRecord")->isChecked());
  QVERIFY(inTheWay.remove());
}

QString TakeWindowTest::notesOf(const char* take) const {
  QFile json(file("live-takes") + QLatin1Char('/') + QLatin1String(take) +
             QStringLiteral("/take.json"));
  return json.open(QIODevice::ReadOnly)
             ? QJsonDocument::fromJson(json.readAll()).object()[QStringLiteral("notes")].toString()
             : QString();
}

void TakeWindowTest::numberAndNotesAreThoseOfTheUser() {
  std::filesystem::remove_all(path("live-takes"));
  openLive();
  const auto writes = [this](const QString& notes, std::optional<int> number) {
    auto* field = find<QPlainTextEdit>("takeNotes");
    auto* spin = find<QSpinBox>("takeNumber");
    QCOMPARE(spin->isEnabled(), number.has_value());
    field->setPlainText(notes);
    spin->setValue(number.value_or(spin->value()));
    find<QDialog>("takeDialog")->accept();
    QVERIFY(waitFor([this] { return window_->findChild<QDialog*>("takeDialog") == nullptr; }));
  };
  action("actionTakeNotes")->trigger(); // before
  writes(QStringLiteral("first try"), 7);
  QVERIFY(waitFor([this] { return action("actionRecord")->isEnabled(); }));
  QVERIFY(records(5));
  QCOMPARE(takes().status().takeNumber, 7);
  QCOMPARE(notesOf("take-007"), QStringLiteral("first try"));
  action("actionTakeNotes")->trigger(); // while
  writes(QStringLiteral("good"), std::nullopt);
  QVERIFY(waitFor([&] { return notesOf("take-007") == QStringLiteral("good"); }));
  QSignalSpy stopped(&takes(), &TakeController::stopped);
  QTest::mouseClick(find<QToolButton>("actionRecordButton"), Qt::LeftButton);
  QVERIFY(stopped.wait(kTimeoutMs));
  QCOMPARE(notesOf("take-007"), QStringLiteral("good"));
  QTest::mouseClick(find<QPushButton>("messageAnswer2"), Qt::LeftButton); // after
  writes(QStringLiteral("the best one"), std::nullopt);
  QVERIFY(waitFor([&] { return notesOf("take-007") == QStringLiteral("the best one"); }));
  // The next number follows, and notes are those of one take.
  QVERIFY(waitFor([this] { return action("actionRecord")->isEnabled(); }));
  QVERIFY(records(5));
  QCOMPARE(takes().status().takeNumber, 8);
  QCOMPARE(notesOf("take-008"), QString());
}

void TakeWindowTest::aTakeBeginsBeforeItsStart() {
  openLive();
  action("actionTakeNotes")->trigger();
  QCOMPARE(find<QSpinBox>("takePreRoll")->value(), 0); // off
  find<QSpinBox>("takePreRoll")->setValue(2);
  find<QDialog>("takeDialog")->accept();
  QCOMPARE(Preferences().preRollSeconds(), 2);
  const auto& feeds = window_->workbench().session.encodedFeeds();
  QVERIFY(waitFor([&] {
    return std::ranges::all_of(feeds,
                               [](const auto& feed) { return feed->preRoll().imageCount >= 20; });
  }));
  QVERIFY(records(5));
  const TakeStatus take = takes().status();
  QVERIFY2(take.preRollSeconds > 0.1 && take.preRollSeconds < 5.0,
           qPrintable(QString::number(take.preRollSeconds)));
  QVERIFY(waitFor([this] {
    const TakeStatus now = takes().status();
    return std::ranges::all_of(now.cameras, [](const auto& camera) {
      return camera.counts.preRollImageCount >= 15 &&
             camera.counts.imageCount > camera.counts.preRollImageCount;
    });
  }));
  QSignalSpy stopped(&takes(), &TakeController::stopped);
  QTest::mouseClick(find<QToolButton>("actionRecordButton"), Qt::LeftButton);
  QVERIFY(stopped.wait(kTimeoutMs));
  QVERIFY2(messageText().contains(QStringLiteral("before you pressed")), qPrintable(messageText()));
}

void TakeWindowTest::aTakeIsComparedWithTheLiveRun() {
  openLive();
  action("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return shown().isTracked; }));
  QVERIFY(records(5));
  action("actionRestart")->trigger();
  QVERIFY(waitFor([this] {
    const Session* session = window_->workbench().session.session();
    return session->liveFrameRecords().size() >= 20;
  }));
  QSignalSpy stopped(&takes(), &TakeController::stopped);
  QTest::mouseClick(find<QToolButton>("actionRecordButton"), Qt::LeftButton);
  QVERIFY(stopped.wait(kTimeoutMs));
  const auto folder = stopped.first().first().value<TakeStatus>().folder;
  QVERIFY(std::filesystem::exists(folder / "live" / "frames.csv"));
  QVERIFY(std::filesystem::exists(folder / "live" / "run.json"));
  open(folder / "project.toml");
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("live run")); }));
  QTest::mouseClick(find<QPushButton>("messageAnswer0"), Qt::LeftButton);
  QVERIFY(waitFor([this] {
    return messageText().contains(QStringLiteral("frames")) &&
           messageText().contains(QStringLiteral("live run"));
  }));
}

void TakeWindowTest::aRemoteCommandNamesTheTake() {
  openLive();
  QVERIFY(window_->workbench().document.edit(QStringLiteral("Set outputs"), [](Project& project) {
    project.output.tcpPort = 0;
    project.output.token = "word-to-know";
  }));
  auto& outputs = *window_->findChild<OutputController*>();
  QSignalSpy sending(&outputs, &OutputController::changed);
  action("actionSendResults")->trigger();
  QVERIFY(outputs.isSending() || sending.wait(kTimeoutMs));
  const std::string place = outputs.outletReports().at(0).address;
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port =
      htons(static_cast<std::uint16_t>(std::stoi(place.substr(place.rfind(':') + 1))));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const broadcast::FileDescriptor program(::socket(AF_INET, SOCK_STREAM, 0));
  QCOMPARE(::connect(program.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address),
           0);
  const auto send = [&](const std::string& line) {
    QCOMPARE(::send(program.number(), line.data(), line.size(), 0),
             static_cast<ssize_t>(line.size()));
  };
  send("{\"command\":\"record\",\"name\":\"jump-3\",\"token\":\"word-to-know\"}\n");
  QVERIFY(waitFor([this] { return takes().isRecording(); }));
  QCOMPARE(takes().status().notes, std::string("jump-3"));
  QSignalSpy stopped(&takes(), &TakeController::stopped);
  send("{\"command\":\"stop-recording\",\"token\":\"word-to-know\"}\n");
  QVERIFY(stopped.count() > 0 || stopped.wait(kTimeoutMs));
  // The next take, which the user starts, has no name.
  QVERIFY(waitFor([this] { return action("actionRecord")->isEnabled(); }));
  QVERIFY(records(1));
  QVERIFY(takes().status().notes.empty());
}

void TakeWindowTest::recordingsHaveNoButton() {
  makeWindow({.play = false});
  openDemo();
  QVERIFY(!action("actionRecord")->isEnabled());
  QVERIFY(!find<QToolBar>("transportBar")->actions().contains(action("actionRecord")));
}

DEWPOINT_WINDOW_TEST(TakeWindowTest)

} // namespace dewpoint::tests

#include "take_window_test.moc"
