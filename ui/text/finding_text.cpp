// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/finding_text.h"

#include "core/setup/doctor/finding.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::ui {

namespace {

/// The checks call a camera "camera 'left'".
std::string cameraTranslated(const std::string& value) {
  constexpr std::string_view kBefore = "camera '";
  if (!value.starts_with(kBefore) || !value.ends_with('\'')) {
    return value;
  }
  const std::string name = value.substr(kBefore.size(), value.size() - kBefore.size() - 1);
  return QCoreApplication::translate("FindingText", "camera “%1”")
      .arg(QString::fromStdString(name))
      .toStdString();
}

QString translated(std::string_view words, const std::vector<std::string>& values) {
  if (words.empty()) {
    return {};
  }
  const QString text = QCoreApplication::translate("Finding", std::string(words).c_str());
  std::vector<std::string> shown;
  std::ranges::transform(values, std::back_inserter(shown), cameraTranslated);
  return QString::fromStdString(fillPlaceholders(text.toStdString(), shown));
}

} // namespace

QString findingText(const Finding& finding) {
  return translated(textsOf(finding.kind).description, finding.placeholderValues);
}

QString findingAdvice(const Finding& finding) {
  return translated(textsOf(finding.kind).advice, finding.placeholderValues);
}

QString findingLocationText(const Finding& finding) {
  const QString file = QString::fromStdString(finding.file);
  const QString field = QString::fromStdString(finding.field);
  return file.isEmpty() || field.isEmpty() ? file + field : file + QStringLiteral(": ") + field;
}

} // namespace dewpoint::ui
