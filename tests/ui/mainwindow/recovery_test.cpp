// SPDX-License-Identifier: GPL-3.0-or-later
// Work that a killed window left behind: offered, with its layout; asked for again; thrown away.
#include "core/base/text_file.h"
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/document/project_saver.h"
#include "ui/document/recovery.h"
#include "ui/mainwindow/recovery_offer.h"
#include "ui/widgets/message_bar.h"

#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLockFile>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSysInfo>
#include <QTimer>
#include <QToolButton>

#include <chrono>
#include <filesystem>
#include <memory>

namespace dewpoint::tests {

class RecoveryTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void comesBackWithItsLayout();
  void behindAPageTheLayoutIsThatOfTheViews();
  void theQuestionComesBackAfterOtherMessages();
  void aWindowThatTakesLongToDieIsNotForgotten();
  void theLateQuestionTakesNoOtherWorkAway();
  void thrownAwayItIsGoneButForASlip();
  void whatCannotBeOpenedStays();
  void locksOfTheDeadGo();

private:
  std::filesystem::path place(const char* name) const {
    return place_->filePath(QLatin1String(name)).toStdString();
  }
  bool isOpen(const std::string& name) {
    return waitFor([&] {
      return window_->shown() && window_->document().project().name == name &&
             find<QWidget>("start")->isHidden();
    });
  }
  void answer(const char* button) {
    QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // the former answers
  }
  void closeMessage() { QTest::mouseClick(find<QToolButton>("messageClose"), Qt::LeftButton); }
  /// What offers the work of the window that died looks again every moment.
  RecoveryOffer& lookOften() {
    auto* offer = window_->findChild<RecoveryOffer*>();
    offer->setSearchInterval(std::chrono::milliseconds(50));
    return *offer;
  }
  /// A project file of the demo, called so.
  std::filesystem::path demoFile(const char* name);
  /// A copy as a killed window leaves it.
  void leaveBehind(const char* id, const std::filesystem::path& project);

  std::unique_ptr<QTemporaryDir> place_;
};

void RecoveryTest::init() {
  place_ = std::make_unique<QTemporaryDir>();
  std::filesystem::create_directories(place("left"));
  makeWindow({.play = false});
}

std::filesystem::path RecoveryTest::demoFile(const char* name) {
  auto project = *resolveProject("demo");
  project.name = name;
  const auto file = place((std::string(name) + ".toml").c_str());
  if (!saveProject(project, file)) {
    qFatal("cannot write");
  }
  return file;
}

void RecoveryTest::leaveBehind(const char* id, const std::filesystem::path& project) {
  std::filesystem::copy_file(project, place("left") / (std::string(id) + ".toml"));
}

void RecoveryTest::comesBackWithItsLayout() {
  const auto file = demoFile("half done");
  window_->enableRecovery(place("living"));
  window_->openProject(file);
  QVERIFY(isOpen("half done"));
  find<QDockWidget>("birdsEyeDock")->setFloating(true);
  QVERIFY(window_->document().setParameter("particles", 777));
  const QDir living(QString::fromStdString(place("living").string()));
  QVERIFY(waitFor([&] { return !living.entryList({"*.toml"}).isEmpty(); }));
  // Killed now: what lies on the disk is all there is.
  const QStringList kept = living.entryList({"*.toml", "*.origin"}, QDir::Files);
  QCOMPARE(kept.size(), 2);
  for (const QString& name : kept) {
    QVERIFY(QFile::copy(living.filePath(name),
                        QString::fromStdString((place("left") / name.toStdString()).string())));
  }
  makeAnotherWindow({.play = false});
  window_->enableRecovery(place("left"));
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("half done")); }));
  answer("messageAnswer0");
  QVERIFY(isOpen("half done"));
  QVERIFY(find<QDockWidget>("birdsEyeDock")->isFloating());
  QCOMPARE(window_->document().project().parameters.at("particles"), 777.0);
  QCOMPARE(window_->document().project().file, file); // Save goes where it came from
  QVERIFY(window_->document().isUnsaved());
  // Saved at once, it is not offered again.
  find<QAction>("actionSave")->trigger();
  QVERIFY(waitFor([this] { return !window_->document().isUnsaved(); }));
  const QDir left(QString::fromStdString(place("left").string()));
  QVERIFY(waitFor([&] { return left.entryList({"*.toml"}).isEmpty(); }));
}

