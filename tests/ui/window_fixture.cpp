// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"

#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/manual/grid_layer.h"
#include "ui/cameraview/camera_view.h"
#include "ui/jobs/job_thread.h"
#include "ui/plots/plot_stack.h"
#include "ui/view3d/birds_eye_view.h"

#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QScrollArea>
#include <QSettings>
#include <QSignalSpy>
#include <QToolButton>
#include <QUrl>

#include <algorithm>
#include <chrono>

namespace dewpoint::tests::test {

namespace {

template <class View> bool isDrawn(const QWidget& widget) {
  const auto views = widget.findChildren<View*>();
  const auto* self = qobject_cast<const View*>(&widget);
  return (self == nullptr || self->isDrawn()) &&
         std::ranges::all_of(views, [](const View* view) { return view->isDrawn(); });
}

/// Pictures are drawn at rates of their own, or beside the window.
bool allIsDrawn(const QWidget& widget) {
  return isDrawn<BirdsEyeView>(widget) && isDrawn<PlotStack>(widget) &&
         isDrawn<CameraView>(widget) && isDrawn<GridLayer>(widget);
}

} // namespace

WindowFixture::WindowFixture() = default;
WindowFixture::~WindowFixture() = default;

void WindowFixture::makeWindow(const WindowSetup& setup) {
  QSettings().clear();
  makeAnotherWindow(setup);
}

void WindowFixture::makeAnotherWindow(const WindowSetup& setup) {
  window_ = std::make_unique<MainWindow>(setup.opener);
  if (setup.theme) {
    window_->setTheme(*setup.theme);
  }
  window_->setPlayOnOpen(setup.play);
  if (!setup.size.isEmpty()) {
    window_->resize(setup.size);
  }
  if (!setup.show) {
    return;
  }
  window_->show();
  window_->activateWindow(); // else shortcuts vanish
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

QString WindowFixture::messageText() const {
  return find<QLabel>("messageText")->text();
}

const TrackSnapshot& WindowFixture::shown() const {
  static const TrackSnapshot kNone;
  return window_->shown() ? *window_->shown() : kNone;
}

void WindowFixture::open(const std::filesystem::path& project) {
  QSignalSpy opened(window_.get(), &MainWindow::projectOpened);
  window_->openProject(project);
  QVERIFY2(opened.wait(kTimeoutMs), qPrintable(messageText()));
}

void WindowFixture::openDemo() {
  QTest::mouseClick(find<QToolButton>("startDemo"), Qt::LeftButton);
  QVERIFY(isOpen(2));
}

bool WindowFixture::isOpen(std::size_t cameras) const {
  return waitFor([&] {
    return window_->shown() && shown().frame >= 0 && shown().rig->size() == cameras &&
           find<QWidget>("start")->isHidden();
  });
}

void WindowFixture::drop(const QStringList& files) {
  QMimeData data;
  QList<QUrl> urls;
  for (const QString& one : files) {
    urls.append(QUrl::fromLocalFile(one));
  }
  data.setUrls(urls);
  QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent event({100.0, 100.0}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &event);
}

bool WindowFixture::draws(const QWidget& widget) {
  return keepsItsSize(&widget) && waitFor([&] { return allIsDrawn(widget); });
}

bool WindowFixture::settles(QWidget& widget) {
  constexpr int kRounds = 5; // of the event loop, with the same picture
  QImage last;
  int same = 0;
  return draws(widget) && waitFor([&] {
           QImage now = widget.grab().toImage();
           same = allIsDrawn(widget) && now == last ? same + 1 : 0;
           last = std::move(now);
           return same >= kRounds;
         });
}

bool WindowFixture::jobsEnd() {
  constexpr int kRounds = 5; // of the event loop: what one job found may begin the next
  int idle = 0;
  return waitFor([&] {
    idle = waitForDetachedJobs(std::chrono::milliseconds(0)) ? idle + 1 : 0;
    return idle >= kRounds;
  });
}

void WindowFixture::scrollTo(QWidget* part) {
  for (QWidget* parent = part; parent != nullptr; parent = parent->parentWidget()) {
    if (auto* scroll = qobject_cast<QScrollArea*>(parent)) {
      scroll->ensureWidgetVisible(part);
    }
  }
}

void prepareApplication() {
  BirdsEyeView::prepareSurfaceFormat();
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
}

} // namespace dewpoint::tests::test
