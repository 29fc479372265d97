// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input in the real window: the message bar says one sentence that names file and field, and
// what was open stays open.
#include "core/base/text_file.h"
#include "core/capture/frame_writer.h"
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/widgets/notice_list.h"

#include <QDir>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QUndoStack>

#include <algorithm>
#include <filesystem>

namespace dewpoint::tests {

namespace {

constexpr std::int64_t kVideoFrames = 24;

/// Writes a camera of the scene as a lossless video.
void writeVideo(const SceneRenderer& renderer, int camera, const std::string& file,
                std::int64_t frames) {
  auto writer = FrameWriter::createVideo(file, renderer.scene().framesPerSecond);
  for (std::int64_t frame = 0; writer && frame < frames; ++frame) {
    if (const auto written = writer->write(renderer.render(camera, frame)); !written) {
      qFatal("%s", errorSentence(written.error()).c_str());
    }
  }
  if (!writer || !writer->finish()) {
    qFatal("%s cannot be written", file.c_str());
  }
}

/// The same word twice in a row, as in "camera 'camera 1'".
bool stammers(const QString& text) {
  static const QRegularExpression kTwice(QStringLiteral("\\b(\\p{L}{3,})[ ':(]+\\1\\b"));
  return text.contains(kTwice);
}

} // namespace

class BadInputTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void isRefusedInOneSentence_data();
  void isRefusedInOneSentence();
  void aMissingVideoIsNamed();
  void aTruncatedVideoKeepsWhatWasTracked();
  void videosOfDifferentLengthAreSaid();
  void aVideoOfAnotherSizeIsRefused();
  void aFileThatCannotBeSavedLosesNothing();

private:
  /// One line, no word twice, every one of these in it.
  void expectSentence(const QStringList& words);
  /// A notice of the run with every one of these in it, no word twice.
  void expectNotice(const QStringList& words);
  void openGood(const std::filesystem::path& file);
  void expectRefused(const std::filesystem::path& file, const QStringList& words);
  /// A copy of the good project in which the first `pattern` was replaced.
  std::filesystem::path changed(const QString& pattern, const QString& replacement);
};

void BadInputTest::initTestCase() {
  QVERIFY(folder_.isValid());
  const Scene scene = demoScene();
  const SceneRenderer renderer(scene);
  writeVideo(renderer, 0, path("camera-1.mkv"), kVideoFrames);
  writeVideo(renderer, 1, path("camera-2.mkv"), kVideoFrames);
  writeVideo(renderer, 1, path("short.mkv"), kVideoFrames / 2);
  std::filesystem::copy_file(path("camera-1.mkv"), path("half.mkv"));
  std::filesystem::resize_file(path("half.mkv"), std::filesystem::file_size(path("half.mkv")) / 2);
  Project project = makeSceneProject(scene, "");
  project.cameras[0].source = project.cameras[1].source = SourceKind::Video;
  project.cameras[0].location = path("camera-1.mkv");
  project.cameras[1].location = path("camera-2.mkv");
  QVERIFY(saveProject(project, path("good.toml")));
}

void BadInputTest::init() {
  makeWindow({.play = false});
  openGood(path("good.toml"));
}

void BadInputTest::openGood(const std::filesystem::path& file) {
  open(file);
  QVERIFY(waitFor([this] { return shown().frames != nullptr; }));
}

void BadInputTest::expectSentence(const QStringList& words) {
  // Files are read and written beside the window.
  QVERIFY(waitFor([this] { return window_->findChild<QLabel*>("messageText")->isVisible(); }));
  qInfo("%s", qPrintable(messageText()));
  QVERIFY2(!messageText().contains(QLatin1Char('\n')) && !stammers(messageText()),
           qPrintable(messageText()));
  for (const QString& word : words) {
    QVERIFY2(messageText().contains(word),
             qPrintable(word + QStringLiteral(" in: ") + messageText()));
  }
}

void BadInputTest::expectNotice(const QStringList& words) {
  const QStringList& notices = find<NoticeList>("noticeList")->notices();
  QVERIFY(waitFor([&] { return !notices.isEmpty() && find<QLabel>("noticesText")->isVisible(); }));
  const bool isThere = std::ranges::any_of(notices, [&](const QString& notice) {
    return !stammers(notice) &&
           std::ranges::all_of(words, [&](const QString& word) { return notice.contains(word); });
  });
  QVERIFY2(isThere, qPrintable(notices.join(QLatin1Char('|'))));
}

void BadInputTest::expectRefused(const std::filesystem::path& file, const QStringList& words) {
  QSignalSpy failed(window_.get(), &MainWindow::openFailed);
  window_->openProject(file);
  QVERIFY(failed.wait(kTimeoutMs));
  expectSentence(words);
  QCOMPARE(window_->document().project().file, path("good.toml")); // what was open stays open
  QVERIFY(window_->findChild<QAction*>("actionPlay")->isEnabled());
}

