// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_command.h"

#include "core/project/project_changes.h"
#include "ui/document/document.h"

namespace dewpoint::ui {

EditCommand::EditCommand(Document& document, const QString& name, State before, State after,
                         std::string mergeKey)
    : QUndoCommand(name), document_(document), before_(std::move(before)), after_(std::move(after)),
      mergeKey_(std::move(mergeKey)) {}

void EditCommand::undo() {
  document_.assign(before_);
}

void EditCommand::redo() {
  document_.assign(after_);
}

bool EditCommand::mergeWith(const QUndoCommand* other) {
  const auto* next = dynamic_cast<const EditCommand*>(other);
  if (next == nullptr || next->mergeKey_ != mergeKey_) {
    return false;
  }
  after_ = next->after_;
  setText(next->text()); // it may say how much all of them are together
  setObsolete(!changesBetween(*before_, *after_).hasAny()); // dragged there and back
  return true;
}

} // namespace dewpoint::ui
