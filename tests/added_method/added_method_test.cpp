// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a method that was added by a pair of files and one row.
#include "app/wiring/open_project.h"
#include "core/project/project.h"
#include "core/project/project_save.h"
#include "core/session/run/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"
#include "ui/view3d/birds_eye_view.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>

namespace dewpoint::tests {

class AddedMethodTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void isReadFromAProjectFileAndTracked();
  void isChosenBesideTheOthers();

private:
  template <class T> T* find(const char* name) {
    T* found = window_->findChild<T*>(QLatin1String(name));
    if (found == nullptr) {
      qFatal("no child named %s", name);
    }
    return found;
  }
  bool waitFor(const std::function<bool()>& holds) {
    return QTest::qWaitFor([&] { return window_->shown() && holds(); }, DEWPOINT_PATIENCE_MS);
  }
  /// Whether all targets are shown there, in meters, as held.
  bool areParkedAt(double x, double y) {
    return waitFor([&] {
      const auto shown = window_->shown();
      return shown->tracked && !shown->targets.empty() &&
             std::ranges::all_of(shown->targets, [&](const TargetSnapshot& target) {
               const auto position = positionOf(target.estimate);
               return isHeld(target.estimate) && position &&
                      position->mean == Eigen::Vector3d(x, y, 0.0);
             });
    });
  }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

void AddedMethodTest::init() {
  window_ = std::make_unique<MainWindow>(&openProject);
  window_->setPlayOnOpen(true);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void AddedMethodTest::isReadFromAProjectFileAndTracked() {
  Project project = resolveProject("demo").value();
  project.method = "parked";
  project.parameters = ParameterValues(methodParameters("parked"));
  QVERIFY(project.parameters.set("parked_x", 0.75));
  const std::filesystem::path file = folder_.filePath("parked.toml").toStdString();
  QVERIFY(saveProject(project, file));
  window_->openProject(file);
  QVERIFY(areParkedAt(0.75, 0.5));
  QCOMPARE(find<QComboBox>("methodChoice")->currentText(), QStringLiteral("parked"));
  QCOMPARE(find<QLabel>("methodSentence")->text(),
           QStringLiteral("Believes that every target stands still at a place of your choice."));
  // Its parameters act at once, by the widgets made from their declarations.
  QVERIFY(window_->document().setParameter("parked_y", -2.0));
  QVERIFY(areParkedAt(0.75, -2.0));
}

void AddedMethodTest::isChosenBesideTheOthers() {
  window_->openProject({});
  QVERIFY(waitFor([&] { return window_->shown()->tracked; }));
  auto* choice = find<QComboBox>("methodChoice");
  QCOMPARE(choice->currentText(), QStringLiteral("dewpoint"));
  const int row = choice->findText(QStringLiteral("parked"));
  QVERIFY(row >= 0);
  choice->setCurrentIndex(row);
  Q_EMIT choice->activated(row);
  QVERIFY(areParkedAt(0.25, 0.5));
}

} // namespace dewpoint::tests

int main(int argc, char** argv) {
  dewpoint::ui::BirdsEyeView::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("dewpoint-test"));
  dewpoint::tests::AddedMethodTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "added_method_test.moc"
