// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_print.h"

#include "core/base/lower_case.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/calibration/board/board_picture.h"
#include "core/calibration/board/board_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hpdf.h>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

namespace dewpoint::calibration {
namespace {

constexpr double kPointsPerMillimeter = 72.0 / 25.4;
constexpr double kMarginMm = 8.0; // that printers leave white
constexpr double kFootMm = 16.0;  // for the scale bar and the text
constexpr double kTextMm = 3.2;
constexpr double kScaleBarMm = 100.0;

/// Placing of the board on the page, millimeters.
struct Layout {
  double pageWidth = 0.0;
  double pageHeight = 0.0;
  double left = 0.0; ///< of the squares
  double top = 0.0;
};

struct FreeDocument {
  void operator()(HPDF_Doc document) const { HPDF_Free(document); }
};
using Document = std::unique_ptr<std::remove_pointer_t<HPDF_Doc>, FreeDocument>;

[[noreturn]] void onError(HPDF_STATUS error, HPDF_STATUS detail, void*) {
  throw std::runtime_error(fmt::format("libharu error {:#x}, {}", error, detail));
}

/// The layout on one page; nothing if the board does not fit.
std::optional<Layout> layoutOf(const BoardDescription& board, const Paper& paper) {
  const double squares[] = {static_cast<double>(board.squareColumns()),
                            static_cast<double>(board.squareRows())};
  const double size = inMillimeters(board.squareSize);
  for (const bool lengthwise : {squares[0] > squares[1], squares[0] <= squares[1]}) {
    Layout layout;
    layout.pageWidth = lengthwise ? paper.height : paper.width;
    layout.pageHeight = lengthwise ? paper.width : paper.height;
    const double room[] = {layout.pageWidth - 2.0 * kMarginMm,
                           layout.pageHeight - 2.0 * kMarginMm - kFootMm};
    if (size * squares[0] <= room[0] && size * squares[1] <= room[1]) {
      layout.left = 0.5 * (layout.pageWidth - size * squares[0]);
      layout.top = kMarginMm + 0.5 * (room[1] - size * squares[1]);
      return layout;
    }
  }
  return std::nullopt;
}

/// What is printed around the squares of an inverted board; other boards have white paper there.
double borderOf(const BoardDescription& board) {
  return board.isInverted ? std::min(kMarginMm, inMillimeters(0.5 * board.squareSize)) : 0.0;
}

/// Everything dark, millimeters from the upper left corner of the squares.
std::vector<BoardPattern::Rectangle> darkParts(const BoardDescription& board) {
  const double width = inMillimeters(board.squareSize) * board.squareColumns();
  const double height = inMillimeters(board.squareSize) * board.squareRows();
  std::vector<BoardPattern::Rectangle> parts;
  if (const double border = borderOf(board); border > 0.0) {
    parts.push_back({-border, -border, width + 2.0 * border, border});
    parts.push_back({-border, height, width + 2.0 * border, border});
    parts.push_back({-border, 0.0, border, height});
    parts.push_back({width, 0.0, border, height});
  }
  for (const auto& dark : BoardPattern(board).darkRectangles()) {
    parts.push_back({inMillimeters(dark.left), inMillimeters(dark.top), inMillimeters(dark.width),
                     inMillimeters(dark.height)});
  }
  return parts;
}

/// Draws in millimeters from the upper left corner of the page.
class Pen {
public:
  Pen(HPDF_Page page, HPDF_Font font)
      : page_(page), font_(font), height_(HPDF_Page_GetHeight(page)) {}

  void rectangle(double left, double top, double width, double height) {
    HPDF_Page_Rectangle(page_, points(left), height_ - points(top + height), points(width),
                        points(height));
  }
  void fill() { HPDF_Page_Fill(page_); }
  void text(double left, double baseline, const std::string& words) {
    HPDF_Page_BeginText(page_);
    HPDF_Page_SetFontAndSize(page_, font_, points(kTextMm));
    HPDF_Page_TextOut(page_, points(left), height_ - points(baseline), words.c_str());
    HPDF_Page_EndText(page_);
  }

private:
  static HPDF_REAL points(double millimeters) {
    return static_cast<HPDF_REAL>(millimeters * kPointsPerMillimeter);
  }

