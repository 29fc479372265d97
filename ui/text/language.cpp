// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <QWidget>

#include <memory>
#include <utility>
#include <vector>

namespace dewpoint::ui {

namespace {

constexpr QLatin1String kFolder(":/translations");
constexpr QLatin1String kPrefix("dewpoint_");

QLocale localeOf(const QString& language) {
  const QLocale system = QLocale::system();
  const QLocale wanted(language);
  // Someone in Austria who asks for German gets Austrian German.
  return language.isEmpty() || wanted.language() == system.language() ? system : wanted;
}

/// The catalogs in use; another language takes their place.
std::vector<QTranslator*>& installed() {
  static std::vector<QTranslator*> translators; // owned by the application
  return translators;
}

/// Installs a catalog if there is one for the locale.
bool install(const QLocale& locale, const QString& name, const QString& folder) {
  auto translator = std::make_unique<QTranslator>(QCoreApplication::instance());
  if (!translator->load(locale, name, QString(), folder)) {
    return false;
  }
  installed().push_back(translator.get());
  return QCoreApplication::installTranslator(translator.release());
}

} // namespace

QStringList availableLanguages() {
  QStringList names;
  for (const QString& file : QDir(kFolder).entryList({kPrefix + QLatin1String("*.qm")})) {
    names.append(file.sliced(kPrefix.size()).chopped(3));
  }
  return names;
}

QString currentLanguageTag() {
  const QString language =
      installed().empty() ? QString() : installed().back()->language(); // Qt's own come first
  return language.isEmpty() ? QStringLiteral("en") : QLocale(language).bcp47Name();
}

void useLanguage(const QString& language) {
  const QLocale locale = localeOf(language);
  for (QTranslator* translator : std::exchange(installed(), {})) {
    delete translator; // takes itself out
  }
  QLocale::setDefault(locale);
  // Windows that are there already keep the numbers of the language they were made in.
  for (QWidget* window : QApplication::topLevelWidgets()) {
    window->setLocale(locale);
  }
  // Qt's own first: what is installed last is asked first.
  install(locale, QStringLiteral("qtbase_"), QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  if (!install(locale, kPrefix, kFolder)) {
    install(QLocale(QLocale::English), kPrefix, kFolder);
  }
}

} // namespace dewpoint::ui
