// SPDX-License-Identifier: Apache-2.0
// Sparse rows as a Matrix Market file (coordinate real general, counted from 1).
#pragma once

#include <filesystem>

#include <solidsubdiv/far/stencil_table.h>
#include <solidsubdiv/sdc/progress.h>

namespace SolidSubdiv::Cli {

/// Weights are written as the shortest text that reads back as the same number. @throws IoError, Cancelled
void WriteMatrixMarket(const std::filesystem::path& path, const Far::StencilRows<double>& rows,
                       const Progress& progress);

}  // namespace SolidSubdiv::Cli
