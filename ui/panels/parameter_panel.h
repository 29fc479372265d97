// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

#include <set>
#include <utility>
#include <vector>

class QPushButton;
class QVBoxLayout;

namespace dewpoint::tracking {
enum class ParameterGroup;
struct ParameterDeclaration;
} // namespace dewpoint::tracking

namespace dewpoint::ui {

class CollapsibleSection;
class Document;
class MethodChoice;
class ParameterRow;

/// Panel for the method and its parameters. Each parameter has a slider and a number field,
/// generated from its declaration. The essential parameters come first; the others are in sections
/// by group. All changes are made through the document, so they can be undone.
class ParameterPanel : public QWidget {
  Q_OBJECT
public:
  explicit ParameterPanel(Document& document, QWidget* parent = nullptr);

private:
  void rebuild();
  void addMethodChoice();
  void addEssentialRows();
  void addSections();
  void addVolume();
  ParameterRow* makeRow(const ParameterDeclaration& declaration);
  /// Adds a section, open or closed as the user last left it.
  CollapsibleSection* addSection(const QString& name, const QString& title);
  void showValue(const QString& key);
  /// Marks values that differ from their defaults, and values that limit each other.
  void showMarks();
  ParameterRow* rowOf(const std::string& key) const;

  Document& document_;
  QWidget* form_ = nullptr;
  QVBoxLayout* column_ = nullptr; ///< form layout
  MethodChoice* methods_ = nullptr;
  QPushButton* resetAll_ = nullptr;
  std::vector<ParameterRow*> rows_;
  std::vector<std::pair<ParameterGroup, CollapsibleSection*>> sections_;
  std::set<QString> open_; ///< names of the sections that the user opened
};

} // namespace dewpoint::ui
