// SPDX-License-Identifier: GPL-3.0-or-later
// The window in another language: a translator that marks every text it is asked for shows which
// texts of the window never pass through a translation, and whether the catalogs know the rest.
#include "core/base/error.h"
#include "core/project/project.h"
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/document/document.h"
#include "ui/text/color_assessment_text.h"
#include "ui/text/error_sentence.h"
#include "ui/text/language.h"
#include "ui/trajectory/gap_list.h"
#include "ui/widgets/collapsible_section.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QRegularExpression>
#include <QTabBar>
#include <QToolButton>
#include <QTranslator>
#include <QUndoStack>

#include <set>

namespace dewpoint::tests {

namespace {

const QChar kMark(0x2020); ///< a dagger: no text of ours has one

/// Marks every text that is not Qt's own, and remembers what it was asked for.
class MarkingTranslator : public QTranslator {
public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char*, int) const override {
    if (context[0] == 'Q' && QChar::isUpper(uint(context[1]))) { // a class of Qt
      return {};
    }
    asked.insert({context, text});
    return kMark + QString::fromUtf8(text);
  }
  mutable std::set<std::pair<QByteArray, QByteArray>> asked;
};

/// Whether a text has words, other than names of axes and units, but no mark.
bool isUntranslated(const QString& text) {
  static const QRegularExpression kWord(QStringLiteral("\\p{L}{3,}"));
  return text.contains(kWord) && !text.contains(kMark);
}

/// All texts a person can see or hear of one widget.
QStringList textsOf(const QWidget& widget) {
  QStringList texts{widget.toolTip(), widget.accessibleName(), widget.accessibleDescription()};
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    texts << label->text();
  } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    texts << button->text();
  } else if (const auto* box = qobject_cast<const QDoubleSpinBox*>(&widget)) {
    texts << box->suffix() << box->prefix();
  } else if (const auto* menu = qobject_cast<const QMenu*>(&widget)) {
    texts << menu->title();
  } else if (qobject_cast<const QDockWidget*>(&widget) != nullptr) {
    texts << widget.windowTitle();
  }
  return texts;
}

/// A child of a QLineEdit, a tab bar and the like speaks Qt's language, not ours.
bool isDewpointMethod(const QObject& object) {
  return qobject_cast<const QTabBar*>(object.parent()) == nullptr &&
         !object.objectName().startsWith(QStringLiteral("qt_"));
}

} // namespace

class TranslationTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void everyTextOfTheWindowIsTranslated();
  void everyTextFollowsAChangeOfLanguage();
  void theLanguageIsUsed();
  void methodsAreCalledTheSameEverywhere();
  void numbersFollowTheLanguage();
  void whatIsOpenFollowsToo();
  void anAssessmentSaysWhatItsScoreIsMadeOf();
  void titlesOfTheGapsAreWhole();
  void anErrorIsTranslatedButNotItsFileAndField();
  void cleanup() { window_.reset(); }

private:
  void trackDemo();
};

/// Opens the demo and tracks some frames of it.
void TranslationTest::trackDemo() {
  makeWindow();
  open();
  QVERIFY(waitFor([this] { return shown().frame > 5; }));
  const auto& declarations = window_->document().project().parameters.declarations();
  QVERIFY(window_->document().setParameter(declarations.front().key, declarations.front().maximum));
}

/// What the window says that no translator was asked for, as "who: what".
QStringList untranslatedTexts(const MainWindow& window) {
  std::set<QString> names; // what a camera or a target is called is the user's
  for (const auto& camera : window.document().project().cameras) {
    names.insert(QString::fromStdString(camera.camera.name));
  }
  for (const auto& target : window.document().project().targets) {
    names.insert(QString::fromStdString(target.name));
  }
  QStringList found;
  const auto check = [&](const QObject& object, const QStringList& texts) {
    for (const QString& text : texts) {
      if (isDewpointMethod(object) && !names.contains(text) && isUntranslated(text)) {
        found.append(object.objectName() + QStringLiteral(": ") + text);
      }
    }
  };
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    check(*widget, textsOf(*widget));
  }
  for (const QAction* action : window.findChildren<QAction*>()) {
    check(*action, {action->text(), action->toolTip(), action->statusTip()});
  }
  return found;
}

