// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.h"

#include "core/project/project.h"
#include "ui/document/set_method_command.h"
#include "ui/document/set_parameter_command.h"

#include <QUndoStack>

namespace dewpoint {

Document::Document(QObject* parent)
    : QObject(parent), project_(std::make_unique<Project>()), undoStack_(new QUndoStack(this)) {}

Document::~Document() {
  undoStack_->clear(); // commands refer to this document
}

void Document::replace(Project project) {
  undoStack_->clear();
  *project_ = std::move(project);
  Q_EMIT replaced();
}

Status Document::setParameter(const std::string& key, double value) {
  ParameterValues trial = project_->parameters;
  if (auto status = trial.set(key, value); !status) {
    return status;
  }
  if (trial.at(key) != project_->parameters.at(key)) {
    undoStack_->push(new SetParameterCommand(*this, key, trial.at(key)));
  }
  return {};
}

void Document::assignParameter(const std::string& key, double value) {
  if (project_->parameters.set(key, value)) {
    Q_EMIT parameterChanged(QString::fromStdString(key));
  }
}

void Document::setMethod(const std::string& method) {
  if (method != project_->method && !methodParameters(method).empty()) {
    undoStack_->push(
        new SetMethodCommand(*this, method, carriedOver(project_->parameters, method)));
  }
}

void Document::assignMethod(const std::string& method, const ParameterValues& parameters) {
  project_->method = method;
  project_->parameters = parameters;
  Q_EMIT methodChanged();
}

Status Document::save() {
  return saveAs(project_->file);
}

Status Document::saveAs(const std::filesystem::path& file) {
  if (auto status = saveProject(*project_, file); !status) {
    return status;
  }
  project_->file = file;
  undoStack_->setClean();
  Q_EMIT fileChanged();
  return {};
}

} // namespace dewpoint