void RecoveryTest::behindAPageTheLayoutIsThatOfTheViews() {
  const auto file = demoFile("behind");
  window_->openProject(file);
  QVERIFY(isOpen("behind"));
  find<QAction>("actionNew")->trigger();
  QVERIFY(find<QWidget>("newProjectPage")->isVisible());
  find<QAction>("actionSave")->trigger();
  QVERIFY(waitFor([this] { return !window_->saver().isSaving(); }));
  makeAnotherWindow({.play = false});
  window_->openProject(file);
  QVERIFY(isOpen("behind"));
  QVERIFY(waitFor([this] { return find<QDockWidget>("birdsEyeDock")->isVisible(); }));
}

void RecoveryTest::theQuestionComesBackAfterOtherMessages() {
  leaveBehind("0123", demoFile("half done"));
  window_->enableRecovery(place("left"));
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("half done")); }));
  window_->openProject(demoFile("other"));
  QVERIFY(isOpen("other"));
  find<QAction>("actionSave")->trigger(); // says so
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("other.toml")); }));
  QVERIFY(!messageText().contains(QStringLiteral("half done")));
  window_->findChild<MessageBar*>()->dismiss();
  QVERIFY(messageText().contains(QStringLiteral("half done")));
  window_->findChild<MessageBar*>()->dismiss(); // that is an answer: not now
  QVERIFY(messageText().isEmpty());
  QVERIFY(std::filesystem::exists(place("left") / "0123.toml"));
}

/// The killed window takes its time to be gone: the question comes some looks after the start.
void RecoveryTest::aWindowThatTakesLongToDieIsNotForgotten() {
  leaveBehind("0123", demoFile("half done"));
  QLockFile living(QString::fromStdString((place("left") / "0123.lock").string()));
  QVERIFY(living.tryLock(0));
  window_->enableRecovery(place("left"));
  RecoveryOffer& offer = lookOften();
  QSignalSpy looks(&offer, &RecoveryOffer::searchEnded);
  QVERIFY(waitFor([&] { return looks.count() >= 2; }));
  QVERIFY(messageText().isEmpty());
  living.unlock();
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("half done")); }));
}

void RecoveryTest::theLateQuestionTakesNoOtherWorkAway() {
  leaveBehind("0123", demoFile("half done"));
  QLockFile living(QString::fromStdString((place("left") / "0123.lock").string()));
  QVERIFY(living.tryLock(0));
  window_->enableRecovery(place("left"));
  lookOften();
  QVERIFY(messageText().isEmpty());
  window_->openProject(demoFile("other"));
  QVERIFY(isOpen("other"));
  QVERIFY(window_->document().setParameter("particles", 777));
  living.unlock();
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("half done")); }));
  const auto press = [](QMessageBox::StandardButton button) {
    QTimer::singleShot(200, qApp, [button] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      QTest::mouseClick(box->button(button), Qt::LeftButton);
    });
  };
  press(QMessageBox::Cancel);
  answer("messageAnswer0");
  QCOMPARE(window_->document().project().name, std::string("other"));
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("half done")); })); // still
  press(QMessageBox::Discard);
  answer("messageAnswer0");
  QVERIFY(isOpen("half done"));
}

