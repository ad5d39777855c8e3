// SPDX-License-Identifier: Apache-2.0
// What the tests of analysis share: matrices of the usual places.
#pragma once

#include <solidsubdiv/kit/analysis/place_report.h>
#include <solidsubdiv/kit/analysis/places.h>

namespace SolidSubdiv::Analysis {

inline Far::LocalMatrix RegularMatrix(const Sdc::Scheme& scheme) { return MatrixOf(RegularStar(scheme), scheme); }
inline Far::LocalMatrix EdgeMatrix(const Sdc::Scheme& scheme, int n) { return MatrixOf(EdgeStar(scheme, n), scheme); }

}  // namespace SolidSubdiv::Analysis
