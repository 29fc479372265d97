// SPDX-License-Identifier: GPL-3.0-or-later
// The window fills a screen when told to, and never grows beyond a small one.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QAction>
#include <QStatusBar>

namespace dewpoint::tests {

class WindowSizeTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow({.play = false}); }
  void cleanup() { window_.reset(); }
  void aMessageFitsASmallScreen_data();
  void aMessageFitsASmallScreen();
  void f11FillsTheScreen();
};

void WindowSizeTest::aMessageFitsASmallScreen_data() {
  QTest::addColumn<bool>("arranged");
  QTest::newRow("as it is") << false;
  QTest::newRow("arranged by hand, with nothing to spare above the plots") << true;
}

void WindowSizeTest::aMessageFitsASmallScreen() {
  QFETCH(bool, arranged);
  window_->resize(1024, 640);
  open(std::filesystem::path("demo"));
  QVERIFY(waitFor([this] { return shown().iterationCount > 0; }));
  QVERIFY(draws(*window_));
  const auto* status = window_->statusBar();
  const auto fits = [&] {
    return window_->size() == QSize(1024, 640) && window_->rect().contains(status->geometry());
  };
  if (arranged) {
    window_->findChild<ViewDock*>(QStringLiteral("birdsEyeDock"))->setFloating(true);
    window_->resizeDocks({window_->findChild<ViewDock*>(QStringLiteral("plotDock"))}, {500},
                         Qt::Vertical);
    QVERIFY(draws(*window_));
  }
  QVERIFY(fits());
  window_->workbench().messages.showError(QStringLiteral("something went wrong"));
  QVERIFY(settles(*window_));
  QVERIFY(fits());
  window_->workbench().messages.dismiss();
  QVERIFY(settles(*window_));
  QVERIFY(fits());
}

void WindowSizeTest::f11FillsTheScreen() {
  QAction* full = action("actionFullScreen");
  full->trigger();
  QVERIFY(waitFor([this] { return window_->isFullScreen(); }));
  QVERIFY(full->isChecked());
  full->trigger();
  QVERIFY(waitFor([this] { return !window_->isFullScreen(); }));
}

DEWPOINT_WINDOW_TEST(WindowSizeTest)

} // namespace dewpoint::tests

#include "window_size_test.moc"