void RecoveryTest::thrownAwayItIsGoneButForASlip() {
  leaveBehind("0123", demoFile("one"));
  leaveBehind("4567", demoFile("two"));
  window_->enableRecovery(place("left"));
  const auto isAsked = [this] {
    return messageText().contains(QStringLiteral("closed unexpectedly"));
  };
  const auto isThrown = [this] { return messageText().contains(QStringLiteral("were discarded")); };
  QVERIFY(waitFor(isAsked));
  answer("messageAnswer1");
  QVERIFY(waitFor(isThrown));
  closeMessage();
  QVERIFY(waitFor(isAsked)); // there is one more
  answer("messageAnswer1");
  QVERIFY(waitFor(isThrown));
  answer("messageAnswer0"); // no, that was a slip
  QVERIFY(waitFor(isAsked));
  answer("messageAnswer1");
  QVERIFY(waitFor(isThrown));
  closeMessage();
  QVERIFY(messageText().isEmpty());
  QVERIFY(QDir(QString::fromStdString(place("left").string())).entryList({"*.toml"}).isEmpty());
  QVERIFY(find<QWidget>("startPage")->isVisible());
}

void RecoveryTest::whatCannotBeOpenedStays() {
  const auto broken = place("broken.toml");
  QVERIFY(writeTextFile(broken, "format = 2\n[[camera]]\nname = \"a\"\nvideo = \"gone.mkv\"\n"
                                "[camera.calibration]\nsize = [640, 480]\n"
                                "matrix = [[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]]\n"
                                "rotation = [0, 0, 0]\ntranslation = [0, 0, 0]\n"));
  leaveBehind("0123", broken);
  window_->enableRecovery(place("left"));
  QVERIFY(
      waitFor([this] { return messageText().contains(QStringLiteral("closed unexpectedly")); }));
  answer("messageAnswer0");
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("gone.mkv")); }));
  // What is opened next is not taken for it: neither unsaved, nor is the copy thrown away for its.
  window_->openProject(demoFile("other"));
  QVERIFY(isOpen("other"));
  QVERIFY(!window_->document().isUnsaved());
  QVERIFY(window_->document().setParameter("particles", 777));
  const QDir left(QString::fromStdString(place("left").string()));
  QVERIFY(waitFor([&] { return left.entryList({"*.toml"}).size() == 2; }));
  letTimePass(100);
  QVERIFY(left.exists(QStringLiteral("0123.toml")));
}

void RecoveryTest::locksOfTheDeadGo() {
  const auto left = place("left");
  // As QLockFile writes them: process, program and host; no process has this number (2^22 is the
  // highest there can be).
  const std::string lock = "4194400\ngone\n" + QSysInfo::machineHostName().toStdString() + "\n";
  QVERIFY(writeTextFile(left / "0123.lock", lock));
  QVERIFY(writeTextFile(left / "0123.origin", "/home/somewhere.toml"));
  QVERIFY(writeTextFile(left / "4567.toml.part", "form"));
  // Put aside: one lately, one longer ago than a week.
  QVERIFY(writeTextFile(left / "cdef.aside", "format"));
  QVERIFY(writeTextFile(left / "fedc.aside", "format"));
  QVERIFY(writeTextFile(left / "fedc.origin", "/home/somewhere.toml"));
  QFile old(QString::fromStdString((left / "fedc.aside").string()));
  QVERIFY(old.open(QIODevice::ReadWrite));
  QVERIFY(
      old.setFileTime(QDateTime::currentDateTime().addDays(-8), QFileDevice::FileModificationTime));
  old.close();
  leaveBehind("89ab", demoFile("half done"));
  QVERIFY(writeTextFile(left / "89ab.lock", lock));
  window_->enableRecovery(left);
  QVERIFY(waitFor([this] { return messageText().contains(QStringLiteral("half done")); }));
  const QStringList all = QDir(QString::fromStdString(left.string())).entryList(QDir::Files);
  QVERIFY(all.contains(QStringLiteral("89ab.toml")));
  QCOMPARE(all.filter(QStringLiteral("0123")), QStringList());
  QCOMPARE(all.filter(QStringLiteral("4567")), QStringList());
  QVERIFY(all.contains(QStringLiteral("cdef.aside")));
  QCOMPARE(all.filter(QStringLiteral("fedc")), QStringList());
  QCOMPARE(all.filter(QStringLiteral(".lock")).size(), 1); // this window's
}

DEWPOINT_WINDOW_TEST(RecoveryTest)

} // namespace dewpoint::tests

#include "recovery_test.moc"
