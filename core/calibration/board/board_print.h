// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/board/board.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Paper size in portrait orientation, in millimeters.
struct Paper {
  std::string name;
  double width = 0.0;
  double height = 0.0;
};

/// Returns the supported papers: A4, A3 and letter.
const std::vector<Paper>& papers();

/// Returns the paper with a name, ignoring case. Error: BadValue, which names `field` and lists the
/// supported papers.
Result<Paper> paperNamed(const std::string& name, const std::string& field = "--paper");

/// Writes the board at its true size to a PDF. Each page includes a scale bar for checking the
/// print with a ruler, and the board description that parseBoard() reads. If the board fits on the
/// paper, the PDF has one page, in portrait or landscape format. Otherwise, the first page is a
/// plan of the sheets on which the board is split (see BoardSheets), and a page for each sheet
/// follows, with marks for cutting and gluing. Errors: BadValue if more than 64 sheets would be
/// needed; FileUnwritable.
Status printBoard(const BoardDescription& board, const Paper& paper,
                  const std::filesystem::path& file);

/// Returns the number of sheets into which printBoard() splits a board, not counting the page with
/// the plan; 1 if the board fits on the paper. Error: BadValue if more than 64 sheets would be
/// needed.
Result<int> countSheetsToPrint(const BoardDescription& board, const Paper& paper);

} // namespace dewpoint::calibration
