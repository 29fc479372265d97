// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/board/board_print.h"

#include "core/base/lower_case.h"
#include "core/base/text_file.h"
#include "core/base/units.h"
#include "core/calibration/board/board_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <hpdf.h>
#include <memory>
#include <stdexcept>

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

Result<Layout> layoutOf(const BoardDescription& board, const Paper& paper) {
  const double squares[] = {static_cast<double>(board.squareColumns()),
                            static_cast<double>(board.squareRows())};
  const double size = inMillimeters(board.squareSize);
  double largest = 0.0;
  for (const bool lengthwise : {squares[0] > squares[1], squares[0] <= squares[1]}) {
    Layout layout;
    layout.pageWidth = lengthwise ? paper.height : paper.width;
    layout.pageHeight = lengthwise ? paper.width : paper.height;
    const double room[] = {layout.pageWidth - 2.0 * kMarginMm,
                           layout.pageHeight - 2.0 * kMarginMm - kFootMm};
    largest = std::max(largest, std::min(room[0] / squares[0], room[1] / squares[1]));
    if (size * squares[0] <= room[0] && size * squares[1] <= room[1]) {
      layout.left = 0.5 * (layout.pageWidth - size * squares[0]);
      layout.top = kMarginMm + 0.5 * (room[1] - size * squares[1]);
      return layout;
    }
  }
  return failure(
      ErrorCode::BadValue, "", "paper",
      fmt::format(
          "the board of {:.0f} x {:.0f} mm does not fit on {}; with squares of {} m, it would fit",
          size * squares[0], size * squares[1], paper.name, fromMillimeters(std::floor(largest))));
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
  const double width = inMillimeters(board.squareSize) * board.squareColumns();
  const double height = inMillimeters(board.squareSize) * board.squareRows();
  if (board.inverted) { // the border that is white on other boards
    const double border = std::min(kMarginMm, 500.0 * board.squareSize);
    pen.rectangle(layout.left - border, layout.top - border, width + 2.0 * border, border);
    pen.rectangle(layout.left - border, layout.top + height, width + 2.0 * border, border);
    pen.rectangle(layout.left - border, layout.top, border, height);
    pen.rectangle(layout.left + width, layout.top, border, height);
  }
  for (const auto& dark : BoardPattern(board).darkRectangles()) {
    pen.rectangle(layout.left + inMillimeters(dark.left), layout.top + inMillimeters(dark.top),
                  inMillimeters(dark.width), inMillimeters(dark.height));
  }
  pen.fill(); // all at once: no hairlines between neighbors
}

void drawFoot(Pen& pen, const BoardDescription& board, const Layout& layout) {
  const double bar =
      std::min(kScaleBarMm, std::floor((layout.pageWidth - 2 * kMarginMm) / 10) * 10);
  const double line = layout.pageHeight - kMarginMm - kTextMm;
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
  pen.text(kMarginMm, line, boardText(board));
}

std::string pdfOf(const BoardDescription& board, const Layout& layout) {
  const Document document(HPDF_New(onError, nullptr));
  if (document == nullptr) {
    throw std::runtime_error("no memory");
  }
  HPDF_SetInfoAttr(document.get(), HPDF_INFO_TITLE, boardText(board).c_str());
  HPDF_SetCompressionMode(document.get(), HPDF_COMP_ALL);
  const HPDF_Page page = HPDF_AddPage(document.get());
  HPDF_Page_SetWidth(page, static_cast<HPDF_REAL>(layout.pageWidth * kPointsPerMillimeter));
  HPDF_Page_SetHeight(page, static_cast<HPDF_REAL>(layout.pageHeight * kPointsPerMillimeter));
  Pen pen(page, HPDF_GetFont(document.get(), "Helvetica", nullptr));
  HPDF_Page_SetGrayFill(page, 0.0F);
  drawSquares(pen, board, layout);
  drawFoot(pen, board, layout);
  HPDF_SaveToStream(document.get());
  std::string bytes(HPDF_GetStreamSize(document.get()), '\0');
  auto size = static_cast<HPDF_UINT32>(bytes.size());
  HPDF_ReadFromStream(document.get(), reinterpret_cast<HPDF_BYTE*>(bytes.data()), &size);
  bytes.resize(size);
  return bytes;
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
  const auto layout = layoutOf(board, paper);
  if (!layout) {
    return tl::make_unexpected(layout.error());
  }
  try {
    return writeTextFile(file, pdfOf(board, *layout));
  } catch (const std::runtime_error& problem) {
    return failure(ErrorCode::FileUnwritable, file.string(), "", problem.what());
  }
}

} // namespace dewpoint::calibration
