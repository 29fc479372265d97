// SPDX-License-Identifier: GPL-3.0-or-later
// The start page: its gallery of scenes, and the projects that were open last.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/recorded_demo.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/start/gallery_card.h"
#include "ui/start/project_thumbnails.h"
#include "ui/start/recent_projects.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/workbench.h"

#include <QDockWidget>
#include <QFile>
#include <QListWidget>
#include <QScrollArea>
#include <QStandardPaths>

namespace dewpoint::tests {

class StartPageTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase() { QStandardPaths::setTestModeEnabled(true); }
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void everyCardHasAPictureAndSaysWhatItIsFor();
  void eachCardOpensItsScene_data();
  void eachCardOpensItsScene();
  void enterAndSpacePressTheCardWithTheFocus();
  void aPressedCardSaysAtOnceThatItOpens();
  void itFitsASmallWindow();
  void recentProjectsShowWhatTheyAre();
};

void StartPageTest::everyCardHasAPictureAndSaysWhatItIsFor() {
  const auto cards = window_->findChildren<GalleryCard*>();
  QCOMPARE(cards.size(), 11);
  for (const GalleryCard* card : cards) {
    QVERIFY2(!card->accessibleName().isEmpty(), qPrintable(card->objectName()));
    QVERIFY2(!card->accessibleDescription().isEmpty(), qPrintable(card->objectName()));
    QVERIFY(card->focusPolicy() == Qt::StrongFocus);
  }
  for (const char* name :
       {"calibrate", "converge", "demo", "look-alikes", "occluder", "office", "one-camera"}) {
    const QPixmap picture(QStringLiteral(":/gallery/%1.jpg").arg(QLatin1String(name)));
    QVERIFY2(picture.width() >= 320, name);
  }
}

void StartPageTest::eachCardOpensItsScene_data() {
  QTest::addColumn<QString>("scene");
  QTest::addColumn<QString>("method");
  QTest::addColumn<int>("cameras");
  QTest::newRow("startDemo") << "demo"
                             << "dewpoint" << 2;
  QTest::newRow("startConverge") << "converge"
                                 << "barrera" << 2;
  QTest::newRow("startOccluder") << "occluder"
                                 << "dewpoint" << 2;
  QTest::newRow("startLookAlikes") << "look-alikes"
                                   << "dewpoint" << 2;
  QTest::newRow("startOffice") << "office"
                               << "people" << 4;
  QTest::newRow("startOneCamera") << "one-camera"
                                  << "histogram" << 1;
  QTest::newRow("startCalibrate") << "demo"
                                  << "dewpoint" << 2;
}

void StartPageTest::eachCardOpensItsScene() {
  QFETCH(QString, scene);
  QFETCH(QString, method);
  QFETCH(int, cameras);
  const QString card = QLatin1String(QTest::currentDataTag());
  find<GalleryCard>(card)->click();
  QVERIFY(isOpen(static_cast<std::size_t>(cameras)));
  const Project& project = window_->document().project();
  QCOMPARE(project.scene, scene.toStdString());
  QCOMPARE(project.method, method.toStdString());
  const bool calibrates = card == QLatin1String("startCalibrate");
  QVERIFY(waitFor([&] { return find<QDockWidget>("calibrationDock")->isVisible() == calibrates; }));
  QCOMPARE(action("actionCalibrateByHand")->isChecked(), calibrates);
  if (method == QLatin1String("histogram")) { // the ball is in its box
    QVERIFY(waitFor([this] { return shown().frame >= 5; }));
    QVERIFY(project.targets.at(0).box.has_value());
  }
}

void StartPageTest::enterAndSpacePressTheCardWithTheFocus() {
  auto* card = find<GalleryCard>("startOneCamera");
  card->setFocus();
  QTest::keyClick(card, Qt::Key_Return);
  QVERIFY(isOpen(1));
  auto& messages = window_->workbench().messages;
  messages.showQuestion(QStringLiteral("Restart?"), {{QStringLiteral("Restart"), [] {}}});
  action("actionCloseProject")->trigger();
  QVERIFY(waitFor([card] { return card->isVisible(); }));
  QVERIFY(!card->isBusy());
  QVERIFY(!action("actionPlay")->text().contains(QStringLiteral("Pause")));
  QVERIFY(!messages.isVisible()); // the question was about what is closed
  QTest::keyClick(card, Qt::Key_Space);
  QVERIFY(isOpen(1));
}

void StartPageTest::aPressedCardSaysAtOnceThatItOpens() {
  auto* card = find<GalleryCard>("startDemo");
  card->click();
  QVERIFY(card->isBusy());
  QCOMPARE(window_->cursor().shape(), Qt::BusyCursor);
  QVERIFY(isOpen(2));
  QVERIFY(!card->isBusy());
  QCOMPARE(window_->cursor().shape(), Qt::ArrowCursor);
}

void StartPageTest::itFitsASmallWindow() {
  window_->resize(1024, 640);
  auto* page = find<QWidget>("startPage");
  QVERIFY(keepsItsSize(page));
  auto* last = find<GalleryCard>("startCalibrate");
  scrollTo(last);
  QVERIFY(waitFor([last] { return !last->visibleRegion().isEmpty(); }));
  for (const GalleryCard* card : window_->findChildren<GalleryCard*>()) {
    const QRect place(card->mapTo(page, QPoint()), card->size());
    QVERIFY2(place.left() >= 0 && place.right() < page->width(), qPrintable(card->objectName()));
    QVERIFY2(card->height() >= card->heightForWidth(card->width()), qPrintable(card->objectName()));
  }
}

void StartPageTest::recentProjectsShowWhatTheyAre() {
  QVERIFY(recordDesk(folder_.path().toStdString()));
  const QString desk = file("desk.toml");
  Preferences().addRecentProject(file("gone.toml"));
  open(desk.toStdString());
  QVERIFY(isOpen(2));
  QVERIFY(ProjectThumbnails::read(desk).isNull());
  action("actionCloseProject")->trigger();
  auto* list = find<QListWidget>("startRecent");
  const auto* projects = window_->findChild<RecentProjects*>();
  QVERIFY(waitFor([&] { return !projects->allProjects().at(0).thumbnail.isNull(); }));
  QCOMPARE(projects->allProjects().at(0).file, desk);
  QVERIFY(projects->allProjects().at(0).lastModified.isValid());
  QCOMPARE(list->count(), 2);
  QVERIFY(list->item(0)->flags().testFlag(Qt::ItemIsEnabled));
  QVERIFY(!list->item(1)->flags().testFlag(Qt::ItemIsEnabled)); // its file is gone
  QCOMPARE(projects->openableFiles(), QStringList{desk});
}

DEWPOINT_WINDOW_TEST(StartPageTest)

} // namespace dewpoint::tests

#include "start_page_test.moc"
