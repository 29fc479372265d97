// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_form.h"

#include "core/calibration/board/board_edit.h"
#include "core/calibration/board/board_print.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <array>

namespace dewpoint::ui {
namespace {

struct Unit {
  const char* name;
  double meters;
  NumberRange range;
};
const std::array<Unit, 4> kUnits{{{"mm", 0.001, {1.0, 2000.0, 1.0, 2}},
                                  {"cm", 0.01, {0.1, 200.0, 0.1, 3}},
                                  {"m", 1.0, {0.001, 2.0, 0.001, 5}},
                                  {"in", 0.0254, {0.04, 80.0, 0.05, 4}}}};

QSpinBox* makeCount(const char* name, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setObjectName(QLatin1String(name));
  box->setRange(3, 60);
  box->setKeyboardTracking(false);
  return box;
}

} // namespace

BoardForm::BoardForm(BoardCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator) {
  setObjectName(QStringLiteral("boardFields"));
  createWidgets();
  connectFields();
  onRetranslate(this, [this] { retranslateUi(); });
}

void BoardForm::createWidgets() {
  const auto combo = [this](const char* name) {
    auto* box = new QComboBox(this);
    box->setObjectName(QLatin1String(name));
    makeNarrow(*box);
    return box;
  };
  kindLabel_ = new QLabel(this);
  kind_ = combo("boardKind");
  squaresLabel_ = new QLabel(this);
  columns_ = makeCount("boardColumns", this);
  rows_ = makeCount("boardRows", this);
  sizeLabel_ = new QLabel(this);
  size_ = makeNumberField(QStringLiteral("boardSquareSize"), kUnits[0].range, this);
  unit_ = combo("boardUnit");
  for (const Unit& unit : kUnits) {
    unit_->addItem(QLatin1String(unit.name));
  }
  markerLabel_ = new QLabel(this);
  marker_ = makeNumberField(QStringLiteral("boardMarkerSize"), kUnits[0].range, this);
  dictionaryLabel_ = new QLabel(this);
  dictionary_ = combo("boardDictionary");
  dictionary_->setMinimumContentsLength(15); // DICT_4X4_1000 must not look like DICT_4X4_100
  for (const std::string& name : markerDictionaries()) {
    dictionary_->addItem(QString::fromStdString(name));
  }
  legacy_ = new QCheckBox(this);
  legacy_->setObjectName(QStringLiteral("boardLegacy"));
  inverted_ = new QCheckBox(this);
  inverted_->setObjectName(QStringLiteral("boardInverted"));
  summary_ = new QLabel(this);
  summary_->setObjectName(QStringLiteral("boardSummary"));
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  summary_->setWordWrap(true);
  print_ = new QPushButton(this);
  print_->setObjectName(QStringLiteral("boardPrint"));
  paper_ = combo("boardPaper");
  for (const Paper& paper : papers()) {
    paper_->addItem(QString::fromStdString(paper.name));
  }
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  for (int column = 0; column < 3; ++column) {
    grid->setColumnStretch(column, 1);
  }
  grid->addWidget(kindLabel_, 0, 0);
  grid->addWidget(kind_, 0, 1, 1, 2);
  grid->addWidget(squaresLabel_, 1, 0);
  grid->addWidget(columns_, 1, 1);
  grid->addWidget(rows_, 1, 2);
  grid->addWidget(sizeLabel_, 2, 0);
  grid->addWidget(size_, 2, 1);
  grid->addWidget(unit_, 2, 2);
  grid->addWidget(markerLabel_, 3, 0);
  grid->addWidget(marker_, 3, 1);
  grid->addWidget(dictionaryLabel_, 4, 0);
  grid->addWidget(dictionary_, 4, 1, 1, 2);
  grid->addWidget(legacy_, 5, 0, 1, 3);
  grid->addWidget(inverted_, 6, 0, 1, 3);
  grid->addWidget(summary_, 7, 0, 1, 3);
  grid->addWidget(print_, 8, 0, 1, 2);
  grid->addWidget(paper_, 8, 2);
  kindLabel_->setBuddy(kind_);
  squaresLabel_->setBuddy(columns_);
  sizeLabel_->setBuddy(size_);
  markerLabel_->setBuddy(marker_);
  dictionaryLabel_->setBuddy(dictionary_);
}

double BoardForm::metersPerUnit() const {
  return kUnits.at(static_cast<std::size_t>(std::max(0, unit_->currentIndex()))).meters;
}

void BoardForm::connectFields() {
  using Board = BoardDescription;
  connect(&calibrator_, &BoardCalibrator::guideRequestChanged, this, &BoardForm::refresh);
  connect(kind_, &QComboBox::activated, this, [this](int index) {
    edit([index](Board& board) { board = withKind(board, static_cast<Board::Kind>(index)); });
  });
  connect(columns_, &QSpinBox::valueChanged, this, [this](int value) {
    edit([value](Board& board) { board = withSquares(board, value, board.squareRows()); });
  });
  connect(rows_, &QSpinBox::valueChanged, this, [this](int value) {
    edit([value](Board& board) { board = withSquares(board, board.squareColumns(), value); });
  });
  connect(size_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([meters = value * metersPerUnit()](Board& board) {
      board = withSquareSize(board, meters);
    });
  });
  connect(marker_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    edit([meters = value * metersPerUnit()](Board& board) {
      board = withMarkerSize(board, meters);
    });
  });
  connect(unit_, &QComboBox::activated, this, &BoardForm::refresh);
  connect(dictionary_, &QComboBox::textActivated, this, [this](const QString& name) {
    edit([&](Board& board) { board.dictionary = name.toStdString(); });
  });
  connect(legacy_, &QCheckBox::clicked, this,
          [this](bool on) { edit([on](Board& board) { board.usesLegacyLayout = on; }); });
  connect(inverted_, &QCheckBox::clicked, this,
          [this](bool on) { edit([on](Board& board) { board.isInverted = on; }); });
  connect(print_, &QPushButton::clicked, this, &BoardForm::print);
}

