// SPDX-License-Identifier: GPL-3.0-or-later
// The document without a window: its history, and what a crash leaves.
#include "core/base/text_file.h"
#include "core/project/project.h"
#include "core/project/project_load.h"
#include "core/project/project_save.h"
#include "tests/ui/document/random_edits.h"
#include "tests/ui/wait.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/document/project_saver.h"
#include "ui/document/recovery.h"

#include <QCoreApplication>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUndoStack>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

namespace dewpoint::tests {

namespace {

std::string textOf(const Document& document) {
  return projectText(document.project(), "/recordings");
}

} // namespace

class DocumentTest : public QObject, private test::Waiting {
  Q_OBJECT

private Q_SLOTS:
  void tenThousandEditsUndoneAndRedone();
  void aDragIsOneStepAndItsEndSeparates();
  void aRefusedEditChangesNothing();
  void whatComesFromTheCamerasFollowsThemUntilItIsChanged();
  void correctionsAreStepsAndGoWithTheirTarget();
  void killedAtAnyMomentOnlyWhatCameAfterTheLastCopyIsLost();
  void whatIsSavedOrGivenUpLeavesNothingBehind();
};

void DocumentTest::tenThousandEditsUndoneAndRedone() {
  Document document;
  document.replaceProject(someProject());
  const std::string first = textOf(document);
  Choices choices(4);
  for (int i = 0; i < 10000; ++i) {
    editAnything(document, choices);
  }
  const std::string last = textOf(document);
  QUndoStack& history = *document.undoStack();
  QVERIFY(history.count() > 4000); // most edits are steps of their own
  QVERIFY(first != last);
  std::vector<std::string> passed;
  while (history.canUndo()) {
    if (history.index() % 100 == 0) {
      passed.push_back(textOf(document));
    }
    history.undo();
  }
  QCOMPARE(textOf(document), first);
  while (history.canRedo()) {
    history.redo();
    if (history.index() % 100 == 0 && !passed.empty()) {
      QCOMPARE(textOf(document), passed.back()); // the states in between, too
      passed.pop_back();
    }
  }
  QCOMPARE(textOf(document), last);
}

void DocumentTest::aDragIsOneStepAndItsEndSeparates() {
  Document document;
  document.replaceProject(someProject());
  const auto drag = [&](double hue) {
    QVERIFY(document.edit(
        QStringLiteral("Drag"), [&](Project& project) { project.targets[0].color.hueMin = hue; },
        "hue of target 1"));
  };
  drag(301.0);
  drag(302.0);
  drag(303.0);
  QCOMPARE(document.undoStack()->count(), 1);
  document.endStepMerging();
  drag(310.0);
  QCOMPARE(document.undoStack()->count(), 2);
  document.undoStack()->undo();
  QCOMPARE(document.project().targets[0].color.hueMin, 303.0);
  document.undoStack()->undo();
  QCOMPARE(document.project().targets[0].color.hueMin, 300.0);
  QVERIFY(!document.isUnsaved());
}

void DocumentTest::aRefusedEditChangesNothing() {
  Document document;
  document.replaceProject(someProject());
  const std::string before = textOf(document);
  const auto refused = document.edit(QStringLiteral("Rename camera"), [](Project& project) {
    project.cameras[0].camera.name = project.cameras[1].camera.name;
  });
  QVERIFY(!refused);
  QCOMPARE(refused.error().field, std::string("camera"));
  QCOMPARE(textOf(document), before);
  QCOMPARE(document.undoStack()->count(), 0);
}

void DocumentTest::whatComesFromTheCamerasFollowsThemUntilItIsChanged() {
  Document document;
  document.replaceProject(someProject());
  const auto used = [&](const char* key) { return document.usedParameters().at(key); };
  const double depth = used("start_z"); // both cameras stand at the origin and look along z
  QVERIFY(depth > 1.0);
  QSignalSpy changes(&document, &Document::parameterChanged);
  const auto back = [](Project& project) {
    for (ProjectCamera& camera : project.cameras) {
      camera.camera.cameraFromWorld.translate(Eigen::Vector3d(0.0, 0.0, 3.0));
    }
  };
  QVERIFY(document.edit(QStringLiteral("Move cameras"), back));
  QVERIFY(changes.count() > 0);
  QVERIFY(std::abs(used("start_z") - (depth - 3.0)) < 0.02);
  document.undoStack()->undo();
  QCOMPARE(used("start_z"), depth);
  const double width = used("start_half_x");
  QVERIFY(document.setParameter("start_x", 0.5)); // the default, but now it holds
  QCOMPARE(used("start_x"), 0.5);
  QCOMPARE(used("start_half_x"), width); // the others stay as they were
  QVERIFY(document.project().parameters.isGiven("start_half_x"));
  QVERIFY(document.edit(QStringLiteral("Move cameras"), back));
  QCOMPARE(used("start_z"), depth);
  document.undoStack()->undo();
  document.undoStack()->undo();
  QVERIFY(!document.project().parameters.isGiven("start_x"));
  QVERIFY(document.edit(QStringLiteral("Volume of interest"), [](Project& project) {
    project.volumeOfInterest = WorldBox{{-0.1, -0.1, 1.0}, {0.1, 0.1, 2.0}};
  }));
  QVERIFY(std::abs(used("start_z") - 1.5) < 0.02);
  document.undoStack()->undo();
  QCOMPARE(used("start_z"), depth);
}

void DocumentTest::correctionsAreStepsAndGoWithTheirTarget() {
  Document document;
  Project project = someProject();
  project.targets.push_back({"cap", 0.0, {10.0, 40.0, 0.2, 0.9, 0.1, 0.9}});
  document.replaceProject(project);
  QSignalSpy told(&document, &Document::correctionsChanged);
  PositionCorrection correction;
  correction.frame = 12;
  correction.target = 1;
  correction.covariance *= 1e-4;
  correction.clicks = {{0, {320.0, 200.0}}};
  const auto correct = [&] {
    return document.edit(QStringLiteral("Correct position"),
                         [&](Project& edited) { addCorrection(edited, correction); });
  };
  QVERIFY(correct());
  QCOMPARE(told.count(), 1);
  correction.position.x() = 0.5;
  QVERIFY(correct());
  QCOMPARE(document.project().corrections, std::vector{correction}); // in place of the first
  correction.target = 2;
  QVERIFY(!correct()); // there is no such target
  QCOMPARE(document.undoStack()->count(), 2);
  document.undoStack()->undo();
  QCOMPARE(document.project().corrections.at(0).position.x(), 0.0);
  document.undoStack()->undo();
  QVERIFY(document.project().corrections.empty());
  document.undoStack()->redo();
  document.undoStack()->redo();
  QCOMPARE(told.count(), 6);
  QCOMPARE(document.project().corrections.at(0).position.x(), 0.5);
  QVERIFY(document.edit(QStringLiteral("Remove target"),
                        [](Project& edited) { removeTarget(edited, 0); }));
  QCOMPARE(document.project().corrections.at(0).target, 0); // the cap's number now
  document.undoStack()->undo();
  QCOMPARE(document.project().corrections.at(0).target, 1);
}

/// The seed in the only copy of a folder; 0 if there is none that can be read.
std::uint64_t seedKept(const std::string& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") {
      const auto project = loadProject(entry.path());
      return project ? project->seed : 0;
    }
  }
  return 0;
}

