// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/set_method_command.h"

#include "core/project/project.h"
#include "ui/document/document.h"

#include <QCoreApplication>

#include <utility>

namespace dewpoint {

SetMethodCommand::SetMethodCommand(Document& document, std::string method,
                                   ParameterValues parameters)
    : document_(document), otherMethod_(std::move(method)),
      otherParameters_(std::move(parameters)) {
  setText(QCoreApplication::translate("SetMethodCommand", "Track by “%1”")
              .arg(QCoreApplication::translate("Method", otherMethod_.c_str())));
}

void SetMethodCommand::swap() {
  std::string method = document_.project().method;
  ParameterValues parameters = document_.project().parameters;
  document_.assignMethod(otherMethod_, otherParameters_);
  otherMethod_ = std::move(method);
  otherParameters_ = std::move(parameters);
}

} // namespace dewpoint
