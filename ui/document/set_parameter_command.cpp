// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/set_parameter_command.h"

#include "core/project/project.h"
#include "ui/document/document.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace dewpoint {

namespace {

QString labelOf(const Project& project, const std::string& key) {
  const auto all = project.parameters.declarations();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& d) { return d.key == key; });
  const std::string& text = found == all.end() ? key : found->label;
  return QCoreApplication::translate("Parameter", text.c_str());
}

} // namespace

SetParameterCommand::SetParameterCommand(Document& document, std::string key, double value)
    : document_(document), key_(std::move(key)), other_(value), redone_(value) {
  setText(QCoreApplication::translate("SetParameterCommand", "Change “%1”")
              .arg(labelOf(document.project(), key_)));
}

bool SetParameterCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const SetParameterCommand*>(other);
  if (next == nullptr || next->key_ != key_) {
    return false;
  }
  redone_ = next->redone_; // `other_` stays: the value before the first of them
  setObsolete(redone_ == other_);
  return true;
}

void SetParameterCommand::swap() {
  const double before = document_.project().parameters.at(key_);
  document_.assignParameter(key_, other_);
  other_ = before;
}

} // namespace dewpoint
