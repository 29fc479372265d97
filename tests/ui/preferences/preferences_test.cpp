// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/floors.h"
#include "tests/ui/window_test.h"
#include "ui/preferences/preferences.h"
#include "ui/start/recent_projects.h"

#include <QCoreApplication>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace dewpoint::tests {

class PreferencesTest : public QObject {
  Q_OBJECT
private Q_SLOTS:
  void init() { QSettings().clear(); }
  void atFirstThereIsNone();
  void whatEarlierVersionsWroteIsRead();
  void whatIsSetIsThereAtTheNextStart();
  void recentProjectsAreTheNewestThatAreThere();
};

void PreferencesTest::atFirstThereIsNone() {
  const Preferences preferences;
  QCOMPARE(preferences.theme(), Theme::System);
  QVERIFY(preferences.language().isEmpty());
  QVERIFY(preferences.windowGeometry().isEmpty());
  QVERIFY(preferences.recentProjects().isEmpty());
  QVERIFY(preferences.lastFolder().isEmpty());
  QCOMPARE(preferences.filterThreadCount(), 0);
  QVERIFY(!preferences.shortcut(QStringLiteral("actionPlay")));
  QVERIFY(!preferences.shownPlots());
  QVERIFY(preferences.showsPlotsOverTime());
  const BoardPreferences otherwise{QStringLiteral("some board"), 1, false, true, 0.25, 0.5};
  const BoardPreferences board = preferences.boardPreferences(otherwise);
  QCOMPARE(board.boardText, otherwise.boardText);
  QCOMPARE(board.lensModel, 1);
  QVERIFY(!board.calibratesIntrinsics);
  QVERIFY(board.calibratesPositions);
  QCOMPARE(board.intrinsicsAccuracyPx, 0.25);
  QCOMPARE(board.positionAccuracyMeters, 0.5);
}

/// The keys and forms of the versions before there was this class.
void PreferencesTest::whatEarlierVersionsWroteIsRead() {
  QTemporaryDir folder;
  const QString project = folder.filePath(QStringLiteral("mine.toml"));
  QVERIFY(QFile(project).open(QIODevice::WriteOnly));
  QSettings settings;
  settings.setValue(QStringLiteral("theme"), QStringLiteral("dark"));
  settings.setValue(QStringLiteral("language"), QStringLiteral("de"));
  settings.setValue(QStringLiteral("recentProjects"), QStringList{project});
  settings.setValue(QStringLiteral("shortcuts/actionPlay"), QStringLiteral("Ctrl+J"));
  settings.setValue(QStringLiteral("shortcuts/actionRestart"), QString());
  settings.setValue(QStringLiteral("plots/shown"), QStringList{QStringLiteral("error")});
  settings.setValue(QStringLiteral("plots/overTime"), false);
  settings.setValue(QStringLiteral("calibration/board"), QStringLiteral("chessboard 9 6 0.03"));
  settings.setValue(QStringLiteral("calibration/boardModel"), 2);
  settings.setValue(QStringLiteral("calibration/boardLenses"), false);
  settings.setValue(QStringLiteral("calibration/boardPlaces"), true);
  settings.setValue(QStringLiteral("calibration/boardLensAccuracy"), 0.3);
  settings.setValue(QStringLiteral("calibration/boardPlaceAccuracy"), 0.001);
  const Preferences preferences;
  QCOMPARE(preferences.theme(), Theme::Dark);
  QCOMPARE(preferences.language(), QStringLiteral("de"));
  QCOMPARE(preferences.recentProjects(), QStringList{project});
  QCOMPARE(preferences.shortcut(QStringLiteral("actionPlay")),
           std::optional(QKeySequence(Qt::CTRL | Qt::Key_J)));
  QCOMPARE(preferences.shortcut(QStringLiteral("actionRestart")), std::optional(QKeySequence()));
  QCOMPARE(preferences.shownPlots(), std::optional(QStringList{QStringLiteral("error")}));
  QVERIFY(!preferences.showsPlotsOverTime());
  const BoardPreferences board = preferences.boardPreferences({});
  QCOMPARE(board.boardText, QStringLiteral("chessboard 9 6 0.03"));
  QCOMPARE(board.lensModel, 2);
  QVERIFY(!board.calibratesIntrinsics);
  QVERIFY(board.calibratesPositions);
  QCOMPARE(board.intrinsicsAccuracyPx, 0.3);
  QCOMPARE(board.positionAccuracyMeters, 0.001);
}

