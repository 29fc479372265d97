// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QUndoCommand>

#include <memory>
#include <string>

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class Document;

/// Undoable step that replaces one state of the project by another. States are immutable and shared
/// between neighboring steps.
class EditCommand : public QUndoCommand {
public:
  using State = std::shared_ptr<const Project>;
  /// Creates a step. Successive steps with the same nonempty key are merged and take the name of
  /// the last one.
  EditCommand(Document& document, const QString& name, State before, State after,
              std::string mergeKey);

  void undo() override;
  void redo() override;
  int id() const override { return mergeKey_.empty() ? -1 : 1; }
  const std::string& mergeKey() const { return mergeKey_; }
  bool mergeWith(const QUndoCommand* other) override;

private:
  Document& document_;
  State before_;
  State after_;
  std::string mergeKey_;
};

} // namespace dewpoint::ui