void BoardForm::edit(const std::function<void(BoardDescription&)>& change) {
  BoardGuideRequest request = calibrator_.guideRequest();
  BoardDescription board = request.board.board;
  change(board);
  const Status checked = checkBoard(board);
  if (checked) {
    request.board.board = board;
    calibrator_.setGuideRequest(request);
  }
  refresh(); // also when it was refused
  if (!checked) {
    summary_->setText(QStringLiteral("⚠ ") + QString::fromStdString(checked.error().detail));
  }
}

void BoardForm::print() {
  const QString chosen = QFileDialog::getSaveFileName(
      this, tr("Print the board"), QStringLiteral("board.pdf"), tr("PDF (*.pdf)"));
  if (!chosen.isEmpty()) {
    calibrator_.printBoard(paper_->currentText(), chosen);
  }
}

void BoardForm::retranslateUi() {
  const auto name = [](QWidget* field, const QString& text, const QString& tip) {
    field->setAccessibleName(text);
    field->setToolTip(tip);
  };
  kindLabel_->setText(tr("Kind"));
  {
    const QSignalBlocker quiet(kind_);
    kind_->clear();
    kind_->addItems({tr("Chessboard"), tr("ChArUco (with markers)")});
  }
  name(kind_, tr("Kind of board"),
       tr("A ChArUco board may be partly hidden, or partly outside the image; a chessboard must be "
          "completely visible"));
  squaresLabel_->setText(tr("Squares per row and column"));
  name(columns_, tr("Squares in a row"),
       tr("Number of squares in a row, black and white together"));
  name(rows_, tr("Squares in a column"),
       tr("Number of squares in a column, black and white together"));
  sizeLabel_->setText(tr("Side of a square"));
  name(size_, tr("Side of a square"),
       tr("Measure a long row on the print with a ruler, and divide its length by the number of "
          "its squares"));
  name(unit_, tr("Unit of the sizes"), tr("Unit of the sizes that you enter"));
  markerLabel_->setText(tr("Side of a marker"));
  name(marker_, tr("Side of a marker"),
       tr("Length of one side of a marker, with its black border"));
  dictionaryLabel_->setText(tr("Dictionary"));
  name(dictionary_, tr("Dictionary of the markers"),
       tr("The marker dictionary that was chosen when the board was made"));
  legacy_->setText(tr("Legacy ChArUco layout"));
  legacy_->setToolTip(tr("For ChArUco boards with an even number of rows that were made with "
                         "software older than OpenCV 4.6: their first square is white"));
  inverted_->setText(tr("Inverted colors"));
  inverted_->setToolTip(tr("White markers and corners on a black page"));
  print_->setText(tr("Print this board…"));
  print_->setToolTip(
      tr("Save the board as a PDF at its true size, with a scale bar to check with a ruler"));
  name(paper_, tr("Paper"), tr("Size of the paper. A larger board is split over several sheets"));
  refresh();
}

void BoardForm::refresh() {
  const BoardDescription& board = calibrator_.guideRequest().board.board;
  const bool markers = board.kind == BoardDescription::Kind::Charuco;
  const auto count = [](QSpinBox* box, int value) {
    const QSignalBlocker quiet(box);
    box->setValue(value);
  };
  kind_->setCurrentIndex(static_cast<int>(board.kind));
  count(columns_, board.squareColumns());
  count(rows_, board.squareRows());
  const Unit& unit = kUnits.at(static_cast<std::size_t>(std::max(0, unit_->currentIndex())));
  const QString suffix = QLatin1Char(' ') + QLatin1String(unit.name);
  setRange(*size_, unit.range, suffix);
  setRange(*marker_, unit.range, suffix);
  showValue(*size_, board.squareSize / unit.meters);
  showValue(*marker_, board.markerSize / unit.meters);
  dictionary_->setCurrentText(QString::fromStdString(board.dictionary));
  for (QWidget* field : std::initializer_list<QWidget*>{markerLabel_, marker_, dictionaryLabel_,
                                                        dictionary_, legacy_, inverted_}) {
    field->setVisible(markers);
  }
  legacy_->setEnabled(board.rows % 2 == 0);
  legacy_->setChecked(board.usesLegacyLayout);
  inverted_->setChecked(board.isInverted);
  summary_->setText(
      tr("%1 × %2 inner corners. Description for the command line:")
          .arg(QString::number(board.cornerColumns()), QString::number(board.cornerRows())) +
      QLatin1Char('\n') + QString::fromStdString(boardText(board)));
}

} // namespace dewpoint::ui
