// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog of experiments in the real window.
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>

#include <cstddef>
#include <vector>

namespace dewpoint::tests {

class ExperimentDialogTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init() { makeWindow({.size = {1400, 900}, .play = false}); }
  void cleanup() { window_.reset(); }
  void theMenuHasTheStudies();
  void anExperimentIsRefusedAtOnceAndLeftAloneWhileItRuns();
};

void ExperimentDialogTest::theMenuHasTheStudies() {
  action("actionExperiments")->trigger();
  auto* list = find<QListWidget>("experimentList");
  QVERIFY(waitFor([&] { return list->isVisible(); }));
  const auto choose = [&](const char* name) {
    for (int row = 0; row < list->count(); ++row) {
      if (list->item(row)->data(Qt::UserRole).toString() == QLatin1String(name)) {
        list->setCurrentRow(row);
        return true;
      }
    }
    return false;
  };
  QVERIFY(choose("sugandi-rmse"));
  QVERIFY(find<QLineEdit>("experimentRecordings")->isVisible());
  QVERIFY(!find<QComboBox>("experimentClothes")->isVisible());
  for (const char* name :
       {"people-crossing", "people-meet-and-turn", "people-side-by-side", "people-enter-leave",
        "people-apart", "people-heights", "people-furniture-moved", "people-patterned-clothes"}) {
    QVERIFY2(choose(name), name);
  }
  QVERIFY(!find<QLineEdit>("experimentRecordings")->isVisible());
  QVERIFY(find<QComboBox>("experimentClothes")->isVisible());
  QVERIFY(choose("barrera-fig3"));
  QVERIFY(!find<QComboBox>("experimentClothes")->isVisible());
  // Headings between them have a text, and are stepped over.
  std::vector<int> headings;
  for (int row = 0; row < list->count(); ++row) {
    QVERIFY(!list->item(row)->text().isEmpty());
    if (list->item(row)->flags() == Qt::NoItemFlags) {
      headings.push_back(row);
    }
  }
  QCOMPARE(headings.size(), std::size_t(4)); // three papers, and more scenes of people
  QCOMPARE(headings.front(), 0);
  list->setFocus();
  list->setCurrentRow(headings[1] - 1);
  QTest::keyClick(list, Qt::Key_Down);
  QCOMPARE(list->currentRow(), headings[1] + 1);
}

void ExperimentDialogTest::anExperimentIsRefusedAtOnceAndLeftAloneWhileItRuns() {
  action("actionExperiments")->trigger();
  auto* list = find<QListWidget>("experimentList");
  QVERIFY(waitFor([&] { return list->isVisible(); }));
  const auto rowOf = [&](const char* name) {
    int row = 0;
    while (list->item(row)->data(Qt::UserRole).toString() != QLatin1String(name)) {
      ++row;
    }
    return row;
  };
  auto* folder = find<QLineEdit>("experimentFolder");
  auto* state = find<QLabel>("experimentState");
  list->setCurrentRow(rowOf("people-crossing"));
  folder->setText(QStringLiteral("/proc/dewpoint"));
  find<QPushButton>("experimentRun")->click();
  QVERIFY(waitFor([&] { return state->text().contains(QStringLiteral("/proc/dewpoint")); }));
  QVERIFY(folder->isEnabled());
  folder->setText(folder_.filePath(QStringLiteral("people")));
  find<QPushButton>("experimentRun")->click();
  for (const char* name : {"experimentList", "experimentFolder", "experimentRuns",
                           "experimentClothes", "experimentBrowse", "experimentRun"}) {
    QVERIFY2(!find<QWidget>(name)->isEnabled(), name);
  }
  find<QPushButton>("experimentCancel")->click();
  QVERIFY(waitFor([&] { return folder->isEnabled(); }));
  QVERIFY(list->isEnabled());
}

DEWPOINT_WINDOW_TEST(ExperimentDialogTest)

} // namespace dewpoint::tests

#include "experiment_dialog_test.moc"
