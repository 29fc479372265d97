// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/error_sentence.h"

#include "core/base/error.h"
#include "core/base/one_line.h"

#include <QCoreApplication>

namespace dewpoint::ui {

QString errorText(const Error& error) {
  QString text;
  if (!error.file.empty()) {
    text += QString::fromStdString(toSingleLine(error.file)) + QStringLiteral(": ");
  }
  if (!error.field.empty()) {
    text += QString::fromStdString(toSingleLine(error.field)) + QStringLiteral(": ");
  }
  text += QCoreApplication::translate("Error", errorPhrase(error.code));
  if (!error.detail.empty()) {
    text += QStringLiteral(" (%1)").arg(QString::fromStdString(toSingleLine(error.detail)));
  }
  return text;
}

} // namespace dewpoint::ui
