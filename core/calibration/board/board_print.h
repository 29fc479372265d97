// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/board/board.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A sheet of paper in portrait orientation, in millimeters.
struct Paper {
  std::string name;
  double width = 0.0;
  double height = 0.0;
};

/// Supported papers: A4, A3 and letter.
const std::vector<Paper>& papers();

/// Paper by name, case-insensitive. BadValue names `field` and the supported papers.
Result<Paper> paperNamed(const std::string& name, const std::string& field = "--paper");

/// Writes the board at its true size to a PDF of one page, with a scale bar for checking the print
/// with a ruler, and the text that parseBoard() reads. The page is portrait or landscape, whichever
/// fits. Errors: BadValue when the board does not fit the paper (with the largest square that
/// would), FileUnwritable.
Status printBoard(const BoardDescription& board, const Paper& paper,
                  const std::filesystem::path& file);

} // namespace dewpoint::calibration
