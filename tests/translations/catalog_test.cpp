// SPDX-License-Identifier: GPL-3.0-or-later
// Every catalog holds exactly the texts of the sources, all of them translated. The texts are found
// by lupdate itself, run as script/translate runs it, on copies of the catalogs.
#include "core/base/floors.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

using Key = std::pair<QString, QString>; ///< context, text

struct Entry {
  QStringList translations; ///< several where the text depends on a number
  bool finished = true;
};

using Catalog = std::map<Key, Entry>;

const QString kFolder = QStringLiteral(DEWPOINT_SOURCE_DIR "/translations");

QStringList catalogNames() {
  return QDir(kFolder).entryList({QStringLiteral("dewpoint_*.ts")});
}

Catalog readCatalog(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
  QXmlStreamReader xml(&file);
  Catalog catalog;
  QString context;
  QString source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) {
      continue;
    }
    if (xml.name() == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (xml.name() == QLatin1String("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      Entry entry;
      entry.finished = xml.attributes().value(QLatin1String("type")).isEmpty();
      const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
      entry.translations = text.split(QLatin1Char('\n'));
      // Plural forms stand on lines of their own, between lines of nothing but spaces.
      if (text.startsWith(QLatin1Char('\n'))) {
        entry.translations.removeIf([](const QString& line) { return line.trimmed().isEmpty(); });
      } else {
        entry.translations = QStringList{text};
      }
      catalog[{context, source}] = entry;
    }
  }
  EXPECT_FALSE(xml.hasError()) << qPrintable(path) << qPrintable(xml.errorString());
  return catalog;
}

std::string describe(const QString& name, const Key& key) {
  return (name + QStringLiteral(", context ") + key.first + QStringLiteral(": \"") + key.second +
          QStringLiteral("\"; script/translate brings the catalogs up to date"))
      .toStdString();
}

std::multiset<QString> placeholders(const QString& text) {
  static const QRegularExpression kPlaceholder(
      QStringLiteral("%(n|L?[0-9]+)|\\[\\*\\]|\\*\\.\\w+"));
  std::multiset<QString> found;
  for (auto match = kPlaceholder.globalMatch(text); match.hasNext();) {
    found.insert(match.next().captured());
  }
  return found;
}

TEST(Catalogs, ThereIsOneForEachLanguage) {
  for (const char* language : {"de", "en", "es", "ja"}) { // the languages of the window
    EXPECT_TRUE(catalogNames().contains(QStringLiteral("dewpoint_%1.ts").arg(language)))
        << language;
  }
}

TEST(Catalogs, HoldEveryTextOfTheSourcesAndNoOther) {
  const QTemporaryDir scratch;
  ASSERT_TRUE(scratch.isValid());
  for (const QString& name : catalogNames()) {
    ASSERT_TRUE(QFile::copy(QDir(kFolder).filePath(name), scratch.filePath(name)));
  }
  const int code = QProcess::execute(
      QStringLiteral("bash"),
      {QDir(kFolder).filePath(QStringLiteral("update.sh")), QStringLiteral(DEWPOINT_LUPDATE),
       QStringLiteral(DEWPOINT_STRINGS), QStringLiteral(DEWPOINT_SOURCE_DIR), scratch.path()});
  ASSERT_EQ(code, 0) << "translations/update.sh failed";
  for (const QString& name : catalogNames()) {
    const Catalog kept = readCatalog(QDir(kFolder).filePath(name));
    const Catalog current = readCatalog(scratch.filePath(name));
    EXPECT_FALSE(current.empty()) << qPrintable(name);
    for (const auto& [key, entry] : current) {
      EXPECT_TRUE(kept.contains(key)) << "missing in " << describe(name, key);
    }
    for (const auto& [key, entry] : kept) {
      EXPECT_TRUE(current.contains(key)) << "no longer used: " << describe(name, key);
    }
  }
}

TEST(Catalogs, NothingIsUnfinished) {
  for (const QString& name : catalogNames()) {
    for (const auto& [key, entry] : readCatalog(QDir(kFolder).filePath(name))) {
      EXPECT_TRUE(entry.finished) << "unfinished in " << describe(name, key);
      for (const QString& text : entry.translations) {
        EXPECT_FALSE(text.trimmed().isEmpty()) << "empty in " << describe(name, key);
      }
    }
  }
}

TEST(Catalogs, TranslationsKeepPlaceholdersPatternsAndEllipses) {
  for (const QString& name : catalogNames()) {
    for (const auto& [key, entry] : readCatalog(QDir(kFolder).filePath(name))) {
      for (const QString& text : entry.translations) {
        EXPECT_EQ(placeholders(text), placeholders(key.second)) << describe(name, key);
        EXPECT_EQ(text.endsWith(QChar(0x2026)), key.second.endsWith(QChar(0x2026)))
            << describe(name, key);
      }
    }
  }
}

/// Two menus of one bar with the same letter would need a second press of it.
TEST(Catalogs, MenusHaveLettersOfTheirOwn) {
  for (const QString& name : catalogNames()) {
    std::set<QChar> letters;
    for (const auto& [key, entry] : readCatalog(QDir(kFolder).filePath(name))) {
      if (!key.second.contains(QLatin1Char('&'))) {
        continue;
      }
      const QString& text = entry.translations.front();
      const auto at = text.indexOf(QLatin1Char('&'));
      ASSERT_TRUE(at >= 0 && at + 1 < text.size()) << describe(name, key);
      EXPECT_TRUE(letters.insert(text.at(at + 1).toUpper()).second) << describe(name, key);
    }
  }
}

} // namespace
} // namespace dewpoint::tests