  HPDF_Page page_;
  HPDF_Font font_;
  HPDF_REAL height_;
};

void drawSquares(Pen& pen, const BoardDescription& board, const Layout& layout) {
  for (const auto& dark : darkParts(board)) {
    pen.rectangle(layout.left + dark.left, layout.top + dark.top, dark.width, dark.height);
  }
  pen.fill(); // all at once: no hairlines between neighbors
}

void drawFoot(Pen& pen, double pageWidth, double pageHeight, const std::string& text) {
  const double bar = std::min(kScaleBarMm, std::floor((pageWidth - 2 * kMarginMm) / 10) * 10);
  const double line = pageHeight - kMarginMm - kTextMm;
  const double top = line - kTextMm - 5.5;
  for (double at = 0.0; at < bar; at += 20.0) {
    pen.rectangle(kMarginMm, top, bar, 0.25);
    pen.rectangle(kMarginMm, top + 2.75, bar, 0.25);
    pen.rectangle(kMarginMm + at, top, std::min(10.0, bar - at), 3.0);
  }
  pen.rectangle(kMarginMm + bar - 0.25, top, 0.25, 3.0);
  pen.fill();
  pen.text(kMarginMm + bar + 3.0, top + 2.8,
           fmt::format("{:.0f} mm: print at 100 %, then check with a ruler", bar));
  pen.text(kMarginMm, line, text);
}

/// Marks on all sides of a sheet: where it is cut, and where the cut edge of a neighbor lies.
void drawMarks(Pen& pen, const BoardSheets& sheets, int column, int row) {
  constexpr double kGap = 1.0;
  constexpr double kLength = 3.5;
  constexpr double kThickness = 0.2;
  const double right = sheets.printedLeft + sheets.partWidth;
  const double bottom = sheets.printedTop + sheets.partHeight;
  const auto down = [&](double x) {
    pen.rectangle(x - 0.5 * kThickness, sheets.printedTop - kGap - kLength, kThickness, kLength);
    pen.rectangle(x - 0.5 * kThickness, bottom + kGap, kThickness, kLength);
  };
  const auto across = [&](double y) {
    pen.rectangle(sheets.printedLeft - kGap - kLength, y - 0.5 * kThickness, kLength, kThickness);
    pen.rectangle(right + kGap, y - 0.5 * kThickness, kLength, kThickness);
  };
  if (column > 0) {
    down(sheets.printedLeft);
  }
  if (column + 1 < sheets.columnCount) {
    down(right - BoardSheets::kOverlapMm);
  }
  if (row > 0) {
    across(sheets.printedTop);
  }
  if (row + 1 < sheets.rowCount) {
    across(bottom - BoardSheets::kOverlapMm);
  }
  pen.fill();
}

void drawFrame(Pen& pen, double left, double top, double width, double height) {
  constexpr double kThickness = 0.2;
  pen.rectangle(left, top, width, kThickness);
  pen.rectangle(left, top + height - kThickness, width, kThickness);
  pen.rectangle(left, top, kThickness, height);
  pen.rectangle(left + width - kThickness, top, kThickness, height);
}

/// The number of a sheet, row by row.
int sheetNumber(const BoardSheets& sheets, int column, int row) {
  return row * sheets.columnCount + column + 1;
}

/// A small picture of the board, with the sheets on it, and how to put them together.
void drawPlan(Pen& pen, HPDF_Page page, const BoardDescription& board, const BoardSheets& sheets) {
  constexpr double kTextHeight = 32.0;
  const double wholeWidth =
      sheets.partLeft(sheets.columnCount - 1) + sheets.partWidth - sheets.partLeft(0);
  const double wholeHeight =
      sheets.partTop(sheets.rowCount - 1) + sheets.partHeight - sheets.partTop(0);
  const double scale =
      std::min((sheets.pageWidth - 2.0 * kMarginMm) / wholeWidth,
               (sheets.pageHeight - 2.0 * kMarginMm - kTextHeight - kFootMm) / wholeHeight);
  const double top = kMarginMm + kTextHeight;
  const auto x = [&](double onBoard) { return kMarginMm + scale * (onBoard - sheets.partLeft(0)); };
  const auto y = [&](double onBoard) { return top + scale * (onBoard - sheets.partTop(0)); };
  HPDF_Page_SetGrayFill(page, 0.8F);
  for (const auto& dark : darkParts(board)) {
    pen.rectangle(x(dark.left), y(dark.top), scale * dark.width, scale * dark.height);
  }
  pen.fill();
  HPDF_Page_SetGrayFill(page, 0.0F);
  for (int row = 0; row < sheets.rowCount; ++row) {
    for (int column = 0; column < sheets.columnCount; ++column) {
      drawFrame(pen, x(sheets.partLeft(column)), y(sheets.partTop(row)), scale * sheets.partWidth,
                scale * sheets.partHeight);
    }
  }
  pen.fill();
  for (int row = 0; row < sheets.rowCount; ++row) {
    for (int column = 0; column < sheets.columnCount; ++column) {
      pen.text(x(sheets.partLeft(column)) + 0.5 * scale * sheets.partWidth,
               y(sheets.partTop(row)) + 0.5 * scale * sheets.partHeight,
               fmt::format("{}", sheetNumber(sheets, column, row)));
    }
  }
  const double size = inMillimeters(board.squareSize);
  double line = kMarginMm + kTextMm;
  for (const std::string& text :
       {fmt::format("The board is split on {} sheets, in the order of the drawing.",
                    sheets.sheetCount()),
        std::string("Print them at 100 %. Cut off the left and the upper edge of a sheet along the "
                    "marks, if it has marks there."),
        std::string("Glue it onto its neighbor, so that the cut edge lies on the neighbor's marks "
                    "and the pattern continues."),
        fmt::format("Glue all sheets to something stiff and flat. The squares then measure {:.1f} "
                    "x {:.1f} mm in all: check this with a ruler.",
                    size * board.squareColumns(), size * board.squareRows())}) {
    pen.text(kMarginMm, line, text);
    line += 1.6 * kTextMm;
  }
  drawFoot(pen, sheets.pageWidth, sheets.pageHeight, boardText(board));
}

/// A PDF that grows page by page.
class PdfPages {
public:
  explicit PdfPages(const std::string& title) : document_(HPDF_New(onError, nullptr)) {
    if (document_ == nullptr) {
      throw std::runtime_error("no memory");
    }
    HPDF_SetInfoAttr(document_.get(), HPDF_INFO_TITLE, title.c_str());
    HPDF_SetCompressionMode(document_.get(), HPDF_COMP_ALL);
  }

