// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/calibration_files.h"

#include "core/calibration/formats/format_catalog.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <set>

namespace dewpoint::ui {

namespace {

class SizeFitText {
  Q_DECLARE_TR_FUNCTIONS(SizeFitText)
};

/// The endings of a format, with their dots: YAML has two.
QStringList endingsOf(const CalibrationFormat& format) {
  const QString ending = QLatin1String(format.extension);
  QStringList endings = ending == QLatin1String(".yaml") || ending == QLatin1String(".yml")
                            ? QStringList{QStringLiteral(".yaml"), QStringLiteral(".yml")}
                            : QStringList{ending};
  for (const char* other : format.otherExtensions) {
    endings << QLatin1String(other);
  }
  return endings;
}

QString patterns(const QStringList& endings) {
  QStringList patterns;
  std::ranges::transform(endings, std::back_inserter(patterns),
                         [](const QString& ending) { return QLatin1Char('*') + ending; });
  return patterns.join(QLatin1Char(' '));
}

} // namespace

QString calibrationFileFilter() {
  std::set<QString> all;
  QStringList rows;
  for (const CalibrationFormat& format : calibrationFormats()) {
    const QStringList endings = endingsOf(format);
    all.insert(endings.begin(), endings.end());
    rows << QStringLiteral("%1 (%2)").arg(QString::fromUtf8(format.title), patterns(endings));
  }
  rows.prepend(QCoreApplication::translate("CalibrationFiles", "Calibrations (%1)")
                   .arg(patterns(QStringList(all.begin(), all.end()))));
  rows << QCoreApplication::translate("CalibrationFiles", "All files (*)");
  return rows.join(QStringLiteral(";;"));
}

QString calibrationFormatTitles() {
  QStringList titles;
  for (const CalibrationFormat& format : calibrationFormats()) {
    titles << QString::fromUtf8(format.title);
  }
  return titles.join(QStringLiteral(", "));
}

bool hasCalibrationSuffix(const QString& file) {
  return std::ranges::any_of(calibrationFormats(), [&](const CalibrationFormat& format) {
    return std::ranges::any_of(endingsOf(format), [&](const QString& ending) {
      return file.endsWith(ending, Qt::CaseInsensitive);
    });
  });
}

std::vector<std::pair<QString, QVariant>> sizeFitChoices() {
  return {{SizeFitText::tr("same as during calibration"), {}},
          {SizeFitText::tr("cropped on all sides"), QStringLiteral("crop")},
          {SizeFitText::tr("cropped at the right and at the bottom"), QStringLiteral("trim")},
          {SizeFitText::tr("scaled"), QStringLiteral("scale")},
          {SizeFitText::tr("rotated clockwise by 90°"), QStringLiteral("rotate-90")},
          {SizeFitText::tr("rotated clockwise by 270°"), QStringLiteral("rotate-270")}};
}

} // namespace dewpoint::ui