void TranslationTest::everyTextOfTheWindowIsTranslated() {
  MarkingTranslator marking;
  QVERIFY(QCoreApplication::installTranslator(&marking));
  trackDemo();
  const QStringList untranslated = untranslatedTexts(*window_);
  QVERIFY2(untranslated.isEmpty(), qPrintable(untranslated.join(QLatin1Char('\n'))));
  QCoreApplication::removeTranslator(&marking);

  // What the window asked for, the catalogs have, under the same context.
  for (const QString& language : availableLanguages()) {
    QTranslator catalog;
    QVERIFY(catalog.load(QStringLiteral(":/translations/dewpoint_") + language));
    for (const auto& [context, text] : marking.asked) {
      QVERIFY2(language == QStringLiteral("en") || !catalog.translate(context, text).isNull(),
               qPrintable(language + QStringLiteral(", ") + context + QStringLiteral(": ") + text));
    }
  }
}

void TranslationTest::everyTextFollowsAChangeOfLanguage() {
  trackDemo();
  MarkingTranslator marking; // the other language
  QVERIFY(QCoreApplication::installTranslator(&marking));
  QStringList untranslated;
  // The widgets are told through the event queue, and the next snapshot fills in the figures.
  (void)waitFor([&] { return (untranslated = untranslatedTexts(*window_)).isEmpty(); });
  QVERIFY2(untranslated.isEmpty(), qPrintable(untranslated.join(QLatin1Char('\n'))));
  QCoreApplication::removeTranslator(&marking);
}

void TranslationTest::theLanguageIsUsed() {
  QVERIFY(availableLanguages().contains(QStringLiteral("de")));
  useLanguage(QStringLiteral("de"));
  makeWindow();
  // The German catalog's word for "Restart", and a decimal comma.
  QCOMPARE(find<QAction>("actionRestart")->text(), QStringLiteral("Neu beginnen"));
  QCOMPARE(QLocale().toString(0.5, 'f', 1), QStringLiteral("0,5"));
}

void TranslationTest::methodsAreCalledTheSameEverywhere() {
  useLanguage(QStringLiteral("de"));
  trackDemo();
  const auto* choice = find<QComboBox>("methodChoice");
  QVERIFY(choice->count() > 1);
  std::set<std::string> names;
  for (int i = 0; i < choice->count(); ++i) {
    if (choice->itemData(i).isValid()) { // no heading
      names.insert(choice->itemData(i).toString().toStdString());
    }
  }
  const auto known = methodNames();
  QVERIFY(names == std::set<std::string>(known.begin(), known.end()));
  QCOMPARE(find<QLabel>("qt_methodName")->text(), QStringLiteral("dewpoint"));
}

void TranslationTest::numbersFollowTheLanguage() {
  useLanguage(QStringLiteral("en"));
  trackDemo();
  find<CollapsibleSection>("group_Expert")->findChild<QToolButton*>("sectionHead")->click();
  const auto box = [this] { return find<QDoubleSpinBox>("box_kld_error"); }; // made anew
  QVERIFY(window_->document().setParameter("kld_error", 0.15));
  QCOMPARE(box()->text(), QStringLiteral("0.15"));
  window_->setLanguage(QStringLiteral("de"));
  QTRY_COMPARE_WITH_TIMEOUT(box()->text(), QStringLiteral("0,15"), kTimeoutMs);
  // Both signs are understood, and shown as the language's own.
  const auto type = [&](const char* text) {
    box()->setFocus();
    box()->selectAll();
    QTest::keyClicks(box(), QLatin1String(text));
    const QString typed = box()->text();
    QTest::keyClick(box(), Qt::Key_Return);
    return typed;
  };
  QCOMPARE(type("0.25"), QStringLiteral("0,25"));
  QCOMPARE(window_->document().project().parameters.at("kld_error"), 0.25);
  QCOMPARE(type("0,35"), QStringLiteral("0,35"));
  QCOMPARE(window_->document().project().parameters.at("kld_error"), 0.35);
  // Files stay with points.
  QVERIFY(projectText(window_->document().project(), "/").find("kld_error = 0.35\n") !=
          std::string::npos);
  window_->setLanguage(QStringLiteral("en"));
  QTRY_COMPARE_WITH_TIMEOUT(box()->text(), QStringLiteral("0.35"), kTimeoutMs);
  QCOMPARE(type("0,45"), QStringLiteral("0.45"));
  QCOMPARE(window_->document().project().parameters.at("kld_error"), 0.45);
}