/// The child: changes the seed every few milliseconds until it is killed. It says each seed, and
/// after each copy "kept" and the seed that is in it.
int editForever(const std::string& folder) {
  Document document;
  Recovery recovery(document, folder);
  document.replaceProject(someProject());
  QTimer timer;
  QObject::connect(&timer, &QTimer::timeout, [&document] {
    const std::uint64_t next = document.project().seed + 1;
    (void)document.edit(QStringLiteral("Seed"), [&](Project& project) { project.seed = next; });
    std::printf("%llu\n", static_cast<unsigned long long>(next));
    std::fflush(stdout);
  });
  QObject::connect(&recovery, &Recovery::backupWritten, [&folder] {
    std::printf("kept %llu\n", static_cast<unsigned long long>(seedKept(folder)));
    std::fflush(stdout);
  });
  timer.start(5);
  return QCoreApplication::exec();
}

void DocumentTest::killedAtAnyMomentOnlyWhatCameAfterTheLastCopyIsLost() {
  // Somewhere between a copy and the next, ms after it, at another moment each time.
  constexpr std::array<std::pair<int, int>, 5> kCopiesAndDelays{
      {{1, 350}, {1, 390}, {2, 740}, {2, 780}, {3, 50}}};
  for (const auto& moment : kCopiesAndDelays) {
    const int copies = moment.first;
    const int delay = moment.second;
    QTemporaryDir folder;
    QProcess child;
    child.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("document"), QStringLiteral("--edit-forever"), folder.path()});
    QVERIFY(child.waitForStarted());
    QElapsedTimer sinceKept;
    std::uint64_t kept = 0;
    std::uint64_t last = 0;
    int seen = 0;
    connect(&child, &QProcess::readyReadStandardOutput, &child, [&] {
      while (child.canReadLine()) {
        const QByteArray line = child.readLine().trimmed();
        if (line.startsWith("kept ")) {
          kept = line.mid(5).toULongLong();
          ++seen;
          sinceKept.start();
        } else {
          last = line.toULongLong();
        }
      }
    });
    QVERIFY(waitFor([&] { return seen >= copies && sinceKept.elapsed() > delay; }));
    child.kill();
    QVERIFY(child.waitForFinished());

    const RecoveryFolder recovery(folder.path().toStdString(), &writeTextFile);
    const auto left = recovery.orphanedBackups();
    QCOMPARE(left.size(), std::size_t{1});
    const auto project = RecoveryFolder::readBackup(left.front());
    QVERIFY2(project, project ? "" : errorSentence(project.error()).c_str()); // never a broken one
    QVERIFY(project->seed >= kept);
    qInfo("killed at edit %llu, recovered edit %llu", static_cast<unsigned long long>(last),
          static_cast<unsigned long long>(project->seed));
  }
}