void PreferencesTest::whatIsSetIsThereAtTheNextStart() {
  Preferences before;
  before.setTheme(Theme::Light);
  before.setLanguage(QStringLiteral("ja"));
  before.setWindowGeometry("geometry");
  before.setFilterThreadCount(3);
  before.setShortcut(QStringLiteral("actionPlay"), QKeySequence(Qt::Key_X));
  before.setShortcut(QStringLiteral("actionRestart"), QKeySequence(Qt::Key_Y));
  before.setShortcut(QStringLiteral("actionRestart"), std::nullopt); // as declared again
  before.setShownPlots({});
  before.setShowsPlotsOverTime(false); // not the default
  QTemporaryDir folder;
  before.setLastFolder(folder.path());
  QSettings().sync();
  const Preferences after;
  QCOMPARE(after.theme(), Theme::Light);
  QCOMPARE(after.language(), QStringLiteral("ja"));
  QCOMPARE(after.windowGeometry(), QByteArray("geometry"));
  QCOMPARE(after.filterThreadCount(), 3);
  QCOMPARE(after.shortcut(QStringLiteral("actionPlay")), std::optional(QKeySequence(Qt::Key_X)));
  QVERIFY(!after.shortcut(QStringLiteral("actionRestart")));
  QCOMPARE(after.shownPlots(), std::optional(QStringList())); // none is a choice, too
  QVERIFY(!after.showsPlotsOverTime());
  QCOMPARE(after.lastFolder(), folder.path());
  before.setLastFolder(QStringLiteral("/"));
  QCOMPARE(after.lastFolder(), QStringLiteral("/"));
}

void PreferencesTest::recentProjectsAreTheNewestThatAreThere() {
  QTemporaryDir folder;
  Preferences preferences;
  QStringList newestFirst;
  for (int k = 0; k < 12; ++k) {
    const QString file = folder.filePath(QStringLiteral("%1.toml").arg(k));
    QVERIFY(QFile(file).open(QIODevice::WriteOnly));
    preferences.addRecentProject(file);
    newestFirst.prepend(file);
  }
  QCOMPARE(preferences.recentProjects(), newestFirst.mid(0, 10));
  preferences.addRecentProject(newestFirst.at(4));
  QCOMPARE(preferences.recentProjects().front(), newestFirst.at(4));
  QCOMPARE(preferences.recentProjects().size(), 10);
  RecentProjects offered;
  offered.checkFiles();
  QCOMPARE(offered.openableFiles(), preferences.recentProjects());
  QVERIFY(QFile::remove(newestFirst.at(4)));
  offered.checkFiles();
  QVERIFY(QTest::qWaitFor([&] { return !offered.openableFiles().contains(newestFirst.at(4)); },
                          DEWPOINT_PATIENCE_MS));
  QCOMPARE(offered.openableFiles().size(), 9);
  QVERIFY(QFile(newestFirst.at(4)).open(QIODevice::WriteOnly)); // it is back
  offered.checkFiles();
  QVERIFY(QTest::qWaitFor([&] { return offered.openableFiles() == preferences.recentProjects(); },
                          DEWPOINT_PATIENCE_MS));
  preferences.clearRecentProjects();
  QVERIFY(preferences.recentProjects().isEmpty());
}

DEWPOINT_CORE_TEST(PreferencesTest)

} // namespace dewpoint::tests

#include "preferences_test.moc"
