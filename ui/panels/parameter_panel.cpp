// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parameter_panel.h"

#include "core/project/project.h"
#include "core/tracking/catalog/method_catalog.h"
#include "ui/document/document.h"
#include "ui/document/method_presentation.h"
#include "ui/panels/parameter_row.h"
#include "ui/panels/volume_form.h"
#include "ui/text/retranslation.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QVBoxLayout>

namespace dewpoint::ui {

ParameterPanel::ParameterPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document) {
  setObjectName(QStringLiteral("parameterPanel"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  connect(&document_, &Document::replaced, this, &ParameterPanel::rebuild);
  connect(&document_, &Document::methodChanged, this, &ParameterPanel::rebuild,
          Qt::QueuedConnection); // its own choice may be what changed it
  connect(&document_, &Document::parameterChanged, this, &ParameterPanel::showValue);
  onRetranslate(this, [this] { rebuild(); });
}

void ParameterPanel::rebuild() {
  delete form_;
  rows_.clear();
  form_ = new QWidget(this);
  form_->setObjectName(QStringLiteral("parameterForm"));
  auto* layout = new QVBoxLayout(form_);
  layout->setContentsMargins(12, 8, 12, 8);
  layout->setSpacing(16);
  const Project& project = document_.project();
  if (project.parameters.declarations().empty()) {
    auto* empty = new QLabel(tr("The parameters appear here once a project is open."), form_);
    empty->setWordWrap(true);
    layout->addWidget(empty);
  } else {
    addMethodChoice();
    if (document_.presentation().searchesRoom) {
      layout->addWidget(new VolumeForm(document_, form_));
    }
  }
  for (const ParameterDeclaration& declaration : project.parameters.declarations()) {
    auto* row = new ParameterRow(declaration, form_);
    row->setValue(document_.usedParameters().at(declaration.key));
    connect(row, &ParameterRow::valueEdited, this, [this, key = declaration.key](double value) {
      if (!document_.setParameter(key, value)) {
        showValue(QString::fromStdString(key)); // refused: show what holds
      }
    });
    layout->addWidget(row);
    rows_.push_back(row);
  }
  layout->addStretch();
  this->layout()->addWidget(form_);
}

void ParameterPanel::addMethodChoice() {
  auto* label = new QLabel(tr("&Method"), form_);
  auto* choice = new QComboBox(form_);
  choice->setObjectName(QStringLiteral("methodChoice"));
  label->setBuddy(choice);
  choice->setToolTip(
      tr("How the targets are tracked. Another method begins anew; the rest stays."));
  for (const std::string& name : methodNames()) {
    // A name as in files and on the command line, in no language.
    choice->addItem(QString::fromStdString(name), QString::fromStdString(name));
  }
  choice->setCurrentIndex(choice->findData(QString::fromStdString(document_.project().method)));
  connect(choice, &QComboBox::activated, this, [this, choice](int index) {
    document_.setMethod(choice->itemData(index).toString().toStdString());
  });
  form_->layout()->addWidget(label);
  form_->layout()->addWidget(choice);
  auto* sentence = new QLabel(form_);
  sentence->setObjectName(QStringLiteral("methodSentence"));
  sentence->setWordWrap(true);
  sentence->setForegroundRole(QPalette::PlaceholderText);
  const std::string text(methodSentence(document_.project().method));
  sentence->setText(QCoreApplication::translate("Method", text.c_str()));
  form_->layout()->addWidget(sentence);
}

void ParameterPanel::showValue(const QString& key) {
  for (ParameterRow* row : rows_) {
    if (row->key() == key.toStdString()) {
      row->setValue(document_.usedParameters().at(row->key()));
    }
  }
}

} // namespace dewpoint::ui