void DocumentTest::whatIsSavedOrGivenUpLeavesNothingBehind() {
  QTemporaryDir folder;
  const std::filesystem::path place = folder.path().toStdString();
  const auto copies = [&] {
    int count = 0;
    if (!std::filesystem::exists(place / "recovery")) {
      return count; // it is made beside the window
    }
    for (const auto& entry : std::filesystem::directory_iterator(place / "recovery")) {
      count += entry.path().extension() == ".toml" ? 1 : 0;
    }
    return count;
  };
  Document document;
  Recovery recovery(document, place / "recovery");
  document.replaceProject(someProject());
  const auto edit = [&](const char* name) {
    return document.edit(QStringLiteral("Name"), [&](Project& project) { project.name = name; });
  };
  QVERIFY(edit("a"));
  QVERIFY(waitFor([&] { return copies() == 1; }));
  std::optional<std::size_t> left;
  recovery.findBackups([&](const std::vector<RecoverableWork>& found) { left = found.size(); });
  QVERIFY(waitFor([&] { return left.has_value(); }));
  QCOMPARE(*left, std::size_t{0}); // its own work is not left behind
  ProjectSaver saver(document);
  saver.save(place / "project.toml");
  QVERIFY(waitFor([&] { return !document.isUnsaved(); }));
  QVERIFY(waitFor([&] { return copies() == 0; }));
  QVERIFY(edit("b"));
  QVERIFY(waitFor([&] { return copies() == 1; }));
  recovery.removeBackup();
  QVERIFY(waitFor([&] { return copies() == 0; }));
}

namespace {

int runDocumentTest(int argc, char** argv, const QString& /*name*/) {
  QCoreApplication application(argc, argv);
  if (argc == 3 && QByteArrayView(argv[1]) == "--edit-forever") {
    return editForever(argv[2]);
  }
  DocumentTest test;
  return QTest::qExec(&test, argc, argv);
}

} // namespace

DEWPOINT_NAMED_TEST(DocumentTest, &runDocumentTest)

} // namespace dewpoint::tests

#include "document_test.moc"