void TranslationTest::whatIsOpenFollowsToo() {
  useLanguage(QStringLiteral("en"));
  trackDemo();
  const auto* saturation = find<QDoubleSpinBox>("saturationFrom");
  QVERIFY(window_->document().edit(QStringLiteral("test"), [](Project& project) {
    project.targets[0].color.saturationMin = 0.25;
  }));
  QTRY_COMPARE_WITH_TIMEOUT(saturation->text(), QStringLiteral("0.25"), kTimeoutMs);
  find<QAction>("actionShortcuts")->trigger();
  const auto* note = find<QLabel>("shortcutNote");
  const QString english = note->text();
  window_->setLanguage(QStringLiteral("de"));
  QTRY_COMPARE_WITH_TIMEOUT(saturation->text(), QStringLiteral("0,25"), kTimeoutMs);
  QTRY_VERIFY_WITH_TIMEOUT(note->text() != english, kTimeoutMs);
  window_->setLanguage(QStringLiteral("en"));
  QTRY_COMPARE_WITH_TIMEOUT(note->text(), english, kTimeoutMs);
}

void TranslationTest::anAssessmentSaysWhatItsScoreIsMadeOf() {
  useLanguage(QStringLiteral("en"));
  ColorAssessment assessment;
  assessment.separability = 0.04;
  assessment.targetShare = 0.02;
  assessment.backgroundShare = 0.0;
  assessment.backgroundShareOfFullRange = 0.015;
  const QString missed = colorAssessmentText(assessment, {});
  QVERIFY2(missed.contains(QStringLiteral(
               "This color covers only 2 % of the target, and 0.00 % of the background.")) &&
               missed.contains(QStringLiteral("would also cover 1.50 % of the background")),
           qPrintable(missed));
  assessment.targetShare = 0.9;
  assessment.backgroundShareOfFullRange.reset();
  const QString hit = colorAssessmentText(assessment, {});
  QVERIFY2(hit.contains(QStringLiteral("This color also covers 0.00 % of the background.")),
           qPrintable(hit));
  // Of a good color, what matches beside the target is said to be little.
  assessment.separability = 0.97;
  const QString alone = colorAssessmentText(assessment, {});
  QVERIFY2(
      alone.contains(QStringLiteral("stands out well (97 of 100 points). Almost nothing else")),
      qPrintable(alone));
  assessment.backgroundShare = 0.0007;
  assessment.distractors.emplace_back().color = ColorName::Green;
  const QString good = colorAssessmentText(assessment, {QStringLiteral("left")});
  QVERIFY2(good.contains(QStringLiteral("Only 0.07 % of the background has this color too, which "
                                        "is little compared with the target.")) &&
               good.endsWith(QStringLiteral("Outside the target, the largest region of this color "
                                            "(green) is in the image of left, in the center.")),
           qPrintable(good));
}

void TranslationTest::titlesOfTheGapsAreWhole() {
  useLanguage(QStringLiteral("en"));
  trackDemo();
  auto* gaps = window_->findChild<GapList*>();
  for (const QString& language : availableLanguages()) {
    window_->setLanguage(language);
    const auto fits = [&](int column) {
      return gaps->columnWidth(column) >= gaps->horizontalHeader()->sectionSizeHint(column);
    };
    for (int column = 0; column < gaps->columnCount(); ++column) {
      QTRY_VERIFY_WITH_TIMEOUT(fits(column), kTimeoutMs);
    }
  }
  window_->setLanguage(QStringLiteral("en"));
}

void TranslationTest::anErrorIsTranslatedButNotItsFileAndField() {
  useLanguage(QStringLiteral("es"));
  // The Spanish catalog's phrase of UnknownKey.
  QCOMPARE(errorText({ErrorCode::UnknownKey, "a.toml", "flavor", "line 3"}),
           QStringLiteral("a.toml: flavor: clave desconocida (line 3)"));
}

DEWPOINT_WINDOW_TEST(TranslationTest)

} // namespace dewpoint::tests

#include "translation_test.moc"
