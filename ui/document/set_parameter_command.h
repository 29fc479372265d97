// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>

#include <string>

namespace dewpoint {

class Document;

/// Sets one parameter; successive changes of the same one become a single step.
class SetParameterCommand : public QUndoCommand {
public:
  SetParameterCommand(Document& document, std::string key, double value);

  void undo() override { swap(); }
  void redo() override { swap(); }
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* other) override;

private:
  void swap();

  Document& document_;
  std::string key_;
  double other_; ///< the value that is not in the document at the moment
  double redone_;
};

} // namespace dewpoint