  /// Adds a page of a size in millimeters, to be drawn on in black.
  HPDF_Page add(double width, double height) {
    const HPDF_Page page = HPDF_AddPage(document_.get());
    HPDF_Page_SetWidth(page, static_cast<HPDF_REAL>(width * kPointsPerMillimeter));
    HPDF_Page_SetHeight(page, static_cast<HPDF_REAL>(height * kPointsPerMillimeter));
    HPDF_Page_SetGrayFill(page, 0.0F);
    return page;
  }
  Pen penFor(HPDF_Page page) const {
    return {page, HPDF_GetFont(document_.get(), "Helvetica", nullptr)};
  }
  std::string bytes() const {
    HPDF_SaveToStream(document_.get());
    std::string all(HPDF_GetStreamSize(document_.get()), '\0');
    auto size = static_cast<HPDF_UINT32>(all.size());
    HPDF_ReadFromStream(document_.get(), reinterpret_cast<HPDF_BYTE*>(all.data()), &size);
    all.resize(size);
    return all;
  }

private:
  Document document_;
};

std::string pdfOf(const BoardDescription& board, const Layout& layout) {
  PdfPages pages(boardText(board));
  Pen pen = pages.penFor(pages.add(layout.pageWidth, layout.pageHeight));
  drawSquares(pen, board, layout);
  drawFoot(pen, layout.pageWidth, layout.pageHeight, boardText(board));
  return pages.bytes();
}

std::string pdfOf(const BoardDescription& board, const BoardSheets& sheets) {
  PdfPages pages(boardText(board));
  const HPDF_Page plan = pages.add(sheets.pageWidth, sheets.pageHeight);
  Pen planPen = pages.penFor(plan);
  drawPlan(planPen, plan, board, sheets);
  const auto dark = darkParts(board);
  for (int row = 0; row < sheets.rowCount; ++row) {
    for (int column = 0; column < sheets.columnCount; ++column) {
      Pen pen = pages.penFor(pages.add(sheets.pageWidth, sheets.pageHeight));
      for (const auto& part : rectanglesOnSheet(sheets, column, row, dark)) {
        pen.rectangle(part.left, part.top, part.width, part.height);
      }
      pen.fill();
      drawMarks(pen, sheets, column, row);
      drawFoot(pen, sheets.pageWidth, sheets.pageHeight,
               fmt::format("Sheet {} of {} (row {}, column {}): {}",
                           sheetNumber(sheets, column, row), sheets.sheetCount(), row + 1,
                           column + 1, boardText(board)));
    }
  }
  return pages.bytes();
}

} // namespace

const std::vector<Paper>& papers() {
  static const std::vector<Paper> kPapers = {
      {"A4", 210.0, 297.0}, {"A3", 297.0, 420.0}, {"letter", 215.9, 279.4}};
  return kPapers;
}

Result<Paper> paperNamed(const std::string& name, const std::string& field) {
  for (const Paper& paper : papers()) {
    if (toLowerCase(paper.name) == toLowerCase(name)) {
      return paper;
    }
  }
  return failure(ErrorCode::BadValue, "", field,
                 fmt::format("'{}' is not a known paper size; use A4, A3 or letter", name));
}

Status printBoard(const BoardDescription& board, const Paper& paper,
                  const std::filesystem::path& file) {
  try {
    if (const auto layout = layoutOf(board, paper)) {
      return writeTextFile(file, pdfOf(board, *layout));
    }
    return splitOnSheets(board, paper, borderOf(board)).and_then([&](const BoardSheets& sheets) {
      return writeTextFile(file, pdfOf(board, sheets));
    });
  } catch (const std::runtime_error& problem) {
    return failure(ErrorCode::FileUnwritable, file.string(), "", problem.what());
  }
}

Result<int> countSheetsToPrint(const BoardDescription& board, const Paper& paper) {
  if (layoutOf(board, paper)) {
    return 1;
  }
  return splitOnSheets(board, paper, borderOf(board)).map([](const BoardSheets& sheets) {
    return sheets.sheetCount();
  });
}

} // namespace dewpoint::calibration