std::filesystem::path BadInputTest::changed(const QString& pattern, const QString& replacement) {
  QString text = QString::fromStdString(*readTextFile(path("good.toml")));
  const QRegularExpression found(pattern, QRegularExpression::MultilineOption);
  const auto match = found.match(text);
  if (!match.hasMatch()) {
    qFatal("the good project has no %s", qPrintable(pattern));
  }
  text.replace(match.capturedStart(), match.capturedLength(), replacement);
  if (!writeTextFile(path("bad.toml"), text.toStdString())) {
    qFatal("bad.toml cannot be written");
  }
  return path("bad.toml");
}

void BadInputTest::isRefusedInOneSentence_data() {
  QTest::addColumn<QString>("pattern");
  QTest::addColumn<QString>("replacement");
  QTest::addColumn<QStringList>("words");
  const auto row = [](const char* name, const char* pattern, const char* replacement,
                      const QStringList& words) {
    QTest::newRow(name) << QString::fromUtf8(pattern) << QString::fromUtf8(replacement) << words;
  };
  const QString file = QStringLiteral("bad.toml");
  row("unknown key", "^seed", "flavor = 1\nseed", {file, "flavor", "unknown key"});
  row("wrong type", "^seed.*$", "seed = \"one\"", {file, "seed", "whole number"});
  row("no cameras", "^\\[\\[camera(.|\\n)*", "", {file, "camera"});
  row("NaN", "^translation.*$", "translation = [nan, 0.0, 0.0]",
      {file, "camera 1.calibration.translation", "finite"});
  row("zero focal length", "^matrix.*$",
      "matrix = [[0.0, 0.0, 9.0], [0.0, 0.0, 9.0], [0.0, 0.0, 1.0]]", {file, "matrix", "focal"});
  row("no rotation", "^rotation.*$", "rotation = [[2, 0, 0], [0, 1, 0], [0, 0, 1]]",
      {file, "rotation", "not a rotation"});
  row("empty color range", "^saturation.*$", "saturation = [0.8, 0.2]",
      {file, "target 1.saturation", "0.8"});
  row("no TOML", "^seed", "[[[", {file, "line"});
}

void BadInputTest::isRefusedInOneSentence() {
  QFETCH(QString, pattern);
  QFETCH(QString, replacement);
  QFETCH(QStringList, words);
  expectRefused(changed(pattern, replacement), words);
}

void BadInputTest::aMissingVideoIsNamed() {
  expectRefused(changed("^video.*$", "video = \"nowhere.mkv\""), {"nowhere.mkv", "'camera 1'"});
}

void BadInputTest::aVideoOfAnotherSizeIsRefused() {
  expectRefused(changed("camera-2.mkv", "camera-1.mkv"),
                {"camera-1.mkv", "'camera 2'", "320 x 240"});
}

void BadInputTest::aTruncatedVideoKeepsWhatWasTracked() {
  openGood(changed("camera-1.mkv", "half.mkv"));
  window_->findChild<QAction*>("actionPlay")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->state == PlayState::Ended; }));
  expectNotice({"half.mkv", "'camera 1'", "ends earlier"});
  QVERIFY(window_->shown()->frame > 3); // a quarter of half of 24 frames, at least, was tracked
}

void BadInputTest::videosOfDifferentLengthAreSaid() {
  openGood(changed("camera-2.mkv", "short.mkv"));
  expectNotice({"short.mkv", "'camera 2'", QString::number(kVideoFrames), "first 12"});
}

void BadInputTest::aFileThatCannotBeSavedLosesNothing() {
  const std::string before = *readTextFile(path("good.toml"));
  Document& document = window_->document();
  QVERIFY(document.setParameter("particles", 300));
  // Renaming onto a folder fails, for root too.
  std::filesystem::rename(path("good.toml"), path("kept.toml"));
  std::filesystem::create_directory(path("good.toml"));
  std::filesystem::create_directory(path("good.toml") / "inside");
  window_->findChild<QAction*>("actionSave")->trigger();
  expectSentence({"good.toml", "cannot be written"});
  QVERIFY(!document.undoStack()->isClean()); // still to be saved
  std::filesystem::remove_all(path("good.toml"));
  std::filesystem::rename(path("kept.toml"), path("good.toml"));
  QCOMPARE(*readTextFile(path("good.toml")), before);
  window_->findChild<QAction*>("actionUndo")->trigger(); // closing asks no question
}

DEWPOINT_WINDOW_TEST(BadInputTest)

} // namespace dewpoint::tests

#include "bad_input_test.moc"
