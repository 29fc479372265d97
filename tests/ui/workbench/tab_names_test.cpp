// SPDX-License-Identifier: GPL-3.0-or-later
// The names of all tabs of the views can be read in full, in every language, and the panel of the
// cameras is not cut.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/text/language.h"

#include <QDockWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>

#include <algorithm>

namespace dewpoint::tests {

class TabNamesTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void cleanup() {
    window_->setLanguage(QStringLiteral("en"));
    window_.reset();
  }
  void theyAreWhole_data();
  void theyAreWhole();
  void theyAreWholeInANewLanguage();
  void theCamerasFitTheirDock_data() { theyAreWhole_data(); }
  void theCamerasFitTheirDock();

private:
  /// The bars of tabs of docks, as far as they can be seen.
  QList<const QTabBar*> bars() const {
    QList<const QTabBar*> seen;
    for (const QTabBar* bar : window_->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
      if (bar->isVisible() && bar->count() > 0) {
        seen << bar;
      }
    }
    return seen;
  }
  /// Names of bars that are too narrow for them; empty when all are whole.
  QString cutNames() const {
    QStringList cut;
    for (const QTabBar* bar : bars()) {
      if (bar->width() < bar->sizeHint().width()) {
        for (int tab = 0; tab < bar->count(); ++tab) {
          cut << bar->tabText(tab);
        }
        cut << QStringLiteral("%1 of %2 pixels").arg(bar->width()).arg(bar->sizeHint().width());
      }
    }
    return cut.join(QStringLiteral(", "));
  }
  /// Opens the demo with all five tabs at the side.
  void openAllTabs(const QSize& size) {
    makeWindow({.size = size, .play = false});
    open();
    action("actionCalibrateByHand")->setChecked(true);
    QVERIFY(waitFor([this] {
      return std::ranges::any_of(bars(), [](const QTabBar* bar) { return bar->count() == 5; });
    }));
  }
};

void TabNamesTest::theyAreWhole_data() {
  QTest::addColumn<QString>("language");
  QTest::addColumn<QSize>("size");
  for (const char* language : {"en", "de", "es", "ja"}) {
    for (const QSize& size : {QSize(1400, 900), QSize(1600, 1000)}) {
      QTest::addRow("%s %d", language, size.width()) << QString::fromLatin1(language) << size;
    }
  }
}

void TabNamesTest::theyAreWhole() {
  QFETCH(QString, language);
  QFETCH(QSize, size);
  useLanguage(language);
  openAllTabs(size);
  QCOMPARE(window_->size(), size);
  QVERIFY2(waitFor([this] { return cutNames().isEmpty(); }), qPrintable(cutNames()));
}

void TabNamesTest::theyAreWholeInANewLanguage() {
  useLanguage(QStringLiteral("en"));
  openAllTabs({1400, 900});
  QVERIFY(waitFor([this] { return cutNames().isEmpty(); }));
  for (const char* language : {"es", "ja", "de"}) {
    window_->setLanguage(QString::fromLatin1(language));
    QVERIFY2(waitFor([this] { return cutNames().isEmpty(); }), qPrintable(cutNames()));
  }
}

void TabNamesTest::theCamerasFitTheirDock() {
  QFETCH(QString, language);
  QFETCH(QSize, size);
  useLanguage(language);
  makeWindow({.size = size, .play = false});
  open();
  find<QDockWidget>("cameraListDock")->raise();
  const auto* scroll = find<QScrollArea>("cameraListDockScroll");
  QVERIFY(waitFor([&] { return scroll->isVisible(); }));
  QVERIFY(keepsItsSize(scroll));
  const int needed = scroll->widget()->minimumSizeHint().width();
  QVERIFY2(scroll->horizontalScrollBar()->maximum() == 0, qPrintable(QString::number(needed)));
}

DEWPOINT_WINDOW_TEST(TabNamesTest)

} // namespace dewpoint::tests

#include "tab_names_test.moc"
