// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/finding_text.h"

#include "core/setup/doctor/finding.h"

#include <QCoreApplication>

#include <string_view>
#include <vector>

namespace dewpoint::ui {

namespace {

QString translated(std::string_view words, const std::vector<std::string>& values) {
  if (words.empty()) {
    return {};
  }
  const QString text = QCoreApplication::translate("Finding", std::string(words).c_str());
  return QString::fromStdString(fillPlaceholders(text.toStdString(), values));
}

} // namespace

QString findingText(const Finding& finding) {
  return translated(textsOf(finding.kind).what, finding.values);
}

QString findingAdvice(const Finding& finding) {
  return translated(textsOf(finding.kind).advice, finding.values);
}

QString findingPlace(const Finding& finding) {
  const QString file = QString::fromStdString(finding.file);
  const QString field = QString::fromStdString(finding.field);
  return file.isEmpty() || field.isEmpty() ? file + field : file + QStringLiteral(": ") + field;
}

} // namespace dewpoint::ui
