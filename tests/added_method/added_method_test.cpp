// SPDX-License-Identifier: GPL-3.0-or-later
// The window with a method that was added by a pair of files and one row.
#include "core/project/project.h"
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/help/manual_pages.h"

#include <QComboBox>
#include <QLabel>

#include <algorithm>

namespace dewpoint::tests {

class AddedMethodTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow(); }
  void cleanup() { window_.reset(); }
  void isReadFromAProjectFileAndTracked();
  void isChosenBesideTheOthers();

private:
  /// Whether all targets are shown there, in meters, as held.
  bool areParkedAt(double x, double y) {
    return waitFor([&] {
      return shown().isTracked && !shown().targets.empty() &&
             std::ranges::all_of(shown().targets, [&](const TargetSnapshot& target) {
               const auto position = positionOf(target.estimate);
               return isConfirmed(target.estimate) && position &&
                      position->mean == Eigen::Vector3d(x, y, 0.0);
             });
    });
  }
};

void AddedMethodTest::isReadFromAProjectFileAndTracked() {
  Project project = resolveProject("demo").value();
  project.method = "parked";
  project.parameters = ParameterValues(methodParameters("parked"));
  QVERIFY(project.parameters.set("parked_x", 0.75));
  QVERIFY(saveProject(project, path("parked.toml")));
  open(path("parked.toml"));
  QVERIFY(areParkedAt(0.75, 0.5));
  QCOMPARE(find<QComboBox>("methodChoice")->currentData().toString(), QStringLiteral("parked"));
  QCOMPARE(find<QComboBox>("methodChoice")->currentText(),
           QStringLiteral("Targets that stand still"));
  QCOMPARE(find<QLabel>("methodSentence")->text(),
           QStringLiteral("Believes that every target stands still at a place of your choice."));
  QCOMPARE(manualPageOfMethod(QStringLiteral("parked")), QStringLiteral("method-dynamics.md"));
  // Its parameters act at once, by the widgets made from their declarations.
  QVERIFY(window_->document().setParameter("parked_y", -2.0));
  QVERIFY(areParkedAt(0.75, -2.0));
}

void AddedMethodTest::isChosenBesideTheOthers() {
  open();
  QVERIFY(waitFor([&] { return shown().isTracked; }));
  auto* choice = find<QComboBox>("methodChoice");
  QCOMPARE(choice->currentData().toString(), QStringLiteral("dewpoint"));
  const int row = choice->findData(QStringLiteral("parked"));
  QVERIFY(row >= 0);
  choice->setCurrentIndex(row);
  Q_EMIT choice->activated(row);
  QVERIFY(areParkedAt(0.25, 0.5));
}

DEWPOINT_WINDOW_TEST(AddedMethodTest)

} // namespace dewpoint::tests

#include "added_method_test.moc"
