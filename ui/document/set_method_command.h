// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/parameters.h"

#include <QUndoCommand>

#include <string>

namespace dewpoint {

class Document;

/// Chooses the tracking method; its parameters come and go with it.
class SetMethodCommand : public QUndoCommand {
public:
  SetMethodCommand(Document& document, std::string method, ParameterValues parameters);

  void undo() override { swap(); }
  void redo() override { swap(); }

private:
  void swap();

  Document& document_;
  std::string otherMethod_; ///< what is not in the document at the moment
  ParameterValues otherParameters_;
};

} // namespace dewpoint
